#include "pipeline/steps/wear.h"

#include <algorithm>

#include "base/error.h"
#include "base/text/format.h"

namespace clearcut::pipeline {

namespace {

/// mm, where nothing is said.
constexpr double kUsualWearRange = 0.1;

bool is_known(const std::vector<Fault>& faults, const Fault& fault) {
  return std::any_of(faults.begin(), faults.end(), [&](const Fault& other) {
    return other.kind == fault.kind && other.feature == fault.feature;
  });
}

bool counts(const Fault& fault, const WearQuestion& question) {
  if (fault.kind == FaultKind::kUncut && fault.size <= 2 * question.range + question.uncut) return false;
  return question.features.empty() || fault.feature.empty() || question.features.contains(fault.feature);
}

}  // namespace

Part worn(Part part, const std::vector<int>& numbers, double wear) {
  for (Tool& tool : part.tools)
    if (std::find(numbers.begin(), numbers.end(), tool.number) != numbers.end()) tool.diameter += 2 * wear;
  return part;
}

double wear_range_of(const ShopOptions& shop) {
  return shop.wear_range.value_or(kUsualWearRange);
}

std::set<std::string> compensated_features(const Part& part, const WearCompensation& wear) {
  std::set<std::string> names;
  for (const int step : wear.workingsteps)
    names.insert(feature_of(part, part.workplan[static_cast<std::size_t>(step)]).name);
  return names;
}

void check_wear(Findings& findings, const WearQuestion& question,
                const std::function<Findings(double)>& found_at) {
  if (question.tools.empty()) return;
  findings.wear = WearFindings{question.range, question.tools};
  const std::vector<Fault> known = findings.faults;
  for (const double wear : {-question.range, question.range}) {
    const std::string end = "with " + trimmed(wear, 4) + " mm in D and cutters as much off their size: ";
    Findings found;
    try {
      found = found_at(wear);
    } catch (const InputError& error) {
      throw InputError("--wear-range", end + error.what() + "; give a smaller range");
    }
    for (Fault fault : found.faults) {
      if (!counts(fault, question) || is_known(known, fault)) continue;
      fault.text = end + fault.text;
      findings.faults.push_back(std::move(fault));
    }
  }
  findings.all.clean = findings.faults.empty();
}

}  // namespace clearcut::pipeline
