#include "support/independent/raster_simulator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clearcut::test_support {
namespace {

/// mm. A move may miss the full radius by this much without a fault.
constexpr double kCutSlack = 0.005;

class Raster {
 public:
  explicit Raster(const RasterJob& job) : job_(job) {
    const Box box = clearcut::box(job.target).grown(2 * job.cell);
    origin_ = box.min;
    columns_ = static_cast<int>(box.width() / job.cell) + 1;
    rows_ = static_cast<int>(box.height() / job.cell) + 1;
    distance_to_cut_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 1e9);
    find_reachable();
  }

  /// Calls f(index, center) for every cell whose centre lies in `box`.
  template <typename F>
  void for_cells(const Box& box, F&& f) const {
    const int c0 = std::max(0, static_cast<int>(std::floor((box.min.x - origin_.x) / job_.cell)) - 1);
    const int r0 = std::max(0, static_cast<int>(std::floor((box.min.y - origin_.y) / job_.cell)) - 1);
    const int c1 = std::min(columns_ - 1, static_cast<int>((box.max.x - origin_.x) / job_.cell) + 1);
    const int r1 = std::min(rows_ - 1, static_cast<int>((box.max.y - origin_.y) / job_.cell) + 1);
    for (int r = r0; r <= r1; ++r) {
      for (int c = c0; c <= c1; ++c) {
        f(static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(c),
          Vec2{origin_.x + (c + 0.5) * job_.cell, origin_.y + (r + 0.5) * job_.cell});
      }
    }
  }

  void cut(const Edge& edge) {
    const double reach = job_.radius + job_.cell;
    for_cells(box_of(edge).grown(reach), [&](std::size_t i, Vec2 p) {
      if (distance_to_cut_[i] > 0)
        distance_to_cut_[i] = std::min(distance_to_cut_[i], distance_of(edge, p) - job_.radius);
    });
  }

  int material_under(const Edge& edge) const {
    int cells = 0;
    for_cells(box_of(edge).grown(job_.radius), [&](std::size_t i, Vec2 p) {
      if (target_[i] && distance_to_cut_[i] > kCutSlack && distance_of(edge, p) < job_.radius - job_.cell)
        ++cells;
    });
    return cells;
  }

  void report(RasterFindings& findings) const {
    for_cells(clearcut::box(job_.target), [&](std::size_t i, Vec2 p) {
      if (!reachable_[i]) return;
      findings.reachable_mm2 += job_.cell * job_.cell;
      if (distance_to_cut_[i] <= kCutSlack) return;
      ++findings.uncut_cells;
      if (distance_to_cut_[i] <= findings.uncut_depth) return;
      findings.uncut_depth = distance_to_cut_[i];
      findings.uncut_at = p;
    });
    findings.uncut_mm2 = findings.uncut_cells * job_.cell * job_.cell;
  }

 private:
  static Box box_of(const Edge& edge) {
    if (edge.from != edge.to) return edge.box();
    return {edge.from, edge.from};
  }
  static double distance_of(const Edge& edge, Vec2 p) {
    return edge.from == edge.to ? clearcut::distance(edge.from, p) : distance(edge, p);
  }

  static double wall_distance(const Regions& regions, Vec2 p) {
    double d = std::numeric_limits<double>::infinity();
    for (const auto& region : regions) d = std::min(d, region.boundary_distance(p));
    return d;
  }

  /// Cells that a legal centre certainly reaches: spread from centre points laid finely along the raster.
  void find_reachable() {
    reachable_.assign(distance_to_cut_.size(), false);
    target_.assign(distance_to_cut_.size(), false);
    const double legal = job_.radius + job_.wall_stock + 1e-6;
    // Centres may lie outside the target (open sides): look a radius around it.
    const Box around = clearcut::box(job_.target).grown(job_.radius);
    std::vector<Vec2> rim;
    std::vector<char> center(distance_to_cut_.size(), 0);
    for (double y = around.min.y; y <= around.max.y; y += job_.cell) {
      for (double x = around.min.x; x <= around.max.x; x += job_.cell) {
        const Vec2 p{x, y};
        if (!contains(job_.allowed, p)) continue;
        const double d = wall_distance(job_.allowed, p);
        if (d < legal) continue;
        if (d < legal + 1.5 * job_.cell || !clearcut::box(job_.target).contains(p)) rim.push_back(p);
        for_cells({p, p}, [&](std::size_t i, Vec2 q) {
          if (clearcut::distance(p, q) < 0.75 * job_.cell) center[i] = 1;
        });
      }
    }
    for (const Vec2 p : rim) {
      for_cells(Box{p, p}.grown(job_.radius), [&](std::size_t i, Vec2 q) {
        if (clearcut::distance(p, q) <= job_.radius) reachable_[i] = true;
      });
    }
    for_cells(clearcut::box(job_.target), [&](std::size_t i, Vec2 q) {
      target_[i] = contains(job_.target, q);
      reachable_[i] = (reachable_[i] || center[i]) && target_[i];
    });
  }

  const RasterJob& job_;
  Vec2 origin_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<double> distance_to_cut_;
  std::vector<bool> reachable_;
  std::vector<bool> target_;
};

void check_gouge(const RasterJob& job, const Move& move, RasterFindings& findings) {
  const bool point = move.path.from == move.path.to;
  for (const auto& region : job.allowed) {
    for (const auto& wall : region.edges()) {
      const double d = point ? distance(wall, move.path.from) : distance(wall, move.path);
      const double depth = job.radius + job.wall_stock - d;
      if (depth <= findings.gouge) continue;
      findings.gouge = depth;
      findings.gouge_at = move.path.from;
    }
  }
  if (contains(job.allowed, move.path.to)) return;
  findings.gouge = std::max(findings.gouge, 2 * job.radius);
  findings.gouge_at = move.path.to;
}

}  // namespace

RasterFindings simulate(const RasterJob& job, std::span<const Move> moves) {
  Raster raster(job);
  RasterFindings findings;
  for (const auto& move : moves) {
    const double lowest = std::min(move.z_from, move.z_to);
    if (lowest >= job.z_top) continue;
    check_gouge(job, move, findings);
    if (is_rapid(move.kind) && move.z_to <= move.z_from)
      findings.rapid_cells += raster.material_under(move.path);
    if (lowest <= job.z + 1e-9) raster.cut(move.path);
  }
  raster.report(findings);
  return findings;
}

}  // namespace clearcut::test_support
