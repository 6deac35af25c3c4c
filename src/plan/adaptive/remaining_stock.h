// The remaining stock of one layer while adaptive clearing plans it, and where the cutter's centre may be.
#pragma once

#include <optional>
#include <vector>

#include "geometry/route/legal_area.h"
#include "plan/adaptive/cleared_cells.h"
#include "plan/adaptive/parameters.h"
#include "stock/material.h"

namespace clearcut::plan::adaptive {

/// The material of one layer that planned cuts have not taken away yet, seen by one cutter in plan view. Planning asks it
/// for engagements, cuts into it, and takes cuts back that lead nowhere. Exact, without a raster: see stock::Material.
class RemainingStock {
 public:
  /// `legal`: where the cutter's centre may be. `stock`: beside it there is nothing; absent: no end.
  RemainingStock(const Regions& legal, double tool_radius, const std::optional<Box>& stock);

  /// mm. Links may graze residuals of this thickness.
  static constexpr double kFree = ResidualLimits::kLink;
  /// mm. Where no thicker residual than this stands the cutter goes straight down.
  static constexpr double kClear = ResidualLimits::kPlunge;

  double tool_radius() const { return tool_radius_; }
  const LegalArea& legal() const { return legal_; }

  /// The engagement in radians: the angle of the front half of the cutter's circle in material, for a centre at p that moves
  /// along `heading`.
  double engagement(Vec2 p, Vec2 heading) const;
  /// mm of the edge from its beginning up to where the engagement comes to exceed `limit` radians; all of it if nowhere.
  double length_within(const Edge& edge, double limit) const;
  /// Whether a cutter whose radius is `residual` mm smaller would touch material with its centre at p.
  bool touches(Vec2 p, double residual) const;
  /// The same, and a point of that material. It is looked for first in the direction `likely` (a unit vector): pass the one
  /// in which material stands longest.
  std::optional<Vec2> touched(Vec2 p, double residual, Vec2 likely) const;
  /// Whether the centre may run along the path: it stays in the legal area.
  bool is_legal(const Edge& path) const;
  /// Whether the centre may run along the path and the cutter touches nothing there that is thicker than `residual` mm.
  bool is_free(const Edge& path, double residual) const;
  bool is_free(Vec2 a, Vec2 b, double residual) const { return is_free(Edge::line(a, b), residual); }
  /// Whether nothing stands at p any more.
  bool is_removed(Vec2 p) const { return material_.is_removed(p, -1); }
  /// Takes away a disc.
  void remove_disc(Vec2 center, double radius);
  /// Takes away what the cutter sweeps while its centre runs along `edge`.
  void cut(const Edge& edge);
  /// How many cuts and discs were taken away so far; and back to an earlier number, with all later ones material again.
  std::size_t cuts() const { return material_.sweeps(); }
  void forget_beyond(std::size_t cuts);
  /// Whether all cuts longer than `tiny` mm, one after the other, keep the engagement at most at `limit`. The cuts are
  /// tried and taken back.
  bool keeps_limit(const std::vector<Edge>& cuts, double limit, double tiny);

 private:
  void note_standing(Vec2 met) const;
  bool is_standing_within(Vec2 p, double radius) const;
  void take(const Edge& path, double radius);
  /// The engagement at parameter t (0 to 1) of an edge.
  struct Sample {
    double t = 0;
    double engagement = 0;
    double slope = 0;  ///< radians of change for all of the edge, at the rate at t
    int parts = 0;     ///< separate parts of the circle that touch material
  };
  Sample sample(const Edge& edge, double t) const;
  /// Parameters (0 to 1) of an edge between which something is looked for.
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
  mutable std::vector<Standing>
      standing_;  ///< material that the last queries met: the next one probably meets it, too
  mutable std::size_t oldest_ = 0;   ///< of those
  std::size_t age_ = 0;              ///< counts cuts, those forgotten, too
  std::vector<std::size_t> sweeps_;  ///< of the material before each of the cuts
};

}  // namespace clearcut::plan::adaptive
