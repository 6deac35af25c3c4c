#include "post/words/print_grid.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "base/error.h"
#include "base/units.h"

namespace clearcut::post {

namespace {

long long power_of_ten(int exponent) {
  long long power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

}  // namespace

PrintGrid::PrintGrid(bool inch, int decimals)
    : decimals_(decimals),
      per_mm_(static_cast<double>(power_of_ten(decimals)) / (inch ? kMmPerInch : 1.0)),
      step_((inch ? kMmPerInch : 1.0) / static_cast<double>(power_of_ten(decimals))) {}

long long PrintGrid::ticks(double mm) const {
  CLEARCUT_ASSERT(std::abs(mm) <= 2 * kLargest);
  return std::llround(mm * per_mm_);
}

void append_number(std::string& out, long long ticks, int decimals, bool always_point) {
  const unsigned long long size = static_cast<unsigned long long>(ticks < 0 ? -ticks : ticks);
  const unsigned long long one = static_cast<unsigned long long>(power_of_ten(decimals));
  if (ticks < 0) out += '-';
  fmt::format_to(std::back_inserter(out), "{}", size / one);
  const unsigned long long fraction = size % one;
  if (fraction == 0) {
    if (always_point) out += '.';
    return;
  }
  fmt::format_to(std::back_inserter(out), ".{:0{}}", fraction, decimals);
  out.erase(out.find_last_not_of('0') + 1);
}

std::string signed_number(long long ticks, int decimals) {
  std::string text = ticks >= 0 ? "+" : "";
  append_number(text, ticks, decimals, false);
  return text;
}

}  // namespace clearcut::post
