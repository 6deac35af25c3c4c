#include "plan/adaptive/clearing/disc_engagement.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"

namespace clearcut::plan::adaptive {
double widened_circle(double cleared_radius, double tool_radius, double engagement) {
  const double across = tool_radius * base::sin(engagement);
  const double inside = std::max(0.0, cleared_radius * cleared_radius - across * across);
  return -tool_radius * base::cos(engagement) + std::sqrt(inside);
}

}  // namespace clearcut::plan::adaptive
