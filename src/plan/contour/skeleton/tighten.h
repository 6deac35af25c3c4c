// Pulls the flexible paths of a skeleton taut without uncovering anything. Used by the planner alone.
#pragma once

#include <functional>
#include <memory>

#include "geometry/route/legal_area.h"
#include "plan/contour/skeleton/skeleton.h"

namespace clearcut::plan::contour {

struct TightenJob {
  double radius = 0;                  ///< of the cutter, mm
  std::function<bool(Vec2)> matters;  ///< whether a place has to be cut
  Box where;                          ///< holds all places that matter
  const LegalArea* legal = nullptr;   ///< where the centre may be
  double turn_cost = 0;               ///< mm of path that take as long as a right-angled corner costs
  bool bare = false;                  ///< not even a residual may stay
};

/// Shortens the paths of a skeleton while everything that matters stays within the radius of a path or a ring.
///
/// Method  The paths are rubber bands, shortened by Newton steps; places that have to be cut (witnesses) hold
/// the bands
///         near them. Some witnesses stand still, some keep to the middle between two bands. An exact check
///         (Cover::holes) after each round names what is left, and there new witnesses are set.
/// Cost    O(rounds * iterations * (vertices + witnesses near the limit)).
class Tightener {
 public:
  Tightener(Skeleton skeleton, TightenJob job);
  ~Tightener();
  Tightener(Tightener&&) noexcept;
  Tightener& operator=(Tightener&&) noexcept;

  /// A few rounds: enough to compare one skeleton with another.
  void pull(int rounds);
  /// Rounds with ever stiffer bands until the check finds nothing left; then drops needless vertices.
  /// False when something stays; the skeleton is not to be used then.
  bool finish();
  const Skeleton& skeleton() const;
  /// mm. How far from what is cut anything may be left: 0, or a residual well under tol.uncut where strokes fit
  /// exactly side by side, as they do in pockets of round dimensions.
  double residual() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace clearcut::plan::contour
