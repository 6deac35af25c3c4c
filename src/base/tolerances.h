// Every tolerance has a name, a unit and a reason, and is passed in.
#pragma once

namespace clearcut::inline base {

/// mm. Rounding error of double arithmetic on coordinates of a metre, with a safety factor: smaller differences have
/// no meaning.
inline constexpr double kRoundingMm = 1e-9;

/// mm. Places, heights and sizes that differ by less are the same one: below the last digit of any file or control,
/// above the rounding errors of reading, rotating and translating coordinates.
inline constexpr double kSamePlaceMm = 1e-6;

/// Radians. Directions that differ by less are the same one: after a metre they are a micrometre apart.
inline constexpr double kSameAngleRad = 1e-6;

struct Tolerances {
  /// mm. Two points nearer than this are one point. Below the resolution of any controller (0.1 um printed).
  double coincident = 1e-7;
  /// mm. Chord error of arcs of which only topology matters (sites of the Voronoi diagram), as long as the topology
  /// can be proven to equal that of the exact arcs.
  double topology_chord = 0.05;
  /// mm. Largest distance between a curve handed to a library as a polygon and that polygon.
  double chord = 0.0002;
  /// mm. A cutter that is wider than a gap by no more than this is taken to fit it exactly.
  double fit = 0.001;
  /// mm. Gaps in outlines up to this are closed, and reported.
  double join_gap = 0.01;
  /// mm. Uncut material thinner than this is not a fault (proven bound of the certificate).
  double uncut = 0.01;
  /// mm. Gouges shallower than this are not a fault.
  double gouge = 0.001;
  /// mm, square to the wall. Scallop height that layers may leave on walls with draft if no scallop is requested: the
  /// same thickness as the stock left for a finishing cut of floors.
  double scallop = 0.2;
};

}  // namespace clearcut::inline base
