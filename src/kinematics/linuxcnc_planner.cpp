// LinuxCNC's trajectory planner. Symbols of its documentation ("Trajectory Control", "Planner parameters"
// [TRAJ]ARC_BLEND_*) and of R. Ellenberg's blend arcs:
//   T      tolerance of G64 P, mm                       tolerance
//   theta  half of the angle between two segments       half_angle
//   R      radius of a blend arc, mm                     radius
//   a_n    normal acceleration, sqrt(3)/2 of the whole    kNormalShare
//   a_t    tangential acceleration on arcs, 1/2          kTangentialShare
#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "kinematics/families.h"

namespace clearcut::kinematics {
namespace {

/// s; period of the servo thread in LinuxCNC's own configurations.
constexpr double kCycle = 0.001;
/// Share of the acceleration across the path on arcs, and along the path on tight arcs: combined they are the whole
/// acceleration.
constexpr double kNormalShare = 0.86602540378443864676;
constexpr double kTangentialShare = 0.5;
/// [TRAJ]ARC_BLEND_KINK_RATIO: share of the acceleration that a corner may need in one cycle and still count as
/// tangent.
constexpr double kKinkShare = 0.1;
/// Least number of cycles of every segment.
constexpr double kFewestCycles = 1.02;
/// Cosine of 178 degrees: sharper turns are stops.
constexpr double kReversal = -0.99939082701909573;
/// Share of a segment's length: a blend never takes more from the path.
constexpr double kToleranceOfLength = 0.25;
/// Radians. Corners that are nearer to a reversal or to straight on get no blend arc.
constexpr double kLeastAngle = 1e-3;

enum class Joint : unsigned char { kStop, kTangent, kParabolic };

/// A leg, or a blend arc between two of them.
struct Segment {
  std::size_t leg = 0;
  double whole = 0;         ///< mm, before blend arcs took their part
  double length = 0;        ///< mm; its remaining length
  double asked = 0;         ///< mm/s of the program
  double top = 0;           ///< mm/s; speed limit of the machine along it
  double acceleration = 0;  ///< mm/s2; limit of the machine along it
  double radius = 0;        ///< mm; 0: straight
  bool blend = false;
  double kink_before = 0,
         kink_after = 0;  ///< shares of the acceleration used at almost tangent ends
  bool halved = false;    ///< a parabolic blend may begin or end in this segment
  Joint end = Joint::kStop;
  double through = kNoLimit;  ///< mm/s; most at its end
  double along = 0;           ///< mm/s2; remaining acceleration along the path

