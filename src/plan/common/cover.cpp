#include "plan/common/cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/work_budget.h"
#include "geometry/contours/boolean.h"
#include "geometry/route/legal_area.h"

namespace clearcut::plan {
namespace {

/// Half the diagonal of a square of side 1, rounded up.
constexpr double kHalfDiagonal = 0.7072;
/// A square with more curves than this is quartered, up to the depth below.
constexpr std::size_t kFewCurves = 24;
constexpr int kMostQuarterings = 5;

/// Far above the rounding of a squared distance, as a share of it.
constexpr double kSquareRounding = 1e-12;

/// Number of pairs of curves whose intersection counts as one step of the WorkBudget.
constexpr std::uint64_t kPairsPerStep = 64;

bool is_between(double v, double least, double most) {
  return v >= least && v <= most;
}

/// Whether two circles surely do not meet, by the square of their centres' distance and the sum of their radii.
bool is_apart(double squared, double reach) {
  return squared > reach * reach * (1 + 1e-6) + 1e-6;
}

}  // namespace

Cover::Stroke::Stroke(const Edge& edge) : from(edge.from), to(edge.to), along(edge.to - edge.from) {
  whole = norm_squared(along);
  if (!edge.is_arc()) return;
  whole = -1;
  center = edge.center;
  const bool ccw = edge.turn == Turn::kCounterClockwise;
  const Vec2 start = (ccw ? from : to) - center, end = (ccw ? to : from) - center;
  wedge = {start, end, cross(start, ccw ? along : -along) < 0, dot(start, end) <= 0};
  radius = std::sqrt(0.5 * (norm_squared(start) + norm_squared(end)));
}

/// Whether the direction v is in the wedge.
bool Cover::Wedge::holds(Vec2 v) const {
  const bool after_start = cross(start, v) >= 0, before_end = cross(v, end) >= 0;
  if (over_half) return after_start || before_end;
  return after_start && before_end && (over_quarter || dot(start, v) >= 0);
}

double Cover::Stroke::squared_distance(Vec2 p) const {
  const Vec2 s = p - from;
  if (whole < 0) {
    const Vec2 v = p - center;
    if (!wedge.holds(v)) return std::min(norm_squared(s), norm_squared(p - to));
    const double off = std::sqrt(norm_squared(v)) - radius;
    return off * off;
  }
  const double t = dot(s, along);
  if (t <= 0) return norm_squared(s);
  if (t >= whole) return norm_squared(s - along);
  const double c = cross(along, s);
  return c * c / whole;
}

bool Cover::Stroke::is_within(Vec2 p, double most) const {
  const double square = most * most;
  if (whole < 0) return squared_distance(p) <= square;
  const Vec2 s = p - from;
  const double t = dot(s, along);
  if (t <= 0) return norm_squared(s) <= square;
  if (t >= whole) return norm_squared(s - along) <= square;
  const double c = cross(along, s);
  return c * c <= square * whole;
}

Cover::Cover(std::span<const Edge> edges, double radius, SearchPlaces places)
    : edges_(edges.begin(), edges.end()), radius_(radius), places_(places) {
  Box box;
  for (const auto& edge : edges_) box.add(edge.box());
  if (box.empty()) return;
  grid_ = grid_over(box.grown(2 * radius), radius, edges_.size());
  sort_edges();
}

Cover::Cover(std::span<const Edge> edges, double radius, const Box& where)
    : edges_(edges.begin(), edges.end()),
      radius_(radius),
      places_(SearchPlaces::kAroundRims),
      grid_(grid_over(where, radius, edges.size())),
      is_clipped_(true) {
  sort_edges();
}

CellGrid Cover::grid_over(const Box& box, double radius, std::size_t edges) {
  const double most_cells = 4.0 * static_cast<double>(edges) + 64;
  return {box, std::max(radius / 2, std::sqrt(box.width() * box.height() / most_cells))};
}

Cover::Cover(std::span<const Edge> edges, std::shared_ptr<const Cover> base)
    : base_(std::move(base)),
      edges_(edges.begin(), edges.end()),
      radius_(base_->radius_),
      places_(base_->places_),
      grid_(base_->grid_) {
  sort_edges();
}

void Cover::sort_edges() {
  WorkBudget::spend(edges_.size());
  strokes_.reserve(edges_.size());
  whole_.assign(grid_.count(), 0);
  const double half_diagonal = grid_.cell * kHalfDiagonal;
  const double far = (radius_ + half_diagonal) * (radius_ + half_diagonal);
  const double deep = radius_ - kRim - half_diagonal, whole = deep > 0 ? deep * deep : -1;
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const Stroke& stroke = strokes_.emplace_back(edges_[i]);
    grid_.for_cells(edges_[i].box().grown(radius_), [&](std::size_t cell, Vec2 center) {
      const double d = stroke.squared_distance(center);
      if (d <= far) edges_in_.add(cell, i);
      if (d <= whole) whole_[cell] = 1;
    });
  }
  edges_in_.build(grid_.count());
}

