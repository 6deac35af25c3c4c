// How far a machine may leave the programmed path before the part suffers: what verify/margin.h finds.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/results/findings.h"

namespace clearcut::inline model {

/// What may be left and what may be cut too much, mm.
struct MarginBounds {
  double uncut = Tolerances{}.uncut;
  double gouge = Tolerances{}.gouge;
};

/// A margin that is asked for.
struct MarginRule {
  double at_least = 0;  ///< mm; 0: it is to be found alone
  MarginBounds bounds;

  /// mm; a control may run arcs of printed digits by so much off.
  static constexpr double kArcs = 0.0012;
  /// mm; stock that a plan leaves on walls and floors so that a path that far off cuts no deeper than the bound.
  double stock() const { return at_least > 0 ? std::max(0.0, at_least - bounds.gouge + kArcs) : 0; }
};

/// What a path that lies farther off does first.
enum class MarginLimit : unsigned char { kUncut, kGouge };

inline const char* name_of(MarginLimit limit) {
  return limit == MarginLimit::kUncut ? "uncut" : "gouge";
}

struct FeatureMargin {
  std::string feature;
  double mm = 0;  ///< 0: the program itself reaches the bound
  MarginLimit limit = MarginLimit::kUncut;
  std::optional<Place> at = {};  ///< where that is; absent where the bound alone is what limits
};

struct Margin {
  MarginBounds bounds;
  std::vector<FeatureMargin> features = {};
  std::vector<std::string> not_asked =
      {};  ///< features whose shapes it is not found for: leaning walls, chamfers, carvings, threads

  /// That of the feature with the smallest; null where none has one.
  const FeatureMargin* least() const {
    const auto found = std::min_element(features.begin(), features.end(),
                                        [](const auto& a, const auto& b) { return a.mm < b.mm; });
    return found == features.end() ? nullptr : &*found;
  }
};

}  // namespace clearcut::inline model
