#include "plan/contour_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clearcut {
namespace {

/// mm. A point this much nearer than the radius to an edge is inside its swept area, not on the rim.
constexpr double kRim = 1e-7;
/// mm. A point on the border of two cells is found in both.
constexpr double kBorder = 1e-6;
/// Of a square of side 1, a little more.
constexpr double kHalfDiagonal = 0.7072;
/// Squares with more curves are quartered, so often.
constexpr std::size_t kFewCurves = 16;
constexpr int kMostQuarterings = 5;

}  // namespace

Cover::Cover(std::span<const Edge> edges, double radius)
    : edges_(edges.begin(), edges.end()), radius_(radius) {
  Box box;
  for (const auto& edge : edges_) box.add(edge.box());
  if (box.empty()) return;
  box = box.grown(2 * radius);
  const double most_cells = 4.0 * static_cast<double>(edges_.size()) + 64;
  grid_ = CellGrid(box, std::max(radius / 2, std::sqrt(box.width() * box.height() / most_cells)));
  sort_edges();
}

Cover::Cover(std::span<const Edge> edges, std::shared_ptr<const Cover> base)
    : base_(std::move(base)),
      edges_(edges.begin(), edges.end()),
      radius_(base_->radius_),
      grid_(base_->grid_) {
  sort_edges();
}

void Cover::sort_edges() {
  for (const Edge& e : edges_) {
    const Vec2 along = e.to - e.from;
    const Box box = e.box();
    strokes_.push_back({e.from, along, e.is_arc() ? -1 : norm_squared(along), (box.min + box.max) / 2.0,
                        norm(box.max - box.min) / 2});
  }
  const double half_diagonal = grid_.cell * kHalfDiagonal;
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    grid_.for_cells(edges_[i].box().grown(radius_), [&](std::size_t cell, Vec2 center) {
      if (is_within(i, center, radius_ + half_diagonal)) edges_in_.add(cell, i);
    });
  }
  edges_in_.build(grid_.count());
}

bool Cover::is_within(std::uint32_t edge, Vec2 p, double reach) const {
  const Stroke& stroke = strokes_[edge];
  const Vec2 s = p - stroke.from;
  if (stroke.whole < 0) {
    // Most arcs are short beside the cutter: their ends, or a disc around them, tell.
    const double most = reach * reach, far = reach + stroke.reach;
    if (reach > 0 && (norm_squared(s) <= most || norm_squared(s - stroke.along) <= most)) return true;
    if (norm_squared(p - stroke.middle) > far * far) return false;
    return distance(edges_[edge], p) <= reach;
  }
  const double along = dot(s, stroke.along);
  if (along <= 0) return norm_squared(s) <= reach * reach;
  if (along >= stroke.whole) return norm_squared(s - stroke.along) <= reach * reach;
  const double c = cross(stroke.along, s);
  return c * c <= reach * reach * stroke.whole;
}

double Cover::squared_distance(std::uint32_t edge, Vec2 p) const {
  const Stroke& stroke = strokes_[edge];
  if (stroke.whole < 0) {
    const double d = distance(edges_[edge], p);
    return d * d;
  }
  const Vec2 s = p - stroke.from;
  const double along = dot(s, stroke.along);
  if (along <= 0) return norm_squared(s);
  if (along >= stroke.whole) return norm_squared(s - stroke.along);
  const double c = cross(stroke.along, s);
  return c * c / stroke.whole;
}

bool Cover::own_edge_holds(Vec2 p, std::size_t cell, double reach) const {
  const auto near = edges_in_.at(cell);
  return std::any_of(near.begin(), near.end(), [&](std::uint32_t i) { return is_within(i, p, reach); });
}

bool Cover::holds(Vec2 p, double slack) const {
  if (grid_.box.empty() || !grid_.box.contains(p)) return false;
  const std::size_t cell = grid_.cell_of(p);
  return own_edge_holds(p, cell, radius_ - slack) ||
         (base_ && base_->own_edge_holds(p, cell, radius_ - slack));
}

double Cover::distance_to(Vec2 p) const {
  double best = std::numeric_limits<double>::infinity();
  if (grid_.box.empty() || !grid_.box.contains(p)) return best;
  for (const Cover* cover : {this, base_.get()}) {
    if (!cover) continue;
    for (const std::uint32_t i : cover->edges_in_.at(grid_.cell_of(p))) {
      best = std::min(best, cover->squared_distance(i, p));
    }
  }
  return std::sqrt(best);
}

