// Shortest paths of a cutter's centre inside its legal area, round corners and islands, and short ones between two
// places, which are found sooner.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/route/legal_area.h"

namespace clearcut::inline geometry {

/// The visibility graph of a legal area, evaluated only as far as a query needs.
///
/// A shortest path bends only at corners and arcs that stick out into the area. These arcs are wrapped in tangents of
/// at most kWrap, so that paths pass outside of them: 0.4 % longer at most than along the arc itself. Safe to call
/// from several threads; the result depends only on the arguments.
class LegalPaths {
 public:
  explicit LegalPaths(const Regions& legal);

  const LegalArea& area() const { return area_; }

  /// Whether nothing sticks out into the area, so that every straight move is legal (in one connected area).
  bool all_straight() const { return corners_.empty(); }

  /// The bends of the shortest legal path from a to b, both of which must be legal; empty when the straight
  /// move is legal, absent when the area does not join them. The path from b to a has the same bends in reverse.
  /// Cost: one check of the straight move if legal; else O(k^2) such checks, k the number of bends
  /// inside the smallest ellipse about a and b that contains the path (at most twice its size).
  std::optional<std::vector<Vec2>> bends(Vec2 a, Vec2 b) const;

  /// The same for places that are asked about again and again: the corners visible from each place are stored.
  /// `paths` and `places` must outlive it. Safe to call from several threads.
  class Between {
   public:
    Between(const LegalPaths& paths, const std::vector<Vec2>& places);
    std::optional<std::vector<Vec2>> bends(int a, int b) const;

   private:
    bool sees(std::size_t place, std::size_t corner) const;

    const LegalPaths& paths_;
    const std::vector<Vec2>& places_;
    /// Visibility by place and corner, as in LegalPaths::seen_.
    std::unique_ptr<std::atomic<signed char>[]> seen_;
  };

  /// Largest angle of an arc between two neighbouring tangents, degrees.
  static constexpr double kWrapDegrees = 10;

 private:
  void add_corners(const Loop& loop);
  void add_wrap(const Edge& arc);
  /// Whether corners i and j see each other; remembered.
  bool joined(std::size_t i, std::size_t j) const;
  std::vector<std::size_t> corners_within(Vec2 a, Vec2 b, double reach) const;
  /// Whether a corner is seen from one of the ends of a path.
  using Sight = std::function<bool(std::size_t corner)>;
  struct End {
    Vec2 point;
    Sight sees;
  };
  std::optional<std::vector<Vec2>> bends_between(const End& a, const End& b) const;
  std::optional<std::vector<Vec2>> path_within(const End& a, const End& b, double reach) const;

  LegalArea area_;
  std::vector<Vec2> corners_;
  /// Visibility of pairs i < j: 0 unknown, 1 yes, -1 no.
  mutable std::unique_ptr<std::atomic<signed char>[]> seen_;
};

/// Finds short legal paths. Keeps a reference to `area`, which must be built from `regions`.
class LegalRoutes {
 public:
  LegalRoutes(const Regions& regions, const LegalArea& area);

  /// A path from a to b inside the legal area: the straight one if legal, else along the boundaries that block it,
  /// around the shorter side of each, pulled taut. Both places must be legal. Nothing if they are in different
  /// regions. Short, not always the shortest. Cost O(edges + vertices of the path squared).
  std::optional<Path> between(Vec2 a, Vec2 b) const;

 private:
  struct Crossing {
    double t = 0;  ///< along the straight path
    Vec2 point;
    std::size_t loop = 0;
    std::size_t edge = 0;
  };
  std::vector<Crossing> crossings(Vec2 a, Vec2 b) const;
  Path around(const Crossing& out, const Crossing& in) const;
  Path taut(Vec2 a, const Path& path) const;

  const LegalArea& area_;
  std::vector<Loop> loops_;
  std::vector<std::vector<Box>> boxes_;
};

}  // namespace clearcut::inline geometry