bool Cover::own_edge_holds(Vec2 p, std::size_t cell, double reach) const {
  const auto near = edges_in_.at(cell);
  return std::any_of(near.begin(), near.end(),
                     [&](std::uint32_t i) { return strokes_[i].is_within(p, reach); });
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
      best = std::min(best, cover->strokes_[i].squared_distance(p));
    }
  }
  return std::sqrt(best);
}

std::optional<double> Cover::distance_above(double least, Vec2 p) const {
  double best = std::numeric_limits<double>::infinity();
  if (grid_.box.empty() || !grid_.box.contains(p)) return best;
  const double surely_less = (1 - kSquareRounding) * least * least;
  for (const Cover* cover : {this, base_.get()}) {
    if (!cover) continue;
    for (const std::uint32_t i : cover->edges_in_.at(grid_.cell_of(p))) {
      const double d = cover->strokes_[i].squared_distance(p);
      if (d < surely_less) return std::nullopt;
      best = std::min(best, d);
    }
  }
  best = std::sqrt(best);
  return best > least ? std::optional(best) : std::nullopt;
}

/// The search for uncleared points, square by square.
class Cover::Search {
 public:
  /// Ends with the first point if `first` is set.
  Search(const Cover& cover, const Rims& rims, const std::function<bool(Vec2)>& matters, bool first)
      : cover_(cover),
        base_(cover.base_.get()),
        rims_(rims),
        matters_(matters),
        first_(first),
        own_strokes_(static_cast<std::uint32_t>(cover.edges_.size())),
        own_curves_(static_cast<std::uint32_t>(rims.curves.size())) {}

  /// The points in a fixed order: beside the ends of edges, then places left by the base, then intersections of
  /// curves; within each kind by edge, curve and cell.
  std::vector<Vec2> run(const Box& where) {
    std::vector<Vec2> left_by_base;
    if (base_) left_by_base = base_->rim_;
    std::erase_if(left_by_base, [&](Vec2 p) {
      return cover_.own_edge_holds(p, cover_.grid_.cell_of(p), cover_.radius_ - kRim) || !matters_(p);
    });
    cover_.grid_.for_cells(where, [&](std::size_t cell, Vec2) { check_cell(cell); });
    std::sort(at_joints_.begin(), at_joints_.end());
    std::sort(at_meetings_.begin(), at_meetings_.end());
    std::vector<Vec2> all;
    for (const Found& found : at_joints_) all.push_back(found.place);
    all.insert(all.end(), left_by_base.begin(), left_by_base.end());
    for (const Found& found : at_meetings_) all.push_back(found.place);
    return all;
  }

 private:
  /// A point with the numbers of its edge, curve and cell, by which the result is ordered.
  struct Found {
    std::array<std::uint32_t, 5> by{};
    Vec2 place;
    bool operator<(const Found& other) const { return by < other.by; }
  };
  /// A square of the grid: column and row counted in squares of a side of cell / 2^depth.
  struct Square {
    std::size_t column = 0, row = 0;
    int depth = 0;
  };
  /// Place of a square: `reach` is the distance from its centre to a corner, mm.
  struct Place {
    Vec2 center;
    double reach = 0;
    Box box;
  };
  /// A range of indices into strokes_, curves_ or joints_.
  struct Range {
    std::size_t from = 0, to = 0;
    std::size_t size() const { return to - from; }
  };
  struct Near {
    Range strokes, curves, joints;
  };

