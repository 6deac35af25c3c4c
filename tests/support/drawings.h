// Drawings with the faults of published ones, made here: what readers must mend and strategies must clear.
#pragma once

#include <string>

namespace clearcut::test_support {

/// DXF without units: the outline of a gear with 12 teeth 28 mm across, each line drawn apart with its ends 0.0001 mm off,
/// and a bore of 8 mm in 8 arcs.
std::string gear_with_gaps_dxf();

/// DXF in mm, one closed polyline: a T-slot profile 20 mm wide with necks of 3 mm, and a round hole.
std::string narrow_necks_dxf();

/// DXF without units, old polylines that end where they begin without being marked closed: 4 x 3 squares of 100 mm.
std::string old_polylines_dxf();

/// DXF in mm: an outline 120 x 60 mm with arcs of more than half a circle, outward and inward, and two islands.
std::string bulges_dxf();

/// SVG in mm: 5 x 4 squares of 10 mm that touch at their corners, as one path.
std::string touching_squares_svg();

/// SVG without units: a wavy outline of 60 curves, as tracing makes them.
std::string traced_svg();

}  // namespace clearcut::test_support
