// Finds clear links: paths at depth through what is cleared already.
#pragma once

#include <optional>
#include <vector>

#include "geometry/voronoi/clearance.h"
#include "plan/adaptive/clearing/remaining_stock.h"

namespace clearcut::plan::adaptive {

/// One move of a link, a line or an arc; it begins where the move before ended.
struct LinkMove {
  Vec2 to;
  double bulge = 0;  ///< see Edge::from_bulge
  Edge edge(Vec2 from) const { return Edge::from_bulge(from, to, bulge); }
};
using LinkPath = std::vector<LinkMove>;

/// Finds links through what is cleared: a line, else an arc, else a polyline over points of the medial axis,
/// shortened as far as it stays clear.
class ClearLinks {
 public:
  /// Uses axis points `pitch` mm apart whose clearance is at least `least` mm.
  ClearLinks(const MedialAxis& axis, double least, double pitch);

  /// A link on which the cutter touches nothing thicker than `residual` mm; nothing if none was found.
  std::optional<LinkPath> find(Vec2 from, Vec2 to, const RemainingStock& remaining, double residual) const;

 private:
  int add_node(Vec2 p);
  void join(int a, int b);
  static std::optional<LinkMove> one_arc(Vec2 from, Vec2 to, const RemainingStock& remaining,
                                         double residual);
  static void straighten(std::vector<Vec2>& link, Vec2 from, const RemainingStock& remaining,
                         double residual);
  std::vector<int> nearest_free(Vec2 p, const RemainingStock& remaining, double residual) const;
  std::vector<Vec2> shortest(const std::vector<int>& sources, const std::vector<int>& targets, Vec2 from,
                             Vec2 to, const RemainingStock& remaining, double residual) const;

  /// The graph over the axis points that links are searched in.
  std::vector<Vec2> nodes_;
  struct Step {
    int to = 0;
    /// mm; the smallest `residual` for which the step was found clear. Material is only removed, so it stays
    /// clear.
    mutable double free_beyond = 1e300;
  };
  static bool is_free(const Step& step, Vec2 from, Vec2 to, const RemainingStock& remaining, double residual);
  /// The nodes found for the place where the last link began, because the next search often begins there
  /// again.
  struct Sources {
    Vec2 from;
    double residual = -1;
    std::vector<int> nodes;
  };
  const std::vector<int>& sources_of(Vec2 from, const RemainingStock& remaining, double residual) const;
  std::vector<std::vector<Step>> steps_;
  mutable Sources sources_;
};

}  // namespace clearcut::plan::adaptive
