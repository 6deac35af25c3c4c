#include "read/board/drawn.h"

#include "geometry/contours/boolean.h"
#include "read/common/curve_fit.h"

namespace clearcut::read {
namespace {

Path mapped(const Path& path, const Affine& map, bool as_loop) {
  Path out;
  for (const Edge& edge : map.mirrors() && as_loop ? reversed(path) : path)
    append_mapped(edge, map, kCurveTolerance, out);
  return out;
}

}  // namespace

Drawn mapped(const Drawn& drawn, const Affine& map) {
  Drawn out{drawn.dark, {}, mapped(drawn.line, map, false)};
  for (const Path& piece : drawn.pieces) out.pieces.push_back(mapped(piece, map, true));
  return out;
}

Regions dark_area(const std::vector<Drawn>& drawn, const RepairOptions& options) {
  Diagnostics crossings;  // overlapping items are no mistake
  Regions dark;
  for (std::size_t i = 0; i < drawn.size();) {
    const bool adds = drawn[i].dark;
    std::vector<RawCurve> curves;
    for (; i < drawn.size() && drawn[i].dark == adds; ++i)
      for (const Path& piece : drawn[i].pieces)
        curves.push_back({piece, true, "what is drawn", Compound{0, true}});
    if (curves.empty() || (!adds && dark.empty())) continue;
    const Regions area = repair(std::move(curves), options, crossings);
    dark = dark.empty() ? area : adds ? unite(dark, area, options.tol) : subtract(dark, area, options.tol);
  }
  return dark;
}

}  // namespace clearcut::read
