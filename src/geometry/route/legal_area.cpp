#include "geometry/route/legal_area.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory_resource>

#include "base/tolerances.h"

namespace clearcut::inline geometry {
namespace {

/// mm. Far above the rounding of boxes of edges.
constexpr double kAside = 1e-6;

/// mm. A move within its allowance halfway between two crossings strays by less than this.
constexpr double kNearEnd = 4 * LegalArea::kSlack;

/// Length, in cell widths, from which on a move is treated as long.
constexpr double kLongWay = 4;

/// State of a cell with edges: inside or outside is unknown.
constexpr char kUnknown = 2;
/// Root of how much longer than wide an area may be for its cells to be as many as those of a square one.
constexpr double kMostSlender = 64;
/// Number of cells across a square area: at least kFewestAcross, and so many that cells and edges are about as many.
constexpr double kFewestAcross = 24;
constexpr double kMostAcross = 512;

/// A few numbers; when there are many, some are forgotten.
template <typename T>
class Few {
 public:
  /// Adds a number; true if the number is new.
  bool add(T number) {
    const auto end = numbers_.begin() + static_cast<std::ptrdiff_t>(std::min(count_, numbers_.size()));
    if (std::find(numbers_.begin(), end, number) != end) return false;
    numbers_[count_++ % numbers_.size()] = number;
    return true;
  }

 private:
  std::array<T, 16> numbers_;
  std::size_t count_ = 0;
};

/// Whether part / whole is in [0, 1].
bool is_share(double part, double whole) {
  return whole > 0 ? part >= 0 && part <= whole : part <= 0 && part >= whole;
}

double parameter_on(Vec2 a, Vec2 b, Vec2 p) {
  return dot(p - a, b - a) / norm_squared(b - a);
}

/// Whether two points are on one side of the line through `on` along `direction`, both farther than `off` from the
/// line.
bool on_one_side(Vec2 p, Vec2 q, Vec2 on, Vec2 direction, double off) {
  const double left = cross(direction, p - on), right = cross(direction, q - on);
  const double least = off * off * norm_squared(direction);
  return left * right > 0 && left * left > least && right * right > least;
}

/// Whether the straight path a-b surely passes an edge at more than `off`.
bool is_far_from(Vec2 a, Vec2 b, const Edge& edge, double off) {
  if (!edge.is_arc()) {
    return on_one_side(edge.from, edge.to, a, b - a, off) ||
           on_one_side(a, b, edge.from, edge.to - edge.from, off);
  }
  const double radius = std::sqrt(norm_squared(edge.from - edge.center)), inside = radius - off;
  const double beside = cross(b - a, edge.center - a), beyond = radius + off;
  if (beside * beside > beyond * beyond * norm_squared(b - a)) return true;
  return inside > 0 && norm_squared(a - edge.center) < inside * inside &&
         norm_squared(b - edge.center) < inside * inside;
}

}  // namespace

LegalArea::LegalArea(Regions regions) : regions_(std::move(regions)) {
  for (const auto& region : regions_) {
    for (const auto& edge : region.edges()) {
      edges_.push_back(edge);
      boxes_.push_back(edge.box());
      box_.add(boxes_.back());
    }
  }
  if (edges_.empty()) return;
  grid_ = densest_part();
  // Long narrow areas have as many cells as square ones.
  const double longest = std::max({grid_.width(), grid_.height(), 1e-9});
  const double size = std::max(std::sqrt(grid_.width() * grid_.height()), longest / kMostSlender);
  cell_ = size / cells_across();
  cells_per_mm_ = 1 / cell_;
  columns_ = column(grid_.max.x) + 1;
  rows_ = row(grid_.max.y) + 1;
  sort_edges();
  mark_empty_cells();
  find_next_empty();
}

void LegalArea::sort_edges() {
  for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
    const std::size_t first = column(boxes_[i].min.x), last = column(boxes_[i].max.x);
    const bool is_level = !edges_[i].is_arc() && edges_[i].from.y == edges_[i].to.y;
    for (std::size_t r = row(boxes_[i].min.y); r <= row(boxes_[i].max.y); ++r) {
      for (std::size_t c = first; c <= last; ++c) in_cells_.add(r * columns_ + c, i);
      if (!is_level) begin_in_.add(r * columns_ + first, i);
    }
  }
  in_cells_.build(columns_ * rows_);
  begin_in_.build(columns_ * rows_);
}

