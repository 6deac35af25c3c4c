#include "plan/common/round_corners.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/elementary.h"
#include "base/units.h"
#include "geometry/spatial/cell_grid.h"
#include "plan/common/cover.h"
#include "plan/common/machine_clock.h"
#include "plan/common/outer_rim.h"

namespace clearcut::plan {
namespace {

/// Radians. Machines hardly slow down in smaller turns; larger turns are reversals of detours.
constexpr double kLeastRounded = 0.04;
constexpr double kMostRounded = 2.8;
/// Share of a straight move available to the arc at its beginning, and share of the remainder available to the arc at
/// its end.
constexpr double kTaken = 0.5;
constexpr double kTakenOfRest = 0.9;
/// Shares of the cutter's radius: the widest and the tightest tried arc. Wider arcs gain no speed, tighter ones
/// little.
constexpr double kWidest = 4;
constexpr double kTightest = 0.04;
/// Factor from one tried radius to the next.
constexpr double kSmaller = 0.6;
/// mm by which the check's radius is less than the cutter's: more than any program's rounding.
constexpr double kRoundingMargin = 0.001;
/// Factor by which accelerating beside an arc takes longer.
constexpr double kArcLoss = 1.5;
/// mm, tolerance of the blends of programs; s, least time saved by a rounded corner, since every additional move
/// costs some.
constexpr double kBlend = 5e-4;
constexpr double kLeastGain = 1e-3;
/// Radians; pieces of arcs whose legality is tested at once.
constexpr double kLegalPiece = 0.4;

bool is_legal_arc(const Edge& arc, const LegalArea& legal) {
  const int pieces = static_cast<int>(std::abs(arc.sweep()) / kLegalPiece) + 1;
  const double half = arc.sweep() / (2 * pieces), out = 1 / base::cos(half);
  for (int i = 0; i < pieces; ++i) {
    const Vec2 a = arc.at(static_cast<double>(i) / pieces), b = arc.at((i + 1.0) / pieces),
               beyond = arc.center + rotated(a - arc.center, half) * out;
    if (!legal.holds_line(a, b) || !legal.holds_line(a, beyond) || !legal.holds_line(beyond, b)) return false;
  }
  return true;
}

/// A corner with an arc in its place: from `first` to `arc` to `second`.
struct RoundedCorner {
  Edge first, arc, second;
};

class Rounder {
 public:
  explicit Rounder(const RoundingJob& job) : job_(job), index_(2 * job.radius) {}

  void run(std::vector<Pass>& passes) {
    std::vector<std::uint32_t> first_of;
    for (const Pass& pass : passes) {
      first_of.push_back(static_cast<std::uint32_t>(edges_.size()));
      for (const Edge& edge : pass.path) add(edge);
    }
    for (std::size_t i = 0; i < passes.size(); ++i)
      if (passes[i].kinds.empty()) round(passes[i].path, first_of[i]);
  }

 private:
  std::uint32_t add(const Edge& edge) {
    const auto number = static_cast<std::uint32_t>(edges_.size());
    edges_.push_back(edge);
    used_.push_back(edge.from == edge.to ? 0 : 1);
    index_.add(edge.from == edge.to ? Box{edge.from, edge.to} : edge.box(), number);
    return number;
  }

  /// `first`: the number of the path's first edge; the others follow it.
  void round(Path& path, std::uint32_t first) {
    Path rounded;
    std::uint32_t last = 0;  // number of the last edge of `rounded`
    for (std::size_t i = 0; i < path.size(); ++i) {
      const std::uint32_t next = first + static_cast<std::uint32_t>(i);
      std::optional<RoundedCorner> corner;
      if (i > 0) corner = rounded_corner({rounded.back(), last}, {path[i], next});
      if (corner) {
        used_[last] = used_[next] = 0;
        rounded.back() = corner->first;
        add(corner->first);
        add(corner->arc);
        last = add(corner->second);
        rounded.push_back(corner->arc);
        rounded.push_back(corner->second);
      } else {
        rounded.push_back(path[i]);
        last = next;
      }
    }
    path = std::move(rounded);
  }

  struct Side {
    Edge edge;
    std::uint32_t number = 0;
  };

