#include "verify/coverage/wall_residual.h"

#include <algorithm>

#include "base/tolerances.h"
#include "verify/coverage/swath_cover.h"

namespace clearcut::verify {
namespace {}  // namespace

WallResidual::WallResidual(const CoverageQuestion& question) : question_(question) {
  if (question.allowance <= 0) return;
  const Box near = box(*question.target).grown(question.allowance);
  for (const Wall& outline : question.part->outlines_beyond()) {
    if (outline.stands_at(question.z) && outline.edge.box().overlaps(near)) beyond_.push_back(outline);
  }
}

bool WallResidual::holds(Vec2 p) const {
  if (!may_be()) return false;
  const double draft = question_.part->greatest_draft_offset();
  bool found = false;
  const std::vector<Wall>& walls = question_.part->walls();
  question_.part->wall_tree().nearest(p, question_.allowance + draft, [&](int i) {
    found = found || (walls[i].stands_at(question_.z) &&
                      distance(walls[i].edge, p) <
                          question_.allowance + question_.part->draft_offset(walls[i], question_.z, p));
    return false;
  });
  return found || std::any_of(beyond_.begin(), beyond_.end(), [&](const Wall& outline) {
           return distance(outline.edge, p) < question_.allowance;
         });
}

bool WallResidual::holds_on_one_wall(const ConvexPolygon& polygon, Vec2 center, double reach) const {
  const double greatest = question_.allowance + question_.part->greatest_draft_offset();
  const std::vector<Wall>& walls = question_.part->walls();
  bool found = false;
  question_.part->wall_tree().nearest(center, greatest, [&](int i) {
    found = found || (walls[i].stands_at(question_.z) && wall_holds(walls[i], polygon, center, reach));
    return false;
  });
  return found || std::any_of(beyond_.begin(), beyond_.end(), [&](const Wall& outline) {
           return wall_holds(outline, polygon, center, reach);
         });
}

bool WallResidual::wall_holds(const Wall& wall, const ConvexPolygon& polygon, Vec2 center,
                              double reach) const {
  const double residual = question_.allowance + wall.draft_offset(question_.z);
  if (wall.edge.is_arc()) {
    if (distance(wall.edge, center) + reach > residual) return false;
  } else if (excess_over(polygon, {wall.edge, residual}) > kRoundingMm) {
    return false;
  }
  const std::vector<Edge> ends = wall.flat_ends(question_.z);
  return std::all_of(ends.begin(), ends.end(), [&](const Edge& end) {
    const Vec2 outward = left_of(end.tangent_at(0));
    return std::all_of(polygon.points().begin(), polygon.points().end(),
                       [&](Vec2 p) { return dot(p - end.from, outward) <= kRoundingMm; });
  });
}

}  // namespace clearcut::verify
