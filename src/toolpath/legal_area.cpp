#include "toolpath/legal_area.h"

#include <algorithm>
#include <cmath>

namespace clearcut {
namespace {

/// mm. Far above the rounding of boxes of edges.
constexpr double kAside = 1e-6;

/// Ascending, each number once.
void keep_once(std::vector<std::size_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

double parameter_on(Vec2 a, Vec2 b, Vec2 p) {
  return dot(p - a, b - a) / norm_squared(b - a);
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
  const double size = std::max({box_.width(), box_.height(), 1e-9});
  const double across = std::clamp(2 * std::sqrt(static_cast<double>(edges_.size())), 24.0, 512.0);
  cell_ = size / across;
  columns_ = column(box_.max.x) + 1;
  rows_ = row(box_.max.y) + 1;
  cells_.resize(columns_ * rows_);
  first_columns_.reserve(boxes_.size());
  for (const Box& box : boxes_) first_columns_.push_back(column(box.min.x));
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    for (std::size_t r = row(boxes_[i].min.y); r <= row(boxes_[i].max.y); ++r) {
      for (std::size_t c = column(boxes_[i].min.x); c <= column(boxes_[i].max.x); ++c) {
        cells_[r * columns_ + c].push_back(i);
      }
    }
  }
  mark_empty_cells();
}

/// Neighbouring cells without edges lie on the same side: one exact test for each connected group.
void LegalArea::mark_empty_cells() {
  constexpr char kUnknown = 2;
  inside_.assign(cells_.size(), kUnknown);
  std::vector<std::size_t> open;
  for (std::size_t first = 0; first < cells_.size(); ++first) {
    if (inside_[first] != kUnknown || !cells_[first].empty()) continue;
    const char side = clearcut::contains(regions_, cell_box(first).center()) ? 1 : 0;
    inside_[first] = side;
    open.push_back(first);
    const auto visit = [&](std::size_t cell) {
      if (inside_[cell] != kUnknown || !cells_[cell].empty()) return;
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

Box LegalArea::cell_box(std::size_t cell) const {
  const std::size_t column = cell % columns_, row = cell / columns_;
  const Vec2 low = box_.min + Vec2{static_cast<double>(column), static_cast<double>(row)} * cell_;
  return {low, low + Vec2{cell_, cell_}};
}

/// From p towards +x to the first cell without edges: only edges in between can make a difference.
bool LegalArea::contains(Vec2 p) const {
  if (edges_.empty() || !box_.contains(p)) return false;
  const std::size_t begin = row(p.y) * columns_, end = begin + columns_, first = begin + column(p.x);
  std::size_t known = first;
  while (known < end && !cells_[known].empty()) ++known;
  const bool beside = known == end;
  const Vec2 q{beside ? box_.max.x + cell_ : cell_box(known).center().x, p.y};
  int around = beside ? 0 : inside_[known];
  for (std::size_t cell = first; cell < known; ++cell) {
    for (const std::size_t i : cells_[cell]) {
      // In a row an edge stands in cells beside each other: it counts in the first of them.
      const bool counted = cell > first && first_columns_[i] + begin < cell;
      const bool level = p.y >= boxes_[i].min.y - kAside && p.y <= boxes_[i].max.y + kAside;
      if (level && !counted) around += winding(edges_[i], p) - winding(edges_[i], q);
    }
  }
  return around != 0;
}

std::size_t LegalArea::column(double x) const {
  return static_cast<std::size_t>(std::clamp(x - box_.min.x, 0.0, box_.width()) / cell_);
}

std::size_t LegalArea::row(double y) const {
  return static_cast<std::size_t>(std::clamp(y - box_.min.y, 0.0, box_.height()) / cell_);
}

std::vector<std::size_t> LegalArea::edges_near(const Box& where) const {
  std::vector<std::size_t> found;
  if (edges_.empty() || !box_.overlaps(where)) return found;
  for (std::size_t r = row(where.min.y); r <= row(where.max.y); ++r) {
    for (std::size_t c = column(where.min.x); c <= column(where.max.x); ++c) {
      for (const std::size_t i : cells_[r * columns_ + c]) {
        if (boxes_[i].overlaps(where)) found.push_back(i);
      }
    }
  }
  keep_once(found);
  return found;
}

/// Row by row, only the cells that the way passes through.
std::vector<std::size_t> LegalArea::edges_along(Vec2 a, Vec2 b) const {
  if (a.y > b.y) std::swap(a, b);
  const Box where = Edge::line(a, b).box().grown(kSlack);
  std::vector<std::size_t> found;
  if (edges_.empty() || !box_.overlaps(where)) return found;
  const Vec2 along = unit(b - a);
  const auto touches = [&](const Box& box) {
    const double reach = std::abs(along.x) * box.height() / 2 + std::abs(along.y) * box.width() / 2;
    return box.overlaps(where) && std::abs(cross(along, box.center() - a)) <= reach + 2 * kSlack;
  };
  const auto x_at = [&](double y) {
    return b.y > a.y ? std::lerp(a.x, b.x, std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0)) : a.x;
  };
  for (std::size_t r = row(where.min.y); r <= row(where.max.y); ++r) {
    const double low = box_.min.y + static_cast<double>(r) * cell_ - 2 * kSlack;
    const bool level = b.y - a.y < cell_;
    const double x0 = level ? a.x : x_at(low), x1 = level ? b.x : x_at(low + cell_ + 4 * kSlack);
    const std::size_t last = column(std::max(x0, x1) + kSlack);
    for (std::size_t c = column(std::min(x0, x1) - kSlack); c <= last; ++c) {
      for (const std::size_t i : cells_[r * columns_ + c]) {
        if (touches(boxes_[i])) found.push_back(i);
      }
    }
  }
  keep_once(found);
  return found;
}

bool LegalArea::on_boundary(Vec2 p) const {
  const auto near = edges_near(Box{p, p}.grown(kSlack));
  return std::any_of(near.begin(), near.end(),
                     [&](std::size_t i) { return distance(edges_[i], p) <= kSlack; });
}

bool LegalArea::holds(Vec2 p) const {
  return contains(p) || on_boundary(p);
}

bool LegalArea::surely_holds(const Box& where) const {
  if (edges_.empty() || !box_.contains(where.min) || !box_.contains(where.max)) return false;
  for (std::size_t r = row(where.min.y); r <= row(where.max.y); ++r) {
    for (std::size_t c = column(where.min.x); c <= column(where.max.x); ++c) {
      const std::size_t cell = r * columns_ + c;
      if (!cells_[cell].empty() || inside_[cell] != 1) return false;
    }
  }
  return true;
}

bool LegalArea::holds_line(Vec2 a, Vec2 b) const {
  if (distance(a, b) <= kSlack) return holds(a) && holds(b);
  const Edge way = Edge::line(a, b);
  std::vector<double> cuts{0, 1};
  for (const std::size_t i : edges_along(a, b)) {
    for (const Vec2 p : intersections(way, edges_[i])) cuts.push_back(parameter_on(a, b, p));
    // An edge along the way crosses it nowhere; where it ends the boundary turns away.
    for (const Vec2 p : {edges_[i].from, edges_[i].to}) {
      if (distance(way, p) <= kSlack) cuts.push_back(parameter_on(a, b, p));
    }
  }
  std::sort(cuts.begin(), cuts.end());
  // Between two crossings the way is all inside or all outside; where it runs outside it strays farthest in
  // between.
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if ((cuts[i] - cuts[i - 1]) * way.length() < kSlack) continue;
    if (!holds(lerp(a, b, (cuts[i - 1] + cuts[i]) / 2))) return false;
  }
  return true;
}

}  // namespace clearcut