  double target() const { return std::min(asked, top); }
};

Segment segment_of(const Leg& leg, std::size_t number) {
  Segment segment;
  segment.leg = number;
  segment.whole = segment.length = leg.length;
  segment.asked = leg.asked();
  segment.top = std::min(leg.speed, leg.length / (kCycle * kFewestCycles));
  segment.acceleration = leg.acceleration;
  if (leg.arc) {
    // The radius of curvature of a helix is r / cos^2 of its climb.
    const double climb = leg.climb() / leg.plan;
    segment.radius = leg.move->path.radius() * (1 + climb * climb);
  }
  return segment;
}

double overall_acceleration(const Segment& segment) {
  const double left = 1 - std::max(segment.kink_before, segment.kink_after);
  return segment.acceleration * left * (segment.halved ? 0.5 : 1);
}

/// Sets the limits left by an arc's curvature, once both of its ends are known.
void finish(Segment& segment) {
  const double overall = overall_acceleration(segment);
  segment.along = overall;
  if (segment.blend) {
    segment.along *= kTangentialShare;
  } else if (segment.radius > 0) {
    const double normal = segment.top * segment.top / segment.radius;
    if (normal > kNormalShare * overall) {
      segment.top = std::sqrt(kNormalShare * overall * segment.radius);
      segment.along *= kTangentialShare;
    } else {
      const double share = normal / overall;
      segment.along *= std::sqrt(1 - share * share);
    }
  }
}

/// The acceleration needed in one cycle for a change of direction, as a share of the axes' acceleration.
double kink_of(const Leg& before, const Leg& after, double speed, const AxisLimits& limits) {
  const Vec3 change = (after.first - before.last) * (speed / kCycle + after.acceleration);
  const double share =
      std::max({std::abs(change.x) / limits.acceleration.x, std::abs(change.y) / limits.acceleration.y,
                std::abs(change.z) / limits.acceleration.z});
  return before.arc || after.arc ? share / kTangentialShare : share;
}

/// The largest circle in the plane square to `normal` within the axes' limits.
double most_in_plane(const Vec3& normal, const Vec3& of_axes) {
  const auto in_axis = [](double n, double most) {
    const double share = std::sqrt(std::max(0.0, 1 - n * n));
    return share > 1e-9 ? most / share : kNoLimit;
  };
  return std::min({in_axis(normal.x, of_axes.x), in_axis(normal.y, of_axes.y), in_axis(normal.z, of_axes.z)});
}

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// mm; P in force on a leg; infinite without one.
double stated_tolerance(const Leg& leg) {
  const double stated = leg.path.mode == PathMode::kTolerance ? leg.path.tolerance_mm.value_or(0) : 0;
  return stated > 0 ? stated : kNoLimit;
}

/// mm; greatest rounding of a corner by a parabolic blend, for which the P of the leg before it counts; without P a quarter
/// of the shorter segment.
double blend_tolerance(const Leg& before, const Segment& a, const Segment& b) {
  return std::min(stated_tolerance(before), kToleranceOfLength * std::min(a.whole, b.whole));
}

/// A corner of the path.
struct Corner {
  double turn = 0;  ///< radians; 0: straight on
  /// Radians; the turn for blend arcs: measured between chords for arcs that curve in the same direction as
  /// the corner.
  double bent = 0;
  double tolerance = 0;  ///< mm, of blend arcs: the finer one of both legs
  double goal = 0;       ///< mm/s, of the slower side
};

double half_angle(double turn) {
  return (kPi - turn) / 2;
}

/// Shares of an arc's sweep by which its chord at the corner deviates from its tangent.
constexpr double kChordBefore = 1.0 / 3, kChordAfter = 1.0 / 6;
/// Radians by which a corner is sharper than its tangents if an arc curves in the same direction: the previous arc,
/// else the next one.
double chord_turn(const Leg& before, const Leg& after, double turn) {
  const double left = before.last.x * after.first.y - before.last.y * after.first.x;
  const auto inwards = [&](const Leg& leg) { return leg.arc && leg.move->path.sweep() * left > 0; };
  const double most = half_angle(turn) / 2;
  if (inwards(before)) return std::min(kChordBefore * std::abs(before.move->path.sweep()), most);
  if (inwards(after)) return std::min(kChordAfter * std::abs(after.move->path.sweep()), most);
  return 0;
}

/// mm of a segment that a blend arc may take; arcs are near their tangent only over this length.
double room_on(const Leg& leg, const Segment& segment) {
  const double half = std::min(segment.length, segment.whole / 2);
  if (!leg.arc) return half;
  const double sweep = std::abs(leg.move->path.sweep());
  return std::min(half, segment.radius * base::sin(std::min(sweep * 2 / 3, kPi / 3) / 4));
}

/// A blend arc and the lengths it takes from the segments on both sides, mm.
struct Blend {
  Segment arc;
  double of_before = 0, of_after = 0;
};

/// Cycles; if a blend arc leaves less of the previous line, this rest becomes part of the arc
/// ([TRAJ]ARC_BLEND_GAP_CYCLES).
constexpr double kGapCycles = 4;

/// Two legs that follow each other, and their segments.
struct LegPair {
  const Leg& before;
  const Leg& after;
  const Segment& a;
  const Segment& b;
};

/// The blend arc; of length 0 if there is none.
Blend blend_arc(const LegPair& pair, const Corner& corner, const AxisLimits& limits) {
  const auto& [before, after, a, b] = pair;
  Blend blend;
  Segment& arc = blend.arc;
  arc.blend = true;
  const double half = half_angle(corner.bent);
  const bool flat = before.climb() == 0 && after.climb() == 0;
  if ((before.arc || after.arc) && !flat) return blend;
  if (half < kLeastAngle || corner.turn < kLeastAngle / 2) return blend;
  const Vec3 square = cross(before.last, after.first);
  const Vec3 normal = square * (1 / norm(square));
  const double sine = base::sin(half), tangent = base::tan(half);
  const double by_tolerance = base::cos(half) * corner.tolerance / (1 - sine);
  const double taken = std::min({by_tolerance, room_on(before, a), room_on(after, b)});
  arc.acceleration = most_in_plane(normal, limits.acceleration);
  const double across = kNormalShare * arc.acceleration;
  arc.radius = tangent * taken;
  const double speed = std::min(std::sqrt(across * arc.radius), corner.goal);
  arc.length = corner.turn * arc.radius;
  arc.asked = std::min(a.asked, b.asked);
  blend.of_before = blend.of_after = taken;
  const double left = a.length - blend.of_before;
  if (!before.arc && left < kGapCycles * kCycle * speed) {
    blend.of_before = a.length;
    arc.length += std::max(0.0, left);
  }
  arc.whole = arc.length;
  arc.top = std::min(speed, arc.length / (kCycle * kFewestCycles));
  return blend;
}

/// The acceleration that a parabolic blend may use on each side: sqrt(3)/4 of the whole, and on arcs half of this.
double for_parabola(const Segment& segment) {
  const double both = segment.acceleration * kNormalShare / 2;
  return segment.radius > 0 ? both * kTangentialShare : both;
}

/// Direction of the acceleration at the start of a leg: on arcs between the tangent and the centre, as measured.
Vec3 begins_towards(const Leg& leg, const Segment& segment) {
  if (!leg.arc) return leg.first;
  constexpr double kTangential = 0.457;
  const double normal = segment.asked * segment.asked / 4 / segment.radius;
  const double left = leg.move->path.sweep() > 0 ? 1 : -1;
  const Vec3 to_center{-leg.first.y * left, leg.first.x * left, 0};
  const Vec3 sum = leg.first * (kTangential * segment.acceleration) + to_center * normal;
  return sum * (1 / norm(sum));
}

/// A parabolic blend between two segments.
struct Parabola {
  /// mm/s; speed from which the previous segment comes to rest while the next one accelerates.
  double speed = 0;
  double along = 0;  ///< mm/s in the direction of the blend
};

Parabola parabola(const Leg& before, const Leg& after, const Segment& a, const Segment& b, double tolerance) {
  const double a_along = for_parabola(a), b_along = for_parabola(b);
  const double v_a = std::min(std::sqrt(a_along * a.length), a.target());
  const double v_b = std::min(std::sqrt(b_along * b.length), b.target());
  const double longest = std::min(a.length / v_a, b.length / v_b);
  const double time = std::min(longest, std::max(v_a / a_along, v_b / b_along));
  double from = std::min(v_a, time * a_along), to = std::min(v_b, time * b_along);
  const double straight = std::clamp(dot(before.last, begins_towards(after, b)), -1.0, 1.0);
  const double half = half_angle(base::acos(straight));
  const double cosine = base::cos(half);
  if (tolerance > 0 && cosine > kLeastAngle) {
    const double most = 2 * std::sqrt(a_along * tolerance / cosine);
    from = std::min(from, most);
    to = std::min(to, most);
  }
  return {from, base::sin(half) * (from + to) / 2};
}

bool stops_at_all_ends(const Leg& leg) {
  return leg.path.mode == PathMode::kExactStop;
}

bool may_blend(const Leg& leg) {
  return !stops_at_all_ends(leg) && leg.path.mode != PathMode::kExactPath;
}

/// The segments of a program with the blends between them.
class Trajectory {
 public:
  Trajectory(std::span<const Leg> legs, const AxisLimits& limits) : legs_(legs), limits_(limits) {
    segments_.reserve(2 * legs.size());
    for (std::size_t i = 0; i < legs.size(); ++i) {
      segments_.push_back(segment_of(legs[i], i));
      if (i > 0 && !legs[i].from_rest) join();
      // The last segment of a queue waits for a successor that never comes: it is planned as if blended.
      const bool last = i + 1 == legs.size() || legs[i + 1].from_rest;
      if (last && may_blend(legs[i])) segments_.back().halved = true;
    }
    for (Segment& segment : segments_) finish(segment);
    plan_speeds();
  }

