// What an adaptive pass cuts into: the material of one layer and where the cutter's centre may be.
#pragma once

#include <optional>
#include <vector>

#include "geometry/route/legal_area.h"
#include "plan/adaptive/cleared_cells.h"
#include "stock/material.h"

namespace clearcut::plan::adaptive {

/// The material of one layer seen by one cutter, in plan view. Exact: see Material.
class RemainingStock {
 public:
  /// `legal`: where the cutter's centre may be. `stock`: beside it there is nothing; absent: no end.
  RemainingStock(const Regions& legal, double tool_radius, const std::optional<Box>& stock);

  /// mm. Paths through what is cleared may graze as much.
  static constexpr double kFree = 1e-3;
  /// mm. Where no more than this stands the cutter goes straight down.
  static constexpr double kClear = 5e-4;

  double tool_radius() const { return tool_radius_; }
  const LegalArea& legal() const { return legal_; }

  /// Angle of the front half circle in material, for a cutter at p that moves along `heading`. Radians.
  double engagement(Vec2 p, Vec2 heading) const;
  /// Length of the edge up to where the engagement exceeds `limit`, mm.
  double length_within(const Edge& edge, double limit) const;
  /// Whether a cutter smaller by `residual` mm would touch material at p.
  bool touches(Vec2 p, double residual) const;
  /// The same, with a point of that material; looked for first in direction `likely`, of length 1, where it stands longest.
  std::optional<Vec2> touched(Vec2 p, double residual, Vec2 likely) const;
  /// Whether the centre may run along the way.
  bool is_legal(const Edge& path) const;
  /// Whether the way is legal and touches nothing thicker than `residual` mm.
  bool is_free(const Edge& path, double residual) const;
  bool is_free(Vec2 a, Vec2 b, double residual) const { return is_free(Edge::line(a, b), residual); }
  /// Whether nothing stands at p any more.
  bool is_removed(Vec2 p) const { return material_.is_removed(p, -1); }
  /// Takes away a disc.
  void remove_disc(Vec2 center, double radius);
  /// Takes away what the cutter sweeps along `edge`.
  void cut(const Edge& edge);
  /// Cuts so far; and back to as many.
  std::size_t cuts() const { return material_.sweeps(); }
  void forget_beyond(std::size_t cuts);
  /// Whether all cuts longer than `tiny` mm, one after the other, keep the engagement at most at `limit`. The remaining stock stays
  /// as it is.
  bool keeps_limit(const std::vector<Edge>& cuts, double limit, double tiny);

 private:
  void note_standing(Vec2 met) const;
  bool is_standing_within(Vec2 p, double radius) const;
  void take(const Edge& path, double radius);
  /// The engagement at parameter t of an edge.
  struct Sample {
    double t = 0;
    double engagement = 0;
    double slope = 0;  ///< radians for the whole edge
    int parts = 0;     ///< of the circle that touch material
  };
  Sample sample(const Edge& edge, double t) const;
  /// Parameters of an edge.
  struct Stretch {
    double from = 0;
    double to = 0;
  };
  std::optional<Stretch> peak_above(const Edge& edge, const Sample& a, const Sample& b, double limit,
                                    int depth) const;
  double last_within(const Edge& edge, Stretch rise, double limit) const;
  static std::optional<double> likely_peak(const Sample& a, const Sample& b, double limit);

  LegalArea legal_;
  double tool_radius_;
  stock::Material material_;
  ClearedCells cleared_;
  /// A point of material, when it was last seen.
  struct Standing {
    Vec2 at;
    std::size_t age = 0;
  };
  mutable std::vector<Standing> standing_;  ///< material met by the last samples
  mutable std::size_t oldest_ = 0;          ///< of those
  std::size_t age_ = 0;                     ///< counts cuts, those forgotten, too
  std::vector<std::size_t> sweeps_;         ///< of the material before each of the cuts
};

}  // namespace clearcut::plan::adaptive
