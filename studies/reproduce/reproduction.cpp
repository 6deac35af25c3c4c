#include "studies/reproduce/reproduction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace clearcut::studies {

const char* name_of(Agreement agreement) {
  if (agreement == Agreement::kAgrees) return "agrees";
  return agreement == Agreement::kExplained ? "explained" : "differs";
}

Cell beside(double ours, double printed, int decimals, const Explanation& explanation) {
  const double off = std::abs(ours - printed);
  const bool same = off < 0.5 * base::pow(10.0, -decimals);
  const bool within = !explanation.reason.empty() && off <= explanation.share * std::abs(printed);
  const Agreement agreement = same     ? Agreement::kAgrees
                              : within ? Agreement::kExplained
                                       : Agreement::kDiffers;
  const std::string reason =
      within ? fmt::format("{} (at most {:g} %)", explanation.reason, 100 * explanation.share)
             : explanation.reason;
  return beside(fmt::format("{:.{}f}", ours, decimals), fmt::format("{:.{}f}", printed, decimals), agreement,
                same ? "" : reason);
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
  if (count(Agreement::kDiffers) > 0) return Agreement::kDiffers;
  return count(Agreement::kExplained) > 0 ? Agreement::kExplained : Agreement::kAgrees;
}

std::string Reproduction::summary() const {
  return fmt::format("{} printed cells: {} agree, {} explained, {} differ", compared.size(),
                     count(Agreement::kAgrees), count(Agreement::kExplained), count(Agreement::kDiffers));
}

double cut_to(double value, int decimals) {
  const double scale = base::pow(10.0, decimals);
  return std::floor(value * scale + 1e-9) / scale;
}

}  // namespace clearcut::studies