double LegalArea::cells_across() const {
  return std::clamp(2 * std::sqrt(static_cast<double>(edges_.size())), kFewestAcross, kMostAcross);
}

/// The box covered by the cells: that of all edges but very long ones, if cells over the whole box would hold more than one of
/// these edges each, as within a distant frame.
Box LegalArea::densest_part() const {
  Box part;
  double edges = 0;
  for (const Box& box : boxes_) {
    if (box.width() >= box_.width() / 2 || box.height() >= box_.height() / 2) continue;
    part.add(box);
    ++edges;
  }
  if (part.empty()) return box_;
  const double share = part.width() * part.height() / (box_.width() * box_.height());
  return share * cells_across() * cells_across() < edges ? part : box_;
}

/// Neighbouring cells without edges are on the same side: one exact test for each connected group.
void LegalArea::mark_empty_cells() {
  inside_.assign(columns_ * rows_, kUnknown);
  std::vector<std::size_t> open;
  for (std::size_t first = 0; first < inside_.size(); ++first) {
    if (inside_[first] != kUnknown || !is_empty(first)) continue;
    const char side = clearcut::contains(regions_, cell_box(first).center()) ? 1 : 0;
    inside_[first] = side;
    open.push_back(first);
    const auto visit = [&](std::size_t cell) {
      if (inside_[cell] != kUnknown || !is_empty(cell)) return;
      inside_[cell] = side;
      open.push_back(cell);
    };
    while (!open.empty()) {
      const std::size_t cell = open.back(), c = cell % columns_, r = cell / columns_;
      open.pop_back();
      if (c > 0) visit(cell - 1);
      if (c + 1 < columns_) visit(cell + 1);
      if (r > 0) visit(cell - columns_);
      if (r + 1 < rows_) visit(cell + columns_);
    }
  }
}

void LegalArea::find_next_empty() {
  next_empty_.resize(inside_.size());
  for (std::size_t cell = inside_.size(); cell-- > 0;) {
    const bool is_last = (cell + 1) % columns_ == 0;
    next_empty_[cell] = static_cast<std::uint32_t>(is_empty(cell) ? cell
                                                   : is_last      ? cell + 1
                                                                  : next_empty_[cell + 1]);
  }
}

Box LegalArea::cell_box(std::size_t cell) const {
  const std::size_t column = cell % columns_, row = cell / columns_;
  const Vec2 low = grid_.min + Vec2{static_cast<double>(column), static_cast<double>(row)} * cell_;
  return {low, low + Vec2{cell_, cell_}};
}

/// From p towards +x to the first cell without edges: only edges in between can make a difference.
bool LegalArea::contains(Vec2 p) const {
  if (edges_.empty() || !box_.contains(p)) return false;
  const std::size_t begin = row(p.y) * columns_, end = begin + columns_, first = begin + column(p.x);
  if (inside_[first] != kUnknown) return inside_[first] != 0;
  const std::size_t known = next_empty_[first];
  const bool beside = known == end;
  const double x = beside ? box_.max.x + cell_ : cell_box(known).center().x;
  int around = beside ? 0 : inside_[known];
  for (const std::uint32_t i : in_cells_.at(first)) around += crossings(i, p, x);
  // In the cells after the first, those that begin there: within a row an edge is in adjacent cells.
  for (const std::uint32_t i : begin_in_.in(first + 1, known)) around += crossings(i, p, x);
  return around != 0;
}