bool Cover::passes(const Curve& curve, Vec2 center, double reach) {
  const double off = curve.circle ? std::abs(std::sqrt(norm_squared(center - curve.a)) - curve.radius)
                                  : std::abs(cross(curve.direction, center - curve.a));
  return off <= reach;
}

void Cover::add_curve(const Curve& curve, Rims& rims) const {
  const double half_diagonal = grid_.cell * kHalfDiagonal + kBorder;
  const auto number = static_cast<std::uint32_t>(rims.curves.size());
  rims.curves.push_back(curve);
  grid_.for_cells(curve.box, [&](std::size_t cell, Vec2 center) {
    if (passes(curve, center, half_diagonal)) rims.in.add(cell, number);
  });
}

Cover::Rims Cover::rims() const {
  Rims rims;
  const auto add_circle = [&](Vec2 center, double r, const Box& box) {
    if (r > kRim) add_curve({true, center, {}, r, box.grown(kBorder)}, rims);
  };
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Edge& e = edges_[i];
    const Box around = e.box().grown(radius_);
    if (e.is_arc()) {
      add_circle(e.center, e.radius() + radius_, around);
      add_circle(e.center, e.radius() - radius_, around);
    } else {
      const Vec2 u = unit(e.to - e.from), n = left_of(u) * radius_;
      for (const Vec2 side : {n, -n}) {
        Box box;
        box.add(e.from + side);
        box.add(e.to + side);
        add_curve({false, e.from + side, u, 0, box.grown(kBorder)}, rims);
      }
    }
    const bool joined = i > 0 && edges_[i - 1].to == e.from;
    if (!joined) add_circle(e.from, radius_, Box{e.from, e.from}.grown(radius_));
    if (joined) add_joint(edges_[i - 1], e, rims);
    const bool goes_on = i + 1 < edges_.size() && edges_[i + 1].from == e.to;
    if (!goes_on) add_circle(e.to, radius_, Box{e.to, e.to}.grown(radius_));
    for (const double t : {0.0, 1.0}) {
      const Vec2 n = left_of(e.tangent_at(t)) * radius_, p = t == 0 ? e.from : e.to;
      rims.joints.push_back(p + n);
      rims.joints.push_back(p - n);
    }
  }
  rims.in.build(grid_.count());
  return rims;
}

/// The circle about the joint of two edges is a rim only between their normals, on the outer side of the
/// turn.
void Cover::add_joint(const Edge& before, const Edge& after, Rims& rims) const {
  const Vec2 in = before.tangent_at(1), out = after.tangent_at(0), p = after.from;
  const double turn = cross(in, out);
  Box box = Box{p, p}.grown(radius_);
  if (dot(in, out) > 0) {
    if (std::abs(turn) < 1e-12) return;
    // Less than a quarter: the arc lies within its sagitta of the chord.
    const double side = turn > 0 ? -radius_ : radius_;
    const Vec2 a = p + left_of(in) * side, b = p + left_of(out) * side;
    box = {};
    box.add(a);
    box.add(b);
    box = box.grown(0.3 * norm(b - a));
  }
  add_curve({true, p, {}, radius_, box.grown(kBorder)}, rims);
}

void Cover::add_meetings(const Curve& p, const Curve& q, std::vector<Vec2>& out) {
  if (!p.circle && !q.circle) {
    const double det = cross(p.direction, q.direction);
    if (std::abs(det) < 1e-9) return;
    out.push_back(p.a + p.direction * (cross(q.a - p.a, q.direction) / det));
  } else if (p.circle != q.circle) {
    const Curve& line = p.circle ? q : p;
    const Curve& circle = p.circle ? p : q;
    const Vec2 foot = line.a + line.direction * dot(circle.a - line.a, line.direction);
    const double h2 = circle.radius * circle.radius - norm_squared(foot - circle.a);
    if (h2 < -1e-9) return;
    const Vec2 half = line.direction * std::sqrt(std::max(0.0, h2));
    out.push_back(foot + half);
    out.push_back(foot - half);
  } else {
    const Vec2 between = q.a - p.a;
    const double d = norm(between);
    if (d < 1e-9) return;
    const double x = 0.5 * (d + (p.radius - q.radius) * (p.radius + q.radius) / d);
    const double y2 = p.radius * p.radius - x * x;
    if (y2 < -1e-9) return;
    const Vec2 foot = p.a + between * (x / d), side = left_of(between / d) * std::sqrt(std::max(0.0, y2));
    out.push_back(foot + side);
    out.push_back(foot - side);
  }
}

