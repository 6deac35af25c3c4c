// Shortens the flexible paths of a skeleton without losing any cleared place, and removes corners from shortened
// paths.
#pragma once

#include <functional>
#include <memory>

#include "geometry/route/legal_area.h"
#include "plan/contour/skeleton/bands.h"
#include "plan/contour/skeleton/skeleton.h"

namespace clearcut::plan::contour {

/// The area to be cleared by the paths, and their legal area.
struct TightenJob {
  double radius = 0;                  ///< radius of the cutter, mm
  std::function<bool(Vec2)> matters;  ///< whether a place has to be cleared
  Box where;                          ///< a box around all places to be cleared
  const LegalArea* legal = nullptr;   ///< legal area of the centre
  double turn_cost = 0;               ///< mm of path that take as much time as a corner of a right angle
  bool bare = false;                  ///< not even a thin residual may stay
};

/// Shortens the paths of a skeleton while every relevant place stays within the tool radius of a path or a
/// ring.
///
/// Method  The paths are elastic bands shortened by Newton steps. Witnesses, points to be cleared, hold the bands
///         near them; some are fixed, some stay in the middle between two bands. After each round an exact check
///         (Cover::holes) finds uncleared places, and new witnesses are set there.
/// Cost    O(rounds * iterations * (vertices + witnesses near the limit)).
class Tightener {
 public:
  Tightener(Skeleton skeleton, TightenJob job);
  ~Tightener();
  Tightener(Tightener&&) noexcept;
  Tightener& operator=(Tightener&&) noexcept;

  /// Makes a number of rounds; a few are enough to compare one skeleton with another.
  void pull(int rounds);
  /// Makes rounds with stiffer and stiffer witnesses until the check finds nothing left, then drops needless
  /// vertices. False if something stays; the skeleton must not be used then.
  bool finish();
  const Skeleton& skeleton() const;
  /// mm; greatest distance of residuals from the cut area. 0, or a residual well below tol.uncut if passes fit
  /// exactly side by side, as in pockets of round dimensions.
  double residual() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Drops every vertex of the paths that is not needed for clearing the same area: fewer corners, shorter paths. Every
/// point within `radius` mm of a path or ring stays so.
/// Cost  O(vertices * (edges near)^2).
void drop_needless_vertices(Bands& paths, const TightenJob& job, double radius);

}  // namespace clearcut::plan::contour