  const Stroke& stroke(std::uint32_t i) const {
    return i < own_strokes_ ? cover_.strokes_[i] : base_->strokes_[i - own_strokes_];
  }
  const Curve& curve(std::uint32_t i) const {
    return i < own_curves_ ? rims_.curves[i] : base_->own_rims_.curves[i - own_curves_];
  }

  /// Whether p belongs to `square`. A point on a common side belongs to only one of the two squares.
  bool holds(const Square& square, Vec2 p) const {
    const CellGrid& grid = cover_.grid_;
    if (cover_.is_clipped_ && !grid.box.contains(p)) return false;
    constexpr double kParts = 1 << kMostQuarterings;
    const auto number = [&](double v, std::size_t cells) {
      const double parts = v / grid.cell * kParts;
      return static_cast<std::size_t>(std::clamp(parts, 0.0, static_cast<double>(cells) * kParts - 1)) >>
             (kMostQuarterings - square.depth);
    };
    return number(p.x - grid.box.min.x, grid.columns) == square.column &&
           number(p.y - grid.box.min.y, grid.rows) == square.row;
  }

  void check_cell(std::size_t cell) {
    if (has_ended() || cover_.whole_[cell] || (base_ && base_->whole_[cell])) return;
    const auto own = cover_.edges_in_.at(cell);
    if (own.empty()) return;
    cell_ = static_cast<std::uint32_t>(cell);
    strokes_.assign(own.begin(), own.end());
    curves_.clear();
    joints_.clear();
    const Square square{cell % cover_.grid_.columns, cell / cover_.grid_.columns, 0};
    const Place place = place_of(square);
    for (const std::uint32_t i : own) {
      add_curves(rims_, i, 0, place);
      for (std::uint32_t k = kJoints * i; k < kJoints * (i + 1); ++k)
        if (holds(square, rims_.joints[k])) joints_.push_back(k);
    }
    if (base_ && !(curves_.empty() && joints_.empty())) {
      for (const std::uint32_t i : base_->edges_in_.at(cell)) {
        strokes_.push_back(own_strokes_ + i);
        add_curves(base_->own_rims_, i, own_curves_, place);
      }
    }
    WorkBudget::spend((strokes_.size() + curves_.size()) / kPairsPerStep);
    search_inside(square, {{0, strokes_.size()}, {0, curves_.size()}, {0, joints_.size()}});
  }

  /// Adds the curves of one edge that pass near `place`; `first` is the number of the first curve of `rims`.
  void add_curves(const Rims& rims, std::uint32_t edge, std::uint32_t first, const Place& place) {
    for (std::uint32_t c = rims.first[edge]; c < rims.first[edge + 1]; ++c)
      if (comes_near(rims.curves[c], place)) curves_.push_back(first + c);
  }

  /// Searches a part of a square; `around` holds the items near the whole square.
  void search(const Square& square, const Near& around) {
    const Place place = place_of(square);
    Near near;
    if (keep_strokes(place.center, place.reach, around.strokes, near.strokes)) {
      near.curves = keep_curves(place, around.curves);
      near.joints = keep_joints(square, around.joints);
      search_inside(square, near);
      joints_.resize(near.joints.from);
      curves_.resize(near.curves.from);
    }
    strokes_.resize(near.strokes.from);
  }

  void search_inside(const Square& square, const Near& near) {
    const bool can_meet = near.curves.size() > 1 && curves_[near.curves.from] < own_curves_;
    if (can_meet && near.curves.size() > kFewCurves && square.depth < kMostQuarterings) {
      for (std::size_t k = 0; k < 4 && !has_ended(); ++k)
        search({2 * square.column + (k & 1), 2 * square.row + (k >> 1), square.depth + 1}, near);
    } else {
      for (std::size_t i = near.joints.from; i < near.joints.to; ++i) check_joint(joints_[i], near.strokes);
      if (can_meet) meet_all(square, near);
    }
  }

