// Computes the lines and circles of which rims of holes in a cover may consist.
#include <cmath>

#include "plan/common/cover.h"

namespace clearcut::plan {

/// The box of the circle's arc within the wedge.
Box Cover::Wedge::arc_box(Vec2 center, double radius) const {
  Box box;
  box.add(center + start * (radius / std::sqrt(norm_squared(start))));
  box.add(center + end * (radius / std::sqrt(norm_squared(end))));
  for (const Vec2 axis : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}})
    if (holds(axis)) box.add(center + axis * radius);
  return box;
}

/// A cheaper, possibly larger box around the same arc; `start` and `end` have unit length.
Box Cover::Wedge::wide_box(Vec2 center, double radius) const {
  if (over_quarter) return Box{center, center}.grown(radius);
  // The arc is within its sagitta of the chord.
  const Vec2 a = center + start * radius, b = center + end * radius;
  Box box;
  box.add(a);
  box.add(b);
  return box.grown(0.3 * norm(b - a));
}

Cover::Rims Cover::rims() const {
  Rims rims;
  rims.curves.reserve(3 * edges_.size());
  rims.joints.reserve(kJoints * edges_.size());
  rims.first.reserve(edges_.size() + 1);
  Vec2 in;  // direction at the end of the edge before
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const Edge& e = edges_[i];
    const Vec2 u = e.tangent_at(0), v = e.is_arc() ? e.tangent_at(1) : u;
    const Vec2 n = left_of(u) * radius_, m = left_of(v) * radius_;
    rims.first.push_back(static_cast<std::uint32_t>(rims.curves.size()));
    add_sides(i, n, rims);
    const bool joined = i > 0 && edges_[i - 1].to == e.from;
    if (!joined) {
      add_circle(e.from, radius_, {n, -n, false, true}, Box{e.from, e.from}.grown(radius_), rims);
    } else if (const auto turn = outer_side(in, u)) {
      add_circle(e.from, radius_, *turn, turn->wide_box(e.from, radius_), rims);
    }
    const bool goes_on = i + 1 < edges_.size() && edges_[i + 1].from == e.to;
    if (!goes_on) add_circle(e.to, radius_, {-m, m, false, true}, Box{e.to, e.to}.grown(radius_), rims);
    for (const Vec2 p : {e.from + n, e.from - n, e.to + m, e.to - m}) rims.joints.push_back(p);
    in = v;
  }
  rims.first.push_back(static_cast<std::uint32_t>(rims.curves.size()));
  return rims;
}

/// Adds the curves on both sides of an edge; `across`: the normal of a line, as long as the radius.
void Cover::add_sides(std::uint32_t edge, Vec2 across, Rims& rims) const {
  const Edge& e = edges_[edge];
  if (e.is_arc()) {
    const double r = e.radius();
    const Box around = e.box().grown(radius_);
    for (const double side : {r + radius_, r - radius_})
      add_circle(e.center, side, strokes_[edge].wedge, around, rims);
    return;
  }
  for (const Vec2 side : {across, -across}) {
    Box box;
    box.add(e.from + side);
    box.add(e.to + side);
    rims.curves.push_back({false, e.from + side, unit(e.to - e.from), 0, box.grown(kBorder)});
  }
}

void Cover::add_circle(Vec2 center, double radius, const Wedge& part, const Box& around, Rims& rims) const {
  if (radius <= kRim) return;
  const Box box = places_ == SearchPlaces::kAtRims ? part.arc_box(center, radius) : around;
  rims.curves.push_back({true, center, {}, radius, box.grown(kBorder)});
}

/// The part of the circle about the joint of two edges possibly forming a rim: between their normals, on the outer
/// side of the turn.
std::optional<Cover::Wedge> Cover::outer_side(Vec2 in, Vec2 out) {
  const double turn = cross(in, out);
  const bool back = dot(in, out) <= 0;
  if (!back && std::abs(turn) < 1e-12) return std::nullopt;
  if (turn > 0) return Wedge{-left_of(in), -left_of(out), false, back};
  return Wedge{left_of(out), left_of(in), false, back};
}

}  // namespace clearcut::plan
