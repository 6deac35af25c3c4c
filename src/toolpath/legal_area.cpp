#include "toolpath/legal_area.h"

#include <algorithm>
#include <cmath>

namespace clearcut {
namespace {

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
  const double across = std::clamp(std::sqrt(static_cast<double>(edges_.size())), 1.0, 512.0);
  cell_ = size / across;
  columns_ = column(box_.max.x) + 1;
  rows_ = row(box_.max.y) + 1;
  cells_.resize(columns_ * rows_);
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    for (std::size_t r = row(boxes_[i].min.y); r <= row(boxes_[i].max.y); ++r) {
      for (std::size_t c = column(boxes_[i].min.x); c <= column(boxes_[i].max.x); ++c) {
        cells_[r * columns_ + c].push_back(i);
      }
    }
  }
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
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

bool LegalArea::on_boundary(Vec2 p) const {
  const auto near = edges_near(Box{p, p}.grown(kSlack));
  return std::any_of(near.begin(), near.end(),
                     [&](std::size_t i) { return distance(edges_[i], p) <= kSlack; });
}

bool LegalArea::holds(Vec2 p) const {
  return on_boundary(p) || contains(regions_, p);
}

bool LegalArea::holds_line(Vec2 a, Vec2 b) const {
  if (distance(a, b) <= kSlack) return holds(a) && holds(b);
  Box where;
  where.add(a);
  where.add(b);
  const Edge way = Edge::line(a, b);
  std::vector<double> cuts{0, 1};
  for (const std::size_t i : edges_near(where.grown(kSlack))) {
    for (const Vec2 p : intersections(way, edges_[i])) cuts.push_back(parameter_on(a, b, p));
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