  Place place_of(const Square& square) const {
    const double side = cover_.grid_.cell / (1 << square.depth);
    const Vec2 middle{static_cast<double>(square.column) + 0.5, static_cast<double>(square.row) + 0.5};
    const Vec2 center = cover_.grid_.box.min + middle * side;
    return {center, side * kHalfDiagonal + kBorder, Box{center, center}.grown(side / 2 + kBorder)};
  }

  /// Keeps the strokes clearing a point within `reach` of the centre. False if one of them clears all points within
  /// `reach`.
  bool keep_strokes(Vec2 center, double reach, const Range& around, Range& near) {
    const double most = cover_.radius_ + reach, far = most * most;
    const double deep = cover_.radius_ - kRim - reach, whole = deep > 0 ? deep * deep : -1;
    near.from = strokes_.size();
    for (std::size_t i = around.from; i < around.to; ++i) {
      const double d = stroke(strokes_[i]).squared_distance(center);
      if (d <= whole) return false;
      if (d <= far) strokes_.push_back(strokes_[i]);
    }
    near.to = strokes_.size();
    return true;
  }

  Range keep_curves(const Place& place, const Range& around) {
    const std::size_t from = curves_.size();
    for (std::size_t i = around.from; i < around.to; ++i) {
      if (comes_near(curve(curves_[i]), place)) curves_.push_back(curves_[i]);
    }
    return {from, curves_.size()};
  }

  Range keep_joints(const Square& square, const Range& around) {
    const std::size_t from = joints_.size();
    for (std::size_t i = around.from; i < around.to; ++i) {
      if (holds(square, rims_.joints[joints_[i]])) joints_.push_back(joints_[i]);
    }
    return {from, joints_.size()};
  }

  static bool comes_near(const Curve& curve, const Place& place) {
    if (!curve.box.overlaps(place.box)) return false;
    if (!curve.circle) return std::abs(cross(curve.direction, place.center - curve.a)) <= place.reach;
    const double least = std::max(0.0, curve.radius - place.reach), most = curve.radius + place.reach;
    return is_between(norm_squared(place.center - curve.a), least * least, most * most);
  }

  void check_joint(std::uint32_t joint, const Range& near) {
    const Vec2 p = rims_.joints[joint];
    if (is_hole(p, near)) at_joints_.push_back({{joint}, p});
  }

  void meet_all(const Square& square, const Near& near) {
    WorkBudget::spend(near.curves.size() * near.curves.size() / kPairsPerStep);
    for (std::size_t i = near.curves.from; i < near.curves.to && curves_[i] < own_curves_; ++i) {
      for (std::size_t j = i + 1; j < near.curves.to && !has_ended(); ++j)
        meet(curves_[i], curves_[j], square, near.strokes);
    }
  }

  /// Tests the intersections of two curves, if they belong to `square`, so that no point is tested twice.
  void meet(std::uint32_t i, std::uint32_t j, const Square& square, const Range& near) {
    const Curve &p = curve(i), &q = curve(j);
    if (!p.box.overlaps(q.box)) return;
    std::array<Vec2, 2> places;
    const std::uint32_t count = meetings(p, q, places);
    for (std::uint32_t k = 0; k < count; ++k) {
      const Vec2 m = places[k];
      if (!p.box.contains(m) || !q.box.contains(m) || !holds(square, m) || !is_hole(m, near)) continue;
      at_meetings_.push_back({{cell_, j < own_curves_ ? 0U : 1U, i, j, k}, m});
    }
  }

  static std::uint32_t meetings(const Curve& p, const Curve& q, std::array<Vec2, 2>& out) {
    if (!p.circle && !q.circle) {
      const double det = cross(p.direction, q.direction);
      if (std::abs(det) < 1e-9) return 0;
      out[0] = p.a + p.direction * (cross(q.a - p.a, q.direction) / det);
      return 1;
    }
    Vec2 foot, side;
    if (p.circle != q.circle) {
      const Curve& line = p.circle ? q : p;
      const Curve& circle = p.circle ? p : q;
      foot = line.a + line.direction * dot(circle.a - line.a, line.direction);
      const double h2 = circle.radius * circle.radius - norm_squared(foot - circle.a);
      if (h2 < -1e-9) return 0;
      side = line.direction * std::sqrt(std::max(0.0, h2));
    } else {
      const Vec2 between = q.a - p.a;
      if (is_apart(norm_squared(between), p.radius + q.radius)) return 0;
      const double d = norm(between);
      if (d < 1e-9) return 0;
      const double x = 0.5 * (d + (p.radius - q.radius) * (p.radius + q.radius) / d);
      const double y2 = p.radius * p.radius - x * x;
      if (y2 < -1e-9) return 0;
      foot = p.a + between * (x / d);
      side = left_of(between / d) * std::sqrt(std::max(0.0, y2));
    }
    out = {foot + side, foot - side};
    return 2;
  }

