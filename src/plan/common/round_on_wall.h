// How a cutter with a rounded end touches a wall that leans.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/elementary.h"
#include "base/units.h"

namespace clearcut::plan {

struct RoundOnWall {
  double round = 0;  ///< mm; radius of the rounding
  double draft = 0;  ///< radians by which the wall leans

  /// mm that the wall at the height of the tip lies beside the middle of the rounding: as much as the round itself at upright walls.
  double beside() const { return round * (1 - base::sin(draft)) / base::cos(draft); }

  /// mm of height along which no more than `left` mm stand off the wall, square to it. Square to the wall the end at an angle of
  /// d to where it touches leaves round (1 - cos d); above the rounding its side leaves the more the higher.
  double height_within(double left) const {
    const double wide = base::acos(std::max(-1.0, 1 - left / round));
    const double low = round - round * base::sin(std::min(kPi / 2, draft + wide));
    const double side = round + (left - round * (1 - base::cos(draft))) / base::sin(draft);
    return (wide < draft ? round - round * base::sin(draft - wide) : side) - low;
  }

  /// The same of an end that keeps off the wall as if it were flat: it comes nearest at some height over the tip, below which the
  /// next layer cuts. Absent where no height worth a layer is small enough.
  std::optional<double> height_kept_off(double left) const {
    const double flat = left / base::sin(draft), less = flat - round * (1 - base::sin(draft));
    return less > kLeastStep * flat ? std::optional(less) : std::nullopt;
  }

 private:
  /// Share of the height that a flat end may take.
  static constexpr double kLeastStep = 0.1;
};

}  // namespace clearcut::plan
