// The remaining stock of one layer while adaptive clearing plans it, and where the cutter's centre may be.
#pragma once

#include <optional>
#include <vector>

#include "geometry/route/legal_area.h"
#include "plan/adaptive/clearing/cleared_cells.h"
#include "plan/adaptive/clearing/parameters.h"
#include "stock/material.h"

namespace clearcut::plan::adaptive {

/// The material of one layer that the cuts planned so far have left, in plan view. Planning asks it for
/// engagements, removes cuts from it, and takes back cuts that lead nowhere. Exact, without a raster: see
/// stock::Material.
class RemainingStock {
 public:
  /// `legal`: where the cutter's centre may be. `stock`: outside of it there is no material; absent: material
  /// everywhere.
  RemainingStock(const Regions& legal, double tool_radius, const std::optional<Box>& stock);

  /// mm. Links may touch residuals up to this thick.
  static constexpr double kFree = ResidualLimits::kLink;
  /// mm. Where the cutter goes straight down, residuals up to this thick may stand.
  static constexpr double kClear = ResidualLimits::kPlunge;

  double tool_radius() const { return tool_radius_; }
  const LegalArea& legal() const { return legal_; }

  /// The engagement in radians of a cutter with its centre at p that moves along `heading`, a unit vector:
  /// the angle of the front half of its circle in material.
  double engagement(Vec2 p, Vec2 heading) const;
  /// mm from the edge's beginning to the last sample before the engagement exceeds `limit` radians; the whole
  /// length if it never does.
  double length_within(const Edge& edge, double limit) const;
  /// Whether a cutter whose radius is smaller by `residual` mm would touch material with its centre at p.
  bool touches(Vec2 p, double residual) const;
  /// The same, with a point of the material that it touches. The direction `likely`, a unit vector, is
  /// searched first: pass the one in which material is likely to stand longest.
  std::optional<Vec2> touched(Vec2 p, double residual, Vec2 likely) const;
  /// Whether the path stays in the legal area for the centre.
  bool is_legal(const Edge& path) const;
  /// Whether the path is legal and the cutter touches nothing thicker than `residual` mm on it.
  bool is_free(const Edge& path, double residual) const;
  bool is_free(Vec2 a, Vec2 b, double residual) const { return is_free(Edge::line(a, b), residual); }
  /// Whether nothing stands at p any more.
  bool is_removed(Vec2 p) const { return material_.is_removed(p, -1); }
  /// Removes a disc.
  void remove_disc(Vec2 center, double radius);
  /// Removes what the cutter sweeps while its centre runs along `edge`.
  void cut(const Edge& edge);
  /// The state of the stock, for forget_beyond(): a number that grows with every cut and disc removed.
  std::size_t cuts() const { return material_.sweeps(); }
  /// Puts back all cuts and discs removed since cuts() returned `cuts`.
  void forget_beyond(std::size_t cuts);
  /// Whether all cuts longer than `tiny` mm, made one after the other, keep the engagement at `limit` radians
  /// or below. They are made on trial and taken back.
  bool keeps_limit(const std::vector<Edge>& cuts, double limit, double tiny);

 private:
  void note_standing(Vec2 met) const;
  bool is_standing_within(Vec2 p, double radius) const;
  void take(const Edge& path, double radius);
  /// The engagement at parameter t, from 0 to 1, of an edge.
  struct Sample {
    double t = 0;
    double engagement = 0;
    double slope = 0;  ///< radians; change of the engagement over the whole edge if it kept its rate at t
    int parts = 0;     ///< number of separate parts of the circle that touch material
  };
  Sample sample(const Edge& edge, double t) const;
  /// A part of an edge, by parameters from 0 to 1, in which something is searched for.
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
  /// A point of material, and the value of age_ when it was last met.
  struct Standing {
    Vec2 at;
    std::size_t age = 0;
  };
  /// Points of material met by the last queries, because the next query probably meets them again.
  mutable std::vector<Standing> standing_;
  mutable std::size_t oldest_ = 0;   ///< index of the one met longest ago
  std::size_t age_ = 0;              ///< number of cuts ever made, those taken back included
  std::vector<std::size_t> sweeps_;  ///< for each cut: number of sweeps in material_ before it
};

}  // namespace clearcut::plan::adaptive
