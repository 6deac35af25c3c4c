// Paths through what is cleared already.
#pragma once

#include <optional>
#include <vector>

#include "geometry/clearance.h"
#include "plan/adaptive/remaining_stock.h"

namespace clearcut::plan::adaptive {

/// A move of a way, straight or on an arc.
struct LinkMove {
  Vec2 to;
  double bulge = 0;  ///< see Edge::from_bulge
  Edge edge(Vec2 from) const { return Edge::from_bulge(from, to, bulge); }
};
using LinkPath = std::vector<LinkMove>;

/// Paths through what is cleared: straight, else over one arc, over points of the medial axis.
class ClearLinks {
 public:
  /// `least`: clearance of the axis points that the centre may use, `pitch`: distance between them, mm.
  ClearLinks(const MedialAxis& axis, double least, double pitch);

  /// From `from` to `to`, free of anything thicker than `residual` mm; none when there is no way.
  std::optional<LinkPath> find(Vec2 from, Vec2 to, const RemainingStock& remaining, double residual) const;

 private:
  int add_node(Vec2 p);
  void join(int a, int b);
  static std::optional<LinkMove> one_arc(Vec2 from, Vec2 to, const RemainingStock& remaining,
                                         double residual);
  static void pull_taut(std::vector<Vec2>& link, Vec2 from, const RemainingStock& remaining, double residual);
  std::vector<int> nearest_free(Vec2 p, const RemainingStock& remaining, double residual) const;
  std::vector<Vec2> shortest(const std::vector<int>& sources, const std::vector<int>& targets, Vec2 from,
                             Vec2 to, const RemainingStock& remaining, double residual) const;

  std::vector<Vec2> nodes_;
  struct Step {
    int to = 0;
    /// mm; thinnest residual beyond which the step was found free. What is free once stays free.
    mutable double free_beyond = 1e300;
  };
  static bool is_free(const Step& step, Vec2 from, Vec2 to, const RemainingStock& remaining, double residual);
  /// The last place where a way began, for the next one from there.
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