  void add_times(std::vector<Seconds>& times) const;

 private:
  void join();
  void plan_speeds();

  std::span<const Leg> legs_;
  const AxisLimits& limits_;
  std::vector<Segment> segments_;
  std::vector<double> speeds_;  ///< mm/s at the start of each segment, and 0 after the last
};

/// Decides the transition from the segment before the last to the last one.
void Trajectory::join() {
  Segment& b = segments_.back();
  Segment& a = segments_[segments_.size() - 2];
  const Leg &before = legs_[a.leg], &after = legs_[b.leg];
  const double cosine = std::clamp(dot(before.last, after.first), -1.0, 1.0);
  if (before.rapid != after.rapid || stops_at_all_ends(before) || cosine < kReversal) return;
  const double goal = std::min(a.target(), b.target());
  const double kink = kink_of(before, after, goal, limits_);
  if (kink < kKinkShare) {
    a.end = Joint::kTangent;
    a.through = goal;
    a.kink_after = b.kink_before = kink;
    return;
  }
  if (!may_blend(before)) {
    a.kink_after = b.kink_before = kKinkShare;  // also under G61, where it then stops
    return;
  }
  Corner corner;
  corner.turn = base::atan2(norm(cross(before.last, after.first)), cosine);
  corner.bent = corner.turn + chord_turn(before, after, corner.turn);
  const double of_parabola = blend_tolerance(before, a, b);
  corner.tolerance = std::min(of_parabola, stated_tolerance(after));
  corner.goal = goal;
  Blend rounded = blend_arc({before, after, a, b}, corner, limits_);
  Segment& arc = rounded.arc;
  const double slowed = goal * kKinkShare / kink;
  const Parabola blend = parabola(before, after, a, b, of_parabola);
  const double by_arc = arc.length > 0 ? arc.top : 0;
  if (by_arc >= std::max(slowed, blend.along / 2)) {
    a.length = std::max(0.0, a.length - rounded.of_before);
    b.length = std::max(0.0, b.length - rounded.of_after);
    a.end = arc.end = Joint::kTangent;
    arc.leg = b.leg;
    const Segment rest = b;
    segments_.back() = arc;
    segments_.push_back(rest);
  } else if (slowed >= blend.along / 2) {
    a.end = Joint::kTangent;
    a.through = slowed;
    a.kink_after = b.kink_before = kKinkShare;
  } else {
    a.end = Joint::kParabolic;
    a.halved = b.halved = true;
  }
}

void Trajectory::plan_speeds() {
  const std::size_t count = segments_.size();
  speeds_.assign(count + 1, 0.0);
  for (std::size_t k = count; k-- > 1;) {
    const Segment &a = segments_[k - 1], &b = segments_[k];
    if (a.end != Joint::kTangent) continue;
    const double back = std::sqrt(speeds_[k + 1] * speeds_[k + 1] + 2 * b.along * b.length);
    speeds_[k] = std::min({back, a.through, a.target(), b.target()});
  }
  for (std::size_t k = 0; k < count; ++k) {
    const Segment& s = segments_[k];
    speeds_[k + 1] = std::min(speeds_[k + 1], std::sqrt(speeds_[k] * speeds_[k] + 2 * s.along * s.length));
  }
}

void Trajectory::add_times(std::vector<Seconds>& times) const {
  for (std::size_t k = 0; k < segments_.size(); ++k) {
    const Segment& s = segments_[k];
    double time = ramped_time(s.length, speeds_[k], speeds_[k + 1], s.target(), s.along);
    if (s.end == Joint::kParabolic) {
      const Segment& b = segments_[k + 1];
      const Leg &before = legs_[s.leg], &after = legs_[b.leg];
      time -= parabola(before, after, s, b, blend_tolerance(before, s, b)).speed / s.along;
    }
    if (speeds_[k + 1] == 0)
      time += kCycle / 2;  // the last cycle before a standstill is half used at the mean
    Seconds& sum = times[legs_[s.leg].index];
    sum = sum + Seconds::of(std::max(0.0, time));
  }
}

}  // namespace

void plan_linuxcnc(std::span<const Leg> legs, const Machine& machine, std::vector<Seconds>& times) {
  const AxisLimits limits = axis_limits(machine);
  Trajectory(legs, limits).add_times(times);
}

}  // namespace clearcut::kinematics
