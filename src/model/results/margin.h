// Allowed deviation of the machine from the programmed path before the part is out of bounds: the result of
// verify/margin.h.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/results/findings.h"

namespace clearcut::inline model {

/// Permitted uncut thickness and gouge depth, mm.
struct MarginBounds {
  double uncut = Tolerances{}.uncut;
  double gouge = Tolerances{}.gouge;
};

/// A requested margin.
struct MarginRule {
  double at_least = 0;  ///< mm; 0: the margin is only computed
  MarginBounds bounds;

  /// mm; a control may run arcs of printed digits by so much off.
  static constexpr double kArcs = 0.0012;
  /// mm; stock left by a plan on walls and floors so that a path with this deviation cuts no deeper than the bound.
  double stock() const { return at_least > 0 ? std::max(0.0, at_least - bounds.gouge + kArcs) : 0; }
};

/// Bound that a path of greater deviation violates first.
enum class MarginLimit : unsigned char { kUncut, kGouge };

inline const char* name_of(MarginLimit limit) {
  return limit == MarginLimit::kUncut ? "uncut" : "gouge";
}

struct FeatureMargin {
  std::string feature;
  double mm = 0;  ///< 0: the program itself reaches the bound
  MarginLimit limit = MarginLimit::kUncut;
  std::optional<Place> at = {};  ///< place of the limit; absent if only the bound itself limits
};

struct Margin {
  MarginBounds bounds;
  std::vector<FeatureMargin> features = {};
  /// Features for whose shapes no margin is computed: inclined walls, chamfers, carvings, threads.
  std::vector<std::string> not_asked = {};

  /// The margin of the feature with the smallest one; null if no feature has a margin.
  const FeatureMargin* least() const {
    const auto found = std::min_element(features.begin(), features.end(),
                                        [](const auto& a, const auto& b) { return a.mm < b.mm; });
    return found == features.end() ? nullptr : &*found;
  }
};

}  // namespace clearcut::inline model
