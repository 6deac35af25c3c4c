// A connected run of edges of a drawing, and the area covered by a line of some width.
#pragma once

#include <functional>
#include <vector>

#include "geometry/edge.h"
#include "read/common/affine.h"

namespace clearcut::read {

struct Subpath {
  Path edges;
  bool closed = false;  ///< the file declares the subpath as closed
};

enum class StrokeCap { kButt, kRound, kSquare };
enum class StrokeJoin { kMiter, kRound, kBevel };

/// Pen of an SVG line: stroke-width, stroke-linecap, stroke-linejoin, stroke-miterlimit.
struct Pen {
  double width = 1;  ///< in the units of the drawing, > 0
  StrokeCap cap = StrokeCap::kButt;
  StrokeJoin join = StrokeJoin::kMiter;
  double miter_limit = 4;
};

/// Counter-clockwise loops whose union, by the nonzero rule, is the area covered by the pen along the lines: a band
/// for each edge, a wedge or disc at each corner, a cap at each open end. Exact for lines and arcs. Cost O(edges).
/// Source: SVG 1.1, section 11.4.
std::vector<Path> stroke_pieces(const std::vector<Subpath>& lines, const Pen& pen);

/// The same for lines drawn under `map`, which also stretches the pen; `lines(m)` are the lines under the map m. If
/// circles become ellipses, the error is within kCurveTolerance mm.
std::vector<Path> stroke_pieces(const Affine& map, Pen pen,
                                const std::function<std::vector<Subpath>(const Affine&)>& lines);

}  // namespace clearcut::read
