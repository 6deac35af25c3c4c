// How a cutter with a rounded end touches a wall that leans.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/elementary.h"
#include "base/units.h"
#include "features/derived_outlines.h"

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

  /// mm by which the end keeps farther off a wall with a fillet of radius `fillet` at its foot than off one without, its tip `above` mm
  /// over the floor. The middle of the rounding may lie on an arc about the fillet's own, which ends on the normal of the wall: the more
  /// the wall leans, the lower, and the nearer to the foot is the fillet's end on the floor.
  double clear_of_fillet(double fillet, double above) const {
    const RoundOnWall between{fillet - round, draft};
    const double over = std::max(0.0, above);
    if (between.round * (1 - base::sin(draft)) <= over) return 0;
    return features::clear_of_fillet(fillet, round, over) - (between.round - between.beside()) +
           over * base::tan(draft);
  }

 private:
  /// Share of the height that a flat end may take.
  static constexpr double kLeastStep = 0.1;
};

}  // namespace clearcut::plan