  std::optional<RoundedCorner> rounded_corner(const Side& before, const Side& after) {
    if (before.edge.is_arc() || after.edge.is_arc() || before.edge.to != after.edge.from) return std::nullopt;
    const double room = std::min(kTakenOfRest * distance(before.edge.from, before.edge.to),
                                 kTaken * distance(after.edge.from, after.edge.to));
    if (room <= 0) return std::nullopt;
    const Vec2 in = unit(before.edge.to - before.edge.from), out = unit(after.edge.to - after.edge.from);
    const double turn = base::atan2(std::abs(cross(in, out)), dot(in, out));
    if (turn < kLeastRounded || turn > kMostRounded) return std::nullopt;
    const double tangent = base::tan(turn / 2);
    double radius = std::min(room / tangent, kWidest * job_.radius);
    if (radius < kTightest * job_.radius || clears_alone(before, after, in, out)) return std::nullopt;
    for (; radius >= kTightest * job_.radius; radius *= kSmaller) {
      if (!saves_time(turn, radius)) return std::nullopt;
      const RoundedCorner corner = with_arc(before.edge, after.edge, radius, radius * tangent);
      if (is_legal_arc(corner.arc, *job_.legal) && leaves_nothing(before, after, corner)) return corner;
    }
    return std::nullopt;
  }

  /// Whether the machine loses less time on an arc than in the corner. Speed in the corner: that of a control that
  /// blends within kBlend. Speed on the arc: the one allowed by the acceleration across; arcs leave half of the
  /// acceleration for gaining speed.
  bool saves_time(double turn, double radius) const {
    const double v = job_.speed, a = job_.acceleration;
    if (v <= 0 || a <= 0) return true;
    const double across = kAcrossArcs * a, through = std::min(v, std::sqrt(8 * across * kBlend) / turn),
                 round = std::min(v, std::sqrt(across * radius));
    const auto lost = [&](double speed) { return (v - speed) * (v - speed) / (v * a); };
    const double on_arc = turn * radius * (1 / round - 1 / v) + kArcLoss * lost(round);
    return lost(through) - on_arc > kLeastGain;
  }

  static RoundedCorner with_arc(const Edge& before, const Edge& after, double radius, double taken) {
    const Vec2 in = unit(before.to - before.from), out = unit(after.to - after.from);
    const Vec2 a = before.to - in * taken, b = after.from + out * taken;
    const bool left = cross(in, out) > 0;
    const Vec2 center = a + left_of(in) * (left ? radius : -radius);
    return {Edge::line(before.from, a),
            Edge::arc(a, b, center, left ? Turn::kCounterClockwise : Turn::kClockwise),
            Edge::line(b, after.to)};
  }

  /// Whether no other edge clears the outermost place cleared by the corner.
  bool clears_alone(const Side& before, const Side& after, Vec2 in, Vec2 out) const {
    const Vec2 place = before.edge.to + unit(in - out) * (job_.proven - kAtRim);
    const double reach = job_.proven - 2 * kAtRim;
    const auto near = index_.near(Box{place, place}.grown(job_.proven));
    return std::none_of(near.begin(), near.end(), [&](std::uint32_t i) {
      return used_[i] != 0 && i != before.number && i != after.number && distance(edges_[i], place) <= reach;
    });
  }

  bool leaves_nothing(const Side& before, const Side& after, const RoundedCorner& corner) const {
    const Edge first = Edge::line(corner.arc.from, before.edge.to),
               second = Edge::line(after.edge.from, corner.arc.to);
    Box both = first.box();
    both.add(second.box());
    const Box near = both.grown(2 * job_.proven);
    std::vector<Edge> edges{corner.first, corner.arc, corner.second};
    for (const std::uint32_t i : index_.near(near)) {
      if (used_[i] != 0 && i != before.number && i != after.number && near.overlaps(edges_[i].box()))
        edges.push_back(edges_[i]);
    }
    const double deviation = distance(corner.arc, before.edge.to) + kAtRim;
    if (clear_outer_rim(first, second, edges, job_.proven, deviation)) return true;
    if (!clear_outer_rim(first, second, edges, job_.proven, 0)) return false;
    const auto was_cut = [&](Vec2 q) {
      return distance(first, q) <= job_.proven || distance(second, q) <= job_.proven;
    };
    const Box where = both.grown(job_.proven);
    return !Cover(edges, job_.proven, where).has_hole(where, was_cut);
  }

  const RoundingJob& job_;
  std::vector<Edge> edges_;
  std::vector<char> used_;  ///< per edge: whether the edge is still part of a pass
  BoxIndex index_;          ///< index of the places of edges
};

}  // namespace

double proven_radius(double tool_radius, double residual) {
  return residual > 0 ? tool_radius + residual : tool_radius - kRoundingMargin;
}

void round_corners(std::vector<Pass>& passes, const RoundingJob& job) {
  Rounder(job).run(passes);
}

void round_corners(LayerPasses& layer, double radius, double speed, double acceleration) {
  const LegalArea legal(layer.legal);
  round_corners(layer.passes, {radius, proven_radius(radius, layer.residual), &legal, speed, acceleration});
}

}  // namespace clearcut::plan
