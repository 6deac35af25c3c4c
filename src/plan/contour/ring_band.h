// What a ring and the next one inside it leave, by the medial axis: exact criterion, causes, and the widest step that
// leaves nothing.
//
// A point p inside the ring at level d is cleared by it where clearance(p) <= d + R. Any other path uphill from p leads
// to the axis and along it to the next ring at d + s, so p is cleared by that where that path is no longer than R. The
// worst points are those of clearance d + R on every rising branch of the axis, its local minima (necks), and
// branches that never reach d + s (centres, ridges). In a corner of angle alpha the clearance rises by sin(alpha / 2)
// per mm of axis, so that (s - R) / sin(alpha / 2) <= R: the published kappa (CPO-kappa eq. 6). The published rule
// measures alpha on the ring at d; what counts is the axis between d + R and d + s.
#pragma once

#include <vector>

#include "plan/common/rings.h"

namespace clearcut::plan::contour {

/// Why something is left between two rings.
enum class RestCause {
  kNone,
  kCorner,  ///< the axis climbs less steeply than the step allows for: the corner has become sharper
  kNeck,    ///< a narrow place between two wider ones
  kCentre,  ///< a local maximum of the clearance that the next ring does not reach
  kRidge    ///< the same along a stretch of constant clearance
};
const char* name_of(RestCause cause);

struct Rest {
  RestCause cause = RestCause::kNone;
  Vec2 where;
  double length = 0;  ///< mm of the longest path to the next ring; infinite where none leads there
};

/// The axis inside one ring, between level + radius and level + 2 radius.
class RingBand {
 public:
  /// `inside`: all axis pieces inside the ring at `level`.
  RingBand(const std::vector<AxisPiece>& inside, double level, double radius);

  /// The worst place when the next ring lies `step` farther inside, radius <= step <= 2 radius; cause kNone where the
  /// way is at most `reach` (the radius, less what passes shall overlap). Cost O(n log n) in pieces of the band.
  Rest worst(double step, double reach) const;

  /// The widest step between radius and 2 radius - (radius - reach) that leaves nothing, to 1e-4 mm. Where a centre
  /// limits it, the next ring stays a fiftieth of the radius below that centre.
  double widest_step(double reach) const;

 private:
  struct Vertex {
    Vec2 point;
    double clearance = 0;
    double summit = 0;  ///< greatest clearance that the axis climbs to from here
    std::vector<std::size_t> links;
  };
  struct Link {
    std::size_t low = 0;
    std::size_t high = 0;
    double length = 0;
  };
  void find_summits();
  std::vector<double> lengths_to(double level) const;
  RestCause cause_at(std::size_t vertex, const std::vector<double>& lengths) const;

  double floor_ = 0;  ///< level + radius, and a little: rests thinner than that do not count
  double level_ = 0;
  double radius_ = 0;
  std::vector<Vertex> vertices_;
  std::vector<Link> links_;
};

}  // namespace clearcut::plan::contour
