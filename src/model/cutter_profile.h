// The true profile of a cutter: a body of revolution about its axis.
#pragma once

#include "model/tool.h"

namespace clearcut::inline model {

/// A cutter's radius as a function of the height over the tip: a flat, then a rounding or a flank, then a cylinder of
/// the greatest radius. mm.
///
/// Between two points of the surface the profile is never hollow, and the radius never decreases upwards: a cutter
/// moving straight up touches no further material.
struct CutterProfile {
  double flat = 0;    ///< radius of the flat at the tip; 0: a point; below 0: the point was narrowed away
  double round = 0;   ///< radius of the rounding beside the flat; 0: none
  double slope = 0;   ///< slope of the flank beside the flat: mm sideways for each mm of height; 0: none
  double widest = 0;  ///< greatest radius; 0: nothing

  static CutterProfile cylinder(double radius) { return {radius, 0, 0, radius}; }

  bool is_cylinder() const { return flat >= widest; }
  /// Radius at `height` mm over the tip; below 0 at heights without a part of the cutter.
  double radius_at(double height) const;
  /// mm over the tip at which the surface is `distance` mm from the axis; infinite beyond the greatest radius.
  double height_at(double distance) const;
  /// mm over the tip at which the radius reaches its greatest value.
  double full_height() const { return height_at(widest); }
  /// This profile with its surface `by` mm nearer to the axis.
  CutterProfile narrowed(double by) const;

  bool operator==(const CutterProfile&) const = default;
};

/// A bound from outside: no part of the cutter except its shank is outside of this profile.
CutterProfile outer_profile(const Tool& tool);

/// A bound from inside: material within this profile, and above it, is removed wherever the cutter was. An empty
/// profile for tools cutting a thread or an undercut, since they leave material inside or above, and for cones
/// without a stated angle.
CutterProfile inner_profile(const Tool& tool);

/// mm; radius around every permitted position of the tool's centre that the passes of a plan clear, `above` mm over
/// the lowest tips. Passes of ball mills are planned like those of flat ends: below the ball's full width, ridges
/// remain between them.
double radius_cleared(const Tool& tool, double above);

/// mm; radius of the flat part of the cutter's end; 0: there is no flat part.
double flat_end(const Tool& tool);

}  // namespace clearcut::inline model
