#include "studies/reproduce/reproduction.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace clearcut::studies {

namespace {

/// What an agreement is called, and how a summary counts its cells.
struct AgreementWords {
  Agreement agreement;
  const char* name;
  const char* counted;
};
constexpr AgreementWords kWords[] = {{Agreement::kAgrees, "agrees", "agree"},
                                     {Agreement::kComputed, "computed", "computed"},
                                     {Agreement::kPrinted, "printed", "sums of print"},
                                     {Agreement::kExplained, "explained", "explained"},
                                     {Agreement::kDiffers, "differs", "differ"}};

Cell compared_cell(double ours, double printed, int decimals, const Explanation& explanation,
                   Agreement where_same) {
  const double off = std::abs(ours - printed);
  const bool same = off < 0.5 * base::pow(10.0, -decimals);
  const bool within = !explanation.reason.empty() && off <= explanation.share * std::abs(printed);
  const Agreement agreement = same ? where_same : within ? Agreement::kExplained : Agreement::kDiffers;
  const std::string reason =
      within ? fmt::format("{} (at most {:g} %)", explanation.reason, 100 * explanation.share)
             : explanation.reason;
  return beside(fmt::format("{:.{}f}", ours, decimals), fmt::format("{:.{}f}", printed, decimals), agreement,
                same ? "" : reason);
}

}  // namespace

const char* name_of(Agreement agreement) {
  return kWords[static_cast<std::size_t>(agreement)].name;
}

bool is_same(Agreement agreement) {
  return agreement < Agreement::kExplained;
}

Cell beside(double ours, double printed, int decimals, const Explanation& explanation) {
  return compared_cell(ours, printed, decimals, explanation, Agreement::kAgrees);
}

Cell computed(double ours, double printed, int decimals) {
  return compared_cell(ours, printed, decimals, {}, Agreement::kComputed);
}

Cell of_print(double sum, double printed, int decimals, const Explanation& explanation) {
  return compared_cell(sum, printed, decimals, explanation, Agreement::kPrinted);
}

Cell beside(const std::string& ours, const std::string& printed, Agreement agreement,
            const std::string& reason) {
  Cell cell(agreement == Agreement::kDiffers ? ours + " (differs)" : ours);
  cell.compared.push_back({printed, ours, agreement, reason});
  return cell;
}

void Reproduction::add(const std::vector<Cell>& cells) {
  std::vector<std::string> texts;
  for (const Cell& cell : cells) {
    for (Compared one : cell.compared) {
      one.row = table.rows.size();
      one.column = texts.size();
      compared.push_back(std::move(one));
    }
    texts.push_back(cell.text);
  }
  table.add(std::move(texts));
}

int Reproduction::count(Agreement agreement) const {
  return static_cast<int>(std::count_if(compared.begin(), compared.end(),
                                        [&](const Compared& one) { return one.agreement == agreement; }));
}

Agreement Reproduction::agreement() const {
  Agreement worst = Agreement::kAgrees;
  for (const Compared& one : compared) worst = std::max(worst, one.agreement);
  return worst;
}

std::string Reproduction::summary() const {
  std::vector<std::string> counts;
  for (const AgreementWords& one : kWords)
    counts.push_back(fmt::format("{} {}", count(one.agreement), one.counted));
  return fmt::format("{} printed cells: {}", compared.size(), fmt::join(counts, ", "));
}

double cut_to(double value, int decimals) {
  const double scale = base::pow(10.0, decimals);
  return std::floor(value * scale + 1e-9) / scale;
}

}  // namespace clearcut::studies
