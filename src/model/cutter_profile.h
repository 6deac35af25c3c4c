// The true profile of a cutter: a body of revolution about its axis.
#pragma once

#include "model/tool.h"

namespace clearcut::inline model {

/// A radius that grows with the height over the tip: a flat, then a rounding or a flank, then upright at the widest. mm.
///
/// Between two points of the surface the profile is never hollow, and it never becomes narrower upwards: a cutter that goes
/// straight up touches nothing new.
struct CutterProfile {
  double flat = 0;    ///< radius of the flat at the tip; 0: a point; below 0: the point was narrowed away
  double round = 0;   ///< radius of the rounding beside the flat; 0: none
  double slope = 0;   ///< of the flank beside the flat: mm sideways for each mm of height; 0: none
  double widest = 0;  ///< greatest radius; 0: nothing

  static CutterProfile cylinder(double radius) { return {radius, 0, 0, radius}; }

  bool is_cylinder() const { return flat >= widest; }
  /// Radius at `height` mm over the tip; below 0 where there is nothing.
  double radius_at(double height) const;
  /// mm over the tip at which the surface is `distance` mm from the axis; infinite beyond the widest.
  double height_at(double distance) const;
  /// mm over the tip from which on it is as wide as it gets.
  double full_height() const { return height_at(widest); }
  /// A profile whose surface lies `by` mm nearer to the axis.
  CutterProfile narrowed(double by) const;

  bool operator==(const CutterProfile&) const = default;
};

/// A bound from outside: no part of the cutter, its shank apart, stands beyond it.
CutterProfile outer_profile(const Tool& tool);

/// A bound from inside: what stood in it, and over it, is gone where the cutter was. Nothing of tools that cut a thread or an
/// undercut, which leave material inside or above, and of cones whose angle nobody states.
CutterProfile inner_profile(const Tool& tool);

/// mm; radius to which the passes of a plan clear all round wherever the tool's centre may be, `above` mm over their lowest tips. Passes of
/// balls are planned as those of flat ends: below their full width ridges stand between them.
double radius_cleared(const Tool& tool, double above);

/// mm; radius with which the cutter's end leaves a floor flat; 0: it has none.
double flat_end(const Tool& tool);

}  // namespace clearcut::inline model
