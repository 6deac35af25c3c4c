#include "options/value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"

namespace clearcut::inline options {
namespace {

constexpr int kShownDigits = 9;
constexpr std::size_t kLongestWord = 40;

/// Letters to insert, remove, change or swap with the next.
std::size_t steps_between(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> steps(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t k = 0; k <= b.size(); ++k) {
      if (i == 0 || k == 0) {
        steps[i][k] = i + k;
        continue;
      }
      const std::size_t change = steps[i - 1][k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1);
      steps[i][k] = std::min({steps[i - 1][k] + 1, steps[i][k - 1] + 1, change});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
        steps[i][k] = std::min(steps[i][k], steps[i - 2][k - 2] + 1);
    }
  }
  return steps.back().back();
}

std::string with_unit(double number, const std::string& unit) {
  return trimmed(number, kShownDigits) + (unit.empty() ? "" : " " + unit);
}

}  // namespace

bool takes_several(ValueKind kind) {
  return kind == ValueKind::kTexts || kind == ValueKind::kFiles || kind == ValueKind::kPoints;
}

bool is_number(ValueKind kind) {
  return kind == ValueKind::kLength || kind == ValueKind::kFeed || kind == ValueKind::kNumber ||
         kind == ValueKind::kWhole;
}

std::string beyond_range(double value, const Range& range, const std::string& unit) {
  const bool low = range.above_least ? !(value > range.least) : !(value >= range.least);
  if (!low && value <= range.most) return "";
  const bool has_most = range.most < kLongestLength;
  if (range.above_least && has_most)
    return fmt::format("must be above {} and at most {}", trimmed(range.least, kShownDigits),
                       with_unit(range.most, unit));
  if (has_most)
    return fmt::format("must lie between {} and {}", trimmed(range.least, kShownDigits),
                       with_unit(range.most, unit));
  if (low && range.above_least) return "must be above " + with_unit(range.least, unit);
  if (low && range.least > -kLongestLength)
    return fmt::format("must be {} or more", with_unit(range.least, unit));
  return "is farther from zero than " + with_unit(range.most, unit);
}

/// Up to a third of the letters may differ, or `word` must be the beginning of only one name.
std::string nearest_name(const std::string& word, const std::vector<std::string>& names) {
  const std::string asked = word.substr(0, kLongestWord);
  std::string best;
  std::size_t least = asked.size() / 3 + 2;
  for (const auto& name : names) {
    const std::size_t steps = steps_between(asked, name);
    if (steps >= least) continue;
    least = steps;
    best = name;
  }
  if (!best.empty()) return best;
  for (const auto& name : names) {
    if (asked.size() > 3 && name.starts_with(asked)) return name;
  }
  return "";
}

}  // namespace clearcut::inline options