  bool is_hole(Vec2 p, const Range& near) {
    const double reach = cover_.radius_ - kRim;
    // Neighbouring points are often cleared by the same edge: the last one is asked first.
    if (last_ < near.to && last_ >= near.from && stroke(strokes_[last_]).is_within(p, reach)) return false;
    for (std::size_t i = near.from; i < near.to; ++i) {
      if (!stroke(strokes_[i]).is_within(p, reach)) continue;
      last_ = i;
      return false;
    }
    return matters_(p);
  }

  bool has_ended() const { return first_ && !(at_joints_.empty() && at_meetings_.empty()); }

  const Cover& cover_;
  const Cover* base_;
  const Rims& rims_;
  const std::function<bool(Vec2)>& matters_;
  bool first_;
  // Lower numbers mean strokes and curves of the cover itself, higher ones those of its base.
  std::uint32_t own_strokes_, own_curves_;
  // Stacks of numbers: the items near a square are pushed after the items near the square around it.
  std::vector<std::uint32_t> strokes_, curves_, joints_;
  std::uint32_t cell_ = 0;
  std::size_t last_ = 0;
  std::vector<Found> at_joints_, at_meetings_;
};

std::vector<Vec2> Cover::holes(const std::function<bool(Vec2)>& matters) const {
  if (grid_.box.empty()) return {};
  const Rims own = rims();
  return Search(*this, own, matters, false).run(grid_.box);
}

bool Cover::has_hole(const Box& where, const std::function<bool(Vec2)>& matters) const {
  if (grid_.box.empty()) return false;
  const Rims own = rims();
  return !Search(*this, own, matters, true).run(where).empty();
}

void Cover::keep_rim(const std::function<bool(Vec2)>& matters) {
  own_rims_ = rims();
  if (!grid_.box.empty()) rim_ = Search(*this, own_rims_, matters, false).run(grid_.box);
}

namespace {

/// mm. Thickness of residuals permitted between exactly meeting rings.
constexpr double kThinResidual = 0.0035;

}  // namespace

bool leaves_nothing(const LayerPasses& passes, double tool_radius) {
  std::vector<Edge> edges;
  for (const Pass& pass : passes.passes) edges.insert(edges.end(), pass.path.begin(), pass.path.end());
  const LegalArea legal(passes.legal);
  const Cover cover(edges, tool_radius + kThinResidual, Cover::SearchPlaces::kAtRims);
  return !cover.has_hole(box(passes.target),
                         [&](Vec2 p) { return legal.contains(p) && contains(passes.target, p); });
}

namespace {

/// Share of the tool radius: distance between samples of a target's border.
constexpr double kBorderPitch = 0.1;

}  // namespace

bool leaves_border(const LayerPasses& passes, double tool_radius, double reach) {
  std::vector<Edge> edges;
  for (const auto& pass : passes.passes) edges.insert(edges.end(), pass.path.begin(), pass.path.end());
  const Cover cover(edges, tool_radius + kBorderResidual);
  const LegalArea legal(passes.legal);
  const auto is_left = [&](Vec2 p) {
    return !cover.holds(p) && (legal.contains(p) || legal.is_near_boundary(p, reach));
  };
  for (const auto& region : passes.target) {
    for (const Edge& edge : region.edges()) {
      const int samples = 1 + static_cast<int>(edge.length() / (kBorderPitch * tool_radius));
      for (int i = 0; i < samples; ++i) {
        if (is_left(edge.at((i + 0.5) / samples))) return true;
      }
    }
  }
  return false;
}

// Computes the lines and circles of which rims of holes in a cover may consist.

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
