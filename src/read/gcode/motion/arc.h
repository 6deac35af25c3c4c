// Arcs as programs say them, made into exact edges.
#pragma once

#include <string>
#include <vector>

#include "geometry/edge.h"

namespace clearcut::read::gcode {

/// An arc or several turns in one plane, as given: the radii at its ends may differ a little.
struct ArcShape {
  Vec2 from;
  Vec2 to;
  Vec2 center;
  Turn turn = Turn::kCounterClockwise;
  double sweep = 0;  ///< radians, > 0 whichever way it turns; equal ends give whole turns
};

/// Largest difference of the radii at the two ends that controls take (LinuxCNC, Grbl): `tight`, or a
/// thousandth of the radius up to `loose`. mm.
struct RadiusRule {
  double tight = 0.005;
  double loose = 0.5;
};

/// `turns`: the P word, 1 for an arc of at most one turn. Throws InputError(place, ...) when the ends do not
/// lie on one circle about `center` within `rule`.
ArcShape arc_about(Vec2 from, Vec2 to, Vec2 center, Turn turn, int turns, const RadiusRule& rule,
                   const std::string& place);
/// R form: the shorter arc for radius > 0, the longer for radius < 0.
ArcShape arc_of_radius(Vec2 from, Vec2 to, double radius, Turn turn, const RadiusRule& rule,
                       const std::string& place);

/// Edges of less than a full turn that join exactly, each on a circle through both its ends; the first begins
/// at shape.from and the last ends at shape.to. All sweep the same angle. Error   where the radii agree
/// within 1 um: that difference; else the spiral between them within 0.6 % of it.
std::vector<Edge> arc_edges(const ArcShape& shape);

}  // namespace clearcut::read::gcode