/// Number of times the level path from p to x crosses an edge, from its left to its right.
int LegalArea::crossings(std::size_t edge, Vec2 p, double x) const {
  const Box& box = boxes_[edge];
  if (p.y < box.min.y - kAside || p.y > box.max.y + kAside || p.x > box.max.x + kAside) return 0;
  return winding(edges_[edge], p) - winding(edges_[edge], {x, p.y});
}

std::size_t LegalArea::column(double x) const {
  return static_cast<std::size_t>(std::clamp(x - grid_.min.x, 0.0, grid_.width()) * cells_per_mm_);
}

std::size_t LegalArea::row(double y) const {
  return static_cast<std::size_t>(std::clamp(y - grid_.min.y, 0.0, grid_.height()) * cells_per_mm_);
}

/// Calls f(edge) for the edges near the straight move, row by row, only in the cells passed by the move; for most
/// edges once.
template <typename F>
void LegalArea::for_edges_along(Vec2 a, Vec2 b, const F& f) const {
  if (a.y > b.y) std::swap(a, b);
  const Box where = Edge::line(a, b).box().grown(kSlack);
  if (edges_.empty() || !box_.overlaps(where)) return;
  const Vec2 along = unit(b - a);
  const auto touches = [&](const Box& box) {
    const double reach = std::abs(along.x) * box.height() / 2 + std::abs(along.y) * box.width() / 2;
    return box.overlaps(where) && std::abs(cross(along, box.center() - a)) <= reach + 2 * kSlack;
  };
  const auto x_at = [&](double y) {
    return b.y > a.y ? std::lerp(a.x, b.x, std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0)) : a.x;
  };
  Few<std::uint32_t> met;
  for (std::size_t r = row(where.min.y); r <= row(where.max.y); ++r) {
    const double low = grid_.min.y + static_cast<double>(r) * cell_ - 2 * kSlack;
    const double high = low + cell_ + 4 * kSlack;
    const bool level = b.y - a.y < cell_;
    // The first and the last row also hold edges beyond the grid.
    const double x0 = level || r == 0 ? a.x : x_at(low), x1 = level || r + 1 == rows_ ? b.x : x_at(high);
    const std::size_t last = column(std::max(x0, x1) + kSlack);
    for (std::size_t c = column(std::min(x0, x1) - kSlack); c <= last; ++c) {
      for (const std::uint32_t i : in_cells_.at(r * columns_ + c)) {
        if (touches(boxes_[i]) && met.add(i)) f(i);
      }
    }
  }
}

bool LegalArea::is_near_boundary(Vec2 p, double reach) const {
  const Box where = Box{p, p}.grown(reach);
  if (edges_.empty() || !box_.overlaps(where)) return false;
  for (std::size_t r = row(where.min.y); r <= row(where.max.y); ++r) {
    for (std::size_t c = column(where.min.x); c <= column(where.max.x); ++c) {
      for (const std::uint32_t i : in_cells_.at(r * columns_ + c)) {
        if (boxes_[i].overlaps(where) && distance(edges_[i], p) <= reach) return true;
      }
    }
  }
  return false;
}

bool LegalArea::holds(Vec2 p) const {
  return contains(p) || is_near_boundary(p, kSlack);
}

bool LegalArea::surely_holds(const Box& where) const {
  if (edges_.empty() || !box_.contains(where.min) || !box_.contains(where.max)) return false;
  for (std::size_t r = row(where.min.y); r <= row(where.max.y); ++r) {
    for (std::size_t c = column(where.min.x); c <= column(where.max.x); ++c) {
      const std::size_t cell = r * columns_ + c;
      if (inside_[cell] != 1) return false;
    }
  }
  return true;
}

/// Whether a point of the straight move (one is tested per cell width) is in an edge-free cell outside the area, so
/// far from the cell's border that the move is refused in any case. Decides long moves past many islands quickly. May
/// return false although the move is illegal.
bool LegalArea::passes_outside(Vec2 a, Vec2 b) const {
  const double places = std::ceil(distance(a, b) * cells_per_mm_);
  if (edges_.empty() || places < kLongWay || cell_ <= 2 * kNearEnd) return false;
  for (double i = 1; i < places; ++i) {
    const Vec2 p = lerp(a, b, i / places);
    if (!box_.contains(p)) continue;
    const std::size_t cell = row(p.y) * columns_ + column(p.x);
    if (inside_[cell] == 0 && cell_box(cell).grown(-kNearEnd).contains(p)) return true;
  }
  return false;
}