/// Calls found(place) until it returns true.
template <typename Found>
void Cover::search(const Box& where, const std::function<bool(Vec2)>& matters, const Found& found) const {
  if (grid_.box.empty()) return;
  const Rims own = rims();
  // What holds one meeting often holds the next.
  std::uint32_t last = 0;
  const auto is_hole = [&](Vec2 p) {
    if (last < edges_.size() && is_within(last, p, radius_ - kRim)) return false;
    const auto near = edges_in_.at(grid_.cell_of(p));
    const auto holder = std::find_if(near.begin(), near.end(),
                                     [&](std::uint32_t i) { return is_within(i, p, radius_ - kRim); });
    if (holder != near.end()) {
      last = *holder;
      return false;
    }
    return !(base_ && base_->own_edge_holds(p, grid_.cell_of(p), radius_ - kRim)) && matters(p);
  };
  for (const Vec2 p : own.joints)
    if (is_hole(p) && found(p)) return;
  if (base_) {
    for (const Vec2 p : base_->rim_)
      if (is_hole(p) && found(p)) return;
  }
  std::vector<Vec2> meetings;
  // Each meeting is looked at in its own square alone.
  const auto meet = [&](const Curve& p, const Curve& q, const auto& is_own) {
    if (!p.box.overlaps(q.box)) return false;
    meetings.clear();
    add_meetings(p, q, meetings);
    return std::any_of(meetings.begin(), meetings.end(), [&](Vec2 m) {
      return is_own(m) && p.box.contains(m) && q.box.contains(m) && is_hole(m) && found(m);
    });
  };
  bool ended = false;
  const auto meet_all = [&](std::span<const std::uint32_t> here, const auto& is_own) {
    for (std::size_t i = 0; i < here.size() && !ended; ++i) {
      for (std::size_t j = i + 1; j < here.size() && !ended; ++j)
        ended = meet(own.curves[here[i]], own.curves[here[j]], is_own);
    }
  };
  grid_.for_cells(where, [&](std::size_t cell, Vec2 center) {
    const auto in_cell = [&](Vec2 m) { return grid_.cell_of(m) == cell; };
    const auto here = own.in.at(cell);
    if (!base_)
      return quarter({center, grid_.cell / 2, cell, 0}, here, own, [&](const Square& square, auto curves) {
        meet_all(curves, [&](Vec2 m) { return in_cell(m) && square.holds(m); });
      });
    meet_all(here, in_cell);
    for (const std::uint32_t i : here) {
      for (const std::uint32_t j : base_->own_rims_.in.at(cell))
        ended = ended || meet(own.curves[i], base_->own_rims_.curves[j], in_cell);
    }
  });
}

/// Calls f with the parts of a square that few curves pass through, but for those that one edge holds whole.
template <typename F>
void Cover::quarter(const Square& square, std::span<const std::uint32_t> curves, const Rims& rims,
                    const F& f) const {
  if (curves.size() <= kFewCurves || square.depth == kMostQuarterings) return f(square, curves);
  const double half = square.half / 2, reach = 2 * half * kHalfDiagonal + kBorder;
  const auto near = edges_in_.at(square.cell);
  std::vector<std::uint32_t> passing;
  for (const Vec2 corner : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{1, 1}}) {
    const Square part{square.center + corner * half, half, square.cell, square.depth + 1};
    const double whole = radius_ - kRim - reach;
    const bool held = whole > 0 && std::any_of(near.begin(), near.end(), [&](std::uint32_t i) {
                        return is_within(i, part.center, whole);
                      });
    if (held) continue;
    passing.clear();
    const Box box = Box{part.center, part.center}.grown(half + kBorder);
    for (const std::uint32_t i : curves) {
      const Curve& curve = rims.curves[i];
      if (curve.box.overlaps(box) && passes(curve, part.center, reach)) passing.push_back(i);
    }
    quarter(part, passing, rims, f);
  }
}

std::vector<Vec2> Cover::holes(const std::function<bool(Vec2)>& matters) const {
  std::vector<Vec2> found;
  search(grid_.box, matters, [&](Vec2 p) {
    found.push_back(p);
    return false;
  });
  return found;
}

bool Cover::has_hole(const Box& where, const std::function<bool(Vec2)>& matters) const {
  bool any = false;
  search(where, matters, [&](Vec2) { return any = true; });
  return any;
}

void Cover::keep_rim(const std::function<bool(Vec2)>& matters) {
  rim_ = holes(matters);
  own_rims_ = rims();
}

}  // namespace clearcut
