#include "verify/coverage/laid_cover.h"

#include <algorithm>

#include "base/units.h"
#include "geometry/box.h"
#include "model/part.h"
#include "verify/part/edge_tree.h"
#include "verify/part/finished_part.h"

namespace clearcut::verify {
namespace {

/// The region as a pocket down to z = 0: what is to be covered is what would be milled, and what lies outside is wall.
Part pocket_of(const Regions& region) {
  Part part;
  Feature feature;
  feature.target = region;
  feature.allowed = region;
  feature.top_z = 1;
  part.features.push_back(feature);
  return part;
}

void find_outside(const LaidQuestion& question, LaidCover& found) {
  const EdgeTree boundary(question.region);
  const double radius = question.width / 2;
  const auto note = [&found](double beyond, Vec2 at) {
    if (beyond <= found.outside_mm) return;
    found.outside_mm = beyond;
    found.outside_at = at;
  };
  for (const Path& line : question.lines) {
    for (const Edge& edge : line) {
      if (boundary.winding(edge.from) == 0) note(boundary.nearest(edge.from).distance + radius, edge.from);
      boundary.overlapping(edge.box().grown(radius),
                           [&](int i) { note(radius - distance(boundary.edges()[i], edge), edge.from); });
    }
  }
}

}  // namespace

LaidCover laid_cover_of(const LaidQuestion& question, const Tolerances& tol) {
  const double radius = question.width / 2;
  const FinishedPart finished(pocket_of(question.region));
  CoverageQuestion asked;
  asked.part = &finished;
  asked.target = &question.region;
  asked.radius = asked.flat = radius;
  LaidCover found;
  for (const Path& line : question.lines) {
    found.laid_mm += length(line);
    for (const Edge& edge : line) asked.swaths.push_back({edge, radius});
  }
  found.cover = coverage_of(asked, tol);
  found.covered_mm2 = found.cover.target_mm2 - found.cover.unreachable_mm2 -
                      std::min(found.cover.uncut_mm2, found.cover.target_mm2);
  const double swept =
      static_cast<double>(question.lines.size()) * kPi * radius * radius + question.width * found.laid_mm;
  found.over_mm2 = std::max(0.0, swept - std::max(0.0, found.covered_mm2));
  find_outside(question, found);
  return found;
}

}  // namespace clearcut::verify