bool LegalArea::holds_line(Vec2 a, Vec2 b) const {
  if (distance(a, b) <= kSlack) return holds(a) && holds(b);
  if (passes_outside(a, b)) return false;
  const double length = distance(a, b);
  std::array<std::byte, 512> memory;
  std::pmr::monotonic_buffer_resource resource(memory.data(), memory.size());
  std::pmr::vector<double> cuts({0, 1}, &resource);
  cuts.reserve(memory.size() / sizeof(double) / 2);
  bool strays = false;
  for_edges_along(a, b, [&](std::size_t i) {
    add_cuts(a, b, edges_[i], cuts);
    strays = strays || strays_beside(a, b, edges_[i].from) || strays_beside(a, b, edges_[i].to);
  });
  if (strays) return false;
  std::sort(cuts.begin(), cuts.end());
  // Between two crossings the move is wholly inside or wholly outside; an outside stretch strays farthest at its
  // middle, or beside a common end of two edges.
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if ((cuts[i] - cuts[i - 1]) * length < kSlack) continue;
    if (!holds(lerp(a, b, (cuts[i - 1] + cuts[i]) / 2))) return false;
  }
  return true;
}

/// Whether the move from a to b is outside at its nearest point to the end of an edge: there the move may stray
/// farther than halfway between two crossings, up to twice as far.
bool LegalArea::strays_beside(Vec2 a, Vec2 b, Vec2 end) const {
  const double t = parameter_on(a, b, end);
  if (t <= 0 || t >= 1) return false;
  const Vec2 p = lerp(a, b, t);
  const double aside = distance(p, end);
  return aside > kSlack && aside < kNearEnd && !holds(p);
}

/// Adds the crossings of an edge with the move from a to b, and ends of the edge on the move, as shares of the move.
void LegalArea::add_cuts(Vec2 a, Vec2 b, const Edge& edge, std::pmr::vector<double>& cuts) {
  if (is_far_from(a, b, edge, 2 * kSlack)) return;
  if (edge.is_arc()) {
    add_arc_cuts(a, b, edge, cuts);
  } else {
    const Vec2 u = b - a, v = edge.to - edge.from;
    const double det = cross(u, v), on_line = cross(edge.from - a, v), on_edge = cross(edge.from - a, u);
    const bool parallel = det * det <= 1e-28 * norm_squared(u) * norm_squared(v);
    if (!parallel && is_share(on_edge, det) && is_share(on_line, det)) cuts.push_back(on_line / det);
  }
  // An edge parallel to the move has no crossing; the boundary turns away at its ends.
  for (const Vec2 p : {edge.from, edge.to}) {
    if (distance(Edge::line(a, b), p) <= kSlack) cuts.push_back(parameter_on(a, b, p));
  }
}

void LegalArea::add_arc_cuts(Vec2 a, Vec2 b, const Edge& arc, std::pmr::vector<double>& cuts) {
  const Vec2 u = b - a;
  const double length = std::sqrt(norm_squared(u)), foot = parameter_on(a, b, arc.center);
  const double off = std::abs(cross(u, arc.center - a)) / length;
  const double radius =
      std::sqrt(0.5 * (norm_squared(arc.from - arc.center) + norm_squared(arc.to - arc.center)));
  const bool grazes = std::abs(off - radius) <= kRoundingMm;
  if (off > radius && !grazes) return;
  const double half = grazes ? 0 : std::sqrt((radius - off) * (radius + off)) / length;
  for (const double t : {foot - half, foot + half}) {
    if (t >= 0 && t <= 1 && distance(arc, a + u * t) <= kRoundingMm) cuts.push_back(t);
  }
}

}  // namespace clearcut::inline geometry
