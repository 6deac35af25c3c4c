// Finds exactly, by the medial axis, the residual between a ring and the next one inside, its cause, and the widest
// step without residual.
//
// A point p inside the ring at clearance d is cleared by this ring if clearance(p) <= d + R. Else the path
// uphill from p to the axis, and along the axis to the next ring at d + s, must be no longer than R. The
// worst points are those of clearance d + R on every rising branch of the axis, its local minima (necks), and
// branches never reaching d + s (centres, ridges). In a corner of angle alpha the clearance rises by sin(alpha / 2)
// per mm of axis, so that (s - R) / sin(alpha / 2) <= R: the published kappa (CPO-kappa eq. 6, docs/texts.md). The
// published rule measures alpha on the ring at d, while the axis between d + R and d + s decides.
#pragma once

#include <vector>

#include "plan/common/rings.h"

namespace clearcut::plan::contour {

/// Why something is left between two rings.
enum class RestCause {
  kNone,
  kCorner,  ///< the clearance rises too slowly along the axis: the corner is too sharp for the step
  kNeck,    ///< a narrow place between two wider ones
  kCentre,  ///< a local maximum of the clearance not reached by the next ring
  kRidge    ///< the same along a stretch of constant clearance
};
const char* name_of(RestCause cause);

/// The worst residual of two rings.
struct Rest {
  RestCause cause = RestCause::kNone;
  Vec2 where;
  double length = 0;  ///< mm; shortest path from there to the next ring; infinite if there is none
};

/// The part of the axis inside one ring whose clearance is between level + radius and level + 2 radius, mm.
class RingBand {
 public:
  /// `inside`: all axis pieces inside the ring at `level` mm; `radius` of the cutter, mm.
  RingBand(const std::vector<AxisPiece>& inside, double level, double radius);

  /// The worst place if the next ring is `step` mm farther inside, with radius <= step <= 2 radius. The
  /// cause is kNone if no path is longer than `reach` mm: the radius less the required overlap of passes.
  /// Cost O(n log n) for n axis pieces.
  Rest worst(double step, double reach) const;

  /// mm; the widest step between radius and radius + reach without residual, to 1e-4 mm. If a centre limits the step,
  /// the next ring stays a fiftieth of the radius below that centre.
  double widest_step(double reach) const;

 private:
  struct Vertex {
    Vec2 point;
    double clearance = 0;
    double summit = 0;  ///< greatest clearance reached from here by a rising path along the axis, mm
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

  double floor_ = 0;  ///< mm; level + radius and a little more, because thinner rests do not count
  double level_ = 0;
  double radius_ = 0;
  std::vector<Vertex> vertices_;
  std::vector<Link> links_;
};

}  // namespace clearcut::plan::contour
