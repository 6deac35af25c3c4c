#include "model/results/not_machined.h"

namespace clearcut::inline model {
namespace {

/// Text between the name and the reason.
const std::string kMark = " is not machined: ";

bool is_not_machined(const Diagnostic& item) {
  return item.severity == Severity::kSkipped && item.what.find(kMark) != std::string::npos;
}

std::string name_in(const Diagnostic& item) {
  return item.what.substr(0, item.what.find(kMark));
}

}  // namespace

void say_not_machined(Diagnostics& diagnostics, const std::string& where, const std::string& name,
                      const std::string& why) {
  diagnostics.skip(where, name + kMark + why);
}

std::vector<std::string> names_not_machined(const Diagnostics& diagnostics) {
  std::vector<std::string> names;
  for (const Diagnostic& item : diagnostics.items()) {
    if (is_not_machined(item)) names.push_back(name_in(item));
  }
  return names;
}

void add_not_machined(const Diagnostics& diagnostics, Findings& findings) {
  std::vector<Fault> faults;
  for (const Diagnostic& item : diagnostics.items()) {
    if (!is_not_machined(item)) continue;
    Fault fault;
    fault.kind = FaultKind::kNothingCut;
    fault.feature = name_in(item);
    fault.text = item.where.empty() ? item.what : item.where + ": " + item.what;
    faults.push_back(std::move(fault));
  }
  if (faults.empty()) return;
  findings.all.clean = false;
  findings.faults.insert(findings.faults.begin(), faults.begin(), faults.end());
}

}  // namespace clearcut::inline model
