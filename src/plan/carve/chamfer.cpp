#include "plan/carve/chamfer.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/voronoi/clearance.h"

namespace clearcut::plan::carve {
namespace {

/// mm. Depth of the tip below a chamfer's foot if there is room, and the steps in which smaller depths are tried.
constexpr double kTipBelow = 0.5;
constexpr double kTipStep = 0.1;
/// mm. Least distance between the tip and the floor of the area of the cone.
constexpr double kOverFloor = 0.05;
/// mm. Length of the pieces of a path, each kept or left out as a whole.
constexpr double kPiece = 0.05;
/// mm. A flank may seem to cut this far into a wall, because offsets err by as much.
constexpr double kTouch = 0.0012;

double distance_to(const std::vector<Edge>& edges, Vec2 p) {
  double least = HUGE_VAL;
  for (const Edge& edge : edges) least = std::min(least, distance(edge, p));
  return least;
}

class EdgeChamferer {
 public:
  EdgeChamferer(const Chamfer& chamfer, const ChamferShape& shape, const std::vector<StandingUpTo>& standing,
                const Tolerances& tol)
      : chamfer_(chamfer), shape_(shape), standing_(standing), tol_(tol) {
    for (const StandingUpTo& level : standing) {
      std::vector<Edge> edges;
      for (const Region& region : level.free) {
        for (const Edge& edge : region.edges()) edges.push_back(edge);
      }
      boundaries_.push_back(std::move(edges));
    }
  }

  ChamferTracks chamfer() {
    std::optional<ChamferTracks> best;
    const double most = std::min({kTipBelow, cone_above_foot(), foot() - chamfer_.free_floor - kOverFloor});
    for (double below = std::max(0.0, most);; below = std::max(0.0, below - kTipStep)) {
      ChamferTracks tracks = tracks_with(below);
      if (!best || tracks.left_mm < best->left_mm) best = std::move(tracks);
      if (best->left_mm <= 0 || below <= 0) break;
    }
    return std::move(*best);
  }

 private:
  double foot() const { return shape_.top - chamfer_.depth; }
  /// mm; greatest depth of the tip below the chamfer's foot for which the flanks still reach up to the chamfer's top.
  double cone_above_foot() const {
    return (shape_.tool_radius - shape_.tip_radius) / shape_.slope - chamfer_.depth;
  }
  double radius_at(double height) const {
    return std::min(shape_.tool_radius, shape_.tip_radius + std::max(0.0, height) * shape_.slope);
  }

  ChamferTracks tracks_with(double below) {
    ChamferTracks out;
    tip_ = foot() - below;
    const double radius = radius_at(below);
    // If the cone at the chamfer's foot does not fit into a corner of the area, the chamfer ends before the corner.
    std::vector<Track> runs;
    for (const Region& room : chamfer_.free_beside) {
      for (const Region& centers : inset(room, radius + shape_.aside, tol_)) {
        add_runs(centers.outer(), runs, out.left_mm);
        for (const Loop& island : centers.islands()) add_runs(island, runs, out.left_mm);
      }
    }
    if (runs.empty()) out.left_mm = HUGE_VAL;
    const int levels = std::max(1, static_cast<int>(std::ceil(chamfer_.depth / shape_.stepdown - 1e-9)));
    for (int i = 1; i <= levels; ++i) {
      std::vector<Track> set = runs;
      const double lift = chamfer_.depth * (levels - i) / levels;
      for (Track& track : set) {
        for (Track::Piece& piece : track.pieces) piece.z_from = piece.z_to = tip_ + lift;
      }
      out.sets.push_back(std::move(set));
    }
    return out;
  }

  /// Whether p is beside the wall to be chamfered, and not at another border of the cone's area.
  bool is_beside_wall(Vec2 p) const { return distance_to(chamfer_.line, p) < chamfer_.reach; }

  bool is_free(Vec2 p) const {
    for (std::size_t i = 0; i < standing_.size(); ++i) {
      const double needed = radius_at(standing_[i].z - tip_);
      if (distance_to(boundaries_[i], p) < needed - kTouch || !contains(standing_[i].free, p)) return false;
    }
    return true;
  }

  void add_runs(const Loop& loop, std::vector<Track>& runs, double& left_mm) const {
    Track run;
    bool whole = true;
    for (const Edge& edge : loop) {
      const int pieces = std::max(1, static_cast<int>(std::ceil(edge.length() / kPiece)));
      double begun = 0;
      const auto end_at = [&](double t) {
        if (t > begun) run.pieces.push_back({begun == 0 && t == 1 ? edge : edge.part(begun, t), tip_, tip_});
      };
      for (int i = 0; i < pieces; ++i) {
        const double a = static_cast<double>(i) / pieces, b = (i + 1.0) / pieces;
        const Vec2 middle = edge.at((a + b) / 2);
        const bool wanted = is_beside_wall(middle), good = wanted && is_free(middle);
        if (wanted && !good) left_mm += edge.length() / pieces;
        if (good) continue;
        whole = false;
        end_at(a);
        begun = b;
        if (!run.pieces.empty()) runs.push_back(std::move(run));
        run = {};
      }
      end_at(1);
    }
    if (run.pieces.empty()) return;
    run.closed = whole;
    runs.push_back(std::move(run));
  }

  const Chamfer& chamfer_;
  const ChamferShape& shape_;
  const std::vector<StandingUpTo>& standing_;
  const Tolerances& tol_;
  std::vector<std::vector<Edge>> boundaries_;
  double tip_ = 0;
};

}  // namespace

ChamferTracks chamfer_edge(const Chamfer& chamfer, const ChamferShape& shape,
                           const std::vector<StandingUpTo>& standing, const Tolerances& tol) {
  return EdgeChamferer(chamfer, shape, standing, tol).chamfer();
}

}  // namespace clearcut::plan::carve
