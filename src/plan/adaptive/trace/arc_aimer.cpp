#include "plan/adaptive/trace/arc_aimer.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "plan/adaptive/clearing/arcs.h"
#include "plan/adaptive/clearing/parameters.h"

namespace clearcut::plan::adaptive {
namespace {

/// Shares of the tool radius: distance between samples of the engagement along a candidate, and between
/// samples of its position, which are also at most kAsideTurn radians apart.
constexpr double kSamplePitch = 0.4;
constexpr double kAsideSpan = 0.1;
constexpr double kAsideTurn = 0.25;
/// Shares of the tool radius: length of the candidate that is tried first, of the shortest and of the
/// longest.
constexpr double kFirst = 1.0;
constexpr double kShortestArc = 0.02;
constexpr double kLongestArc = 12;
/// Share of the tool radius: radius of the tightest turn to the right, towards the material.
constexpr double kRightTurn = 1.0;
/// Share of the tool radius: distance from a wall at which a cut counts as having left it; and the greatest
/// turn until then, radians.
constexpr double kOffWall = 0.005;
constexpr double kLargestOff = 1.27;
/// Share of the tool radius: length in which the engagement rises to its limit if it was below.
constexpr double kRise = 0.5;
/// Crossings, in shares of the tool radius: the tightest radius, the greatest length, the distance between
/// samples.
constexpr double kTightestAcross = 0.3;
constexpr double kLongestAcross = 3.5;
constexpr double kSampleAcross = 0.3;
/// How far the engagement of an arc may stay below the limit, summed along the arc: kBelow radians over its
/// length (at most kShortBelow tool radii) and one tool radius more, and kLongBelow radians over all of its
/// length.
constexpr double kBelow = 0.06;
constexpr double kShortBelow = 2.0;
constexpr double kLongBelow = 0.01;
/// Radians. An engagement this near to the aimed one is accepted.
constexpr double kAimed = 0.006;
/// Radians: greatest turn of one arc.
constexpr double kMostTurn = 2.0;
/// Number of samples along an arc that is sampled closely.
constexpr int kCloseSamples = 8;
/// Radians. A turn between two samples smaller than twice this is computed as straight.
constexpr double kFlatTurn = 5e-10;
/// Factor between curvatures tried for a crossing; factor within which two are taken for equal; number of
/// tries, and of tries with close samples; share of a crossing's length that may be lost.
constexpr double kOtherCurvature = 1.15;
constexpr double kCloseCurvature = 1.05;
constexpr int kMostAcross = 7;
constexpr int kMostTighter = 5;
constexpr double kMostLost = 0.11;
/// Radians: greatest kink. A machine with 500 mm/s2 and a junction deviation of 0.01 mm need not brake for it
/// up to 2500 mm/min.
constexpr double kMostKink = 0.15;
/// Radians. Arcs that begin more than this below the limit get no kink. Number of corrections until an arc
/// with a kink is aimed.
constexpr double kMostRise = 0.1;
constexpr int kMostBends = 5;
/// Share of its length by which an arc aimed at a wall may become longer.
constexpr double kToWall = 0.2;

/// u turned by the angle of the unit vector v.
Vec2 turned(Vec2 u, Vec2 v) {
  return {u.x * v.x - u.y * v.y, u.x * v.y + u.y * v.x};
}

/// Points and headings along a candidate at equal distances. Each is computed from the one before, which is
/// cheaper.
class Strides {
 public:
  Strides(const CutterState& from, const CandidateArc& candidate, double stride)
      : at_{from.point, candidate.kink == 0 ? from.heading : rotated(from.heading, candidate.kink)} {
    const double half = candidate.curvature * stride / 2;
    half_turn_ = {base::cos(half), base::sin(half)};
    chord_ = std::abs(half) < kFlatTurn ? stride : 2 * half_turn_.y / candidate.curvature;
  }

  const Heading& next() {
    const Vec2 middle = turned(at_.heading, half_turn_);
    at_ = {at_.point + middle * chord_, turned(middle, half_turn_)};
    return at_;
  }

 private:
  Heading at_;
  Vec2 half_turn_;
  double chord_ = 0;
};

}  // namespace

Heading after(const CutterState& from, const CandidateArc& candidate, double length) {
  return Strides(from, candidate, length).next();
}

Edge edge_of(const CutterState& from, const CandidateArc& candidate) {
  const Vec2 to = after(from, candidate, candidate.length).point;
  const double radius = 1 / candidate.curvature,
               sagitta = candidate.length * candidate.length * candidate.curvature / 8;
  if (std::abs(sagitta) < kShortestMove) return Edge::line(from.point, to);
  return Edge::arc(from.point, to, from.point + rotated(left_of(from.heading), candidate.kink) * radius,
                   radius > 0 ? Turn::kCounterClockwise : Turn::kClockwise);
}

Edge arc_to(const CutterState& from, double kink, Vec2 p) {
  const Vec2 heading = rotated(from.heading, kink);
  // The sagitta is a quarter of the distance of p from the line along the heading.
  if (std::abs(cross(heading, p - from.point)) < 4 * kShortestMove) return Edge::line(from.point, p);
  return tangent_arc(from.point, heading, p);
}

ArcAimer::ArcAimer(const RemainingStock& remaining, const Regions& area, double limit)
    : remaining_(remaining), area_(area), radius_(remaining.tool_radius()), limit_(limit) {}

double ArcAimer::engagement_after(const CutterState& from, const CandidateArc& candidate,
                                  double length) const {
  return engagement_at(after(from, candidate, length));
}

double ArcAimer::engagement_at(const Heading& at) const {
  return remaining_.engagement(at.point, at.heading);
}

std::optional<CandidateArc> ArcAimer::find_candidate(const CutterState& from) const {
  std::optional<CandidateArc> best;
  double good = 0, bad = 2 * kLongestArc * radius_;
  double length = std::clamp(from.usual, kShortestArc * radius_, kFirst * radius_);
  double guess = from.curvature;
  for (int i = 0; i < 12; ++i) {
    const auto candidate = steady_candidate(from, length, guess);
    if (candidate) {
      best = candidate;
      guess = candidate->curvature;
      good = length;
    } else {
      bad = length;
    }
    if (bad < good * 1.4 || good >= kLongestArc * radius_ || (best && best->meets_wall)) break;
    length = good == 0 ? length / 2 : std::min(good * 2, std::sqrt(good * bad));
    if (length < kShortestArc * radius_) break;
  }
  if (best) return best;
  return find_candidate_closely(from, guess);
}

/// A candidate of this length, or up to the wall ahead, if its engagement is steady.
std::optional<CandidateArc> ArcAimer::steady_candidate(const CutterState& from, double length,
                                                       double guess) const {
  auto candidate = aim(from, length, guess, 1);
  if (!candidate) return std::nullopt;
  const double ahead = length_inside(from, *candidate);
  const bool to_wall = ahead < length;
  if (to_wall) {
    if (ahead < kShortestArc * radius_) return CandidateArc{candidate->curvature, ahead, 0, true};
    candidate = aim(from, ahead, candidate->curvature, 1);
    if (!candidate) return std::nullopt;
  }
  if (!is_steady(from, *candidate)) candidate = bend(from, *candidate);
  if (!candidate || !is_steady(from, *candidate)) return std::nullopt;
  if (to_wall) {
    const double beyond = ahead * (1 + kToWall);
    candidate->length = length_inside(from, {candidate->curvature, beyond, candidate->kink});
    candidate->meets_wall = candidate->length < beyond;
    if (!candidate->meets_wall) candidate->length = ahead;
  }
  return candidate;
}

/// The candidate of this length that has the engagement at the limit at its end, or at the highest of
/// `samples` samples, or as near below the limit as the allowed turns permit.
std::optional<CandidateArc> ArcAimer::aim(const CutterState& from, double length, double guess,
                                          int samples) const {
  const double rightmost = std::max(-1 / (kRightTurn * radius_), -kMostTurn / length);
  const double leftmost = std::min(1 / from.tightest, kMostTurn / length);
  double right = rightmost, left = leftmost;  // curvatures with too much and with too little engagement
  const double slope = length + length * length / (2 * radius_ * base::sin(limit_));
  CandidateArc candidate{std::clamp(guess, right, left), length};
  std::optional<CandidateArc> best;
  for (int i = 0; i < 8; ++i) {
    double excess = engagement_after(from, candidate, length) - limit_;
    // Samples are denser near the beginning.
    for (int k = 1; k < samples; ++k)
      excess =
          std::max(excess, engagement_after(from, candidate, length * k * k / (samples * samples)) - limit_);
    if (excess <= kAimed) best = candidate;
    if (std::abs(excess) <= kAimed) break;
    if (candidate.curvature == (excess > 0 ? leftmost : rightmost)) break;
    (excess > 0 ? right : left) = candidate.curvature;
    const double next = candidate.curvature + excess / slope;
    if (next > right && next < left) {
      candidate.curvature = next;
    } else if (excess > 0 ? left == leftmost : right == rightmost) {
      candidate.curvature = excess > 0 ? left : right;
    } else {
      candidate.curvature = (right + left) / 2;
    }
  }
  return best;
}

/// The candidate with a kink at its beginning, chosen so that the engagement is at the limit in its middle,
/// too.
std::optional<CandidateArc> ArcAimer::bend(const CutterState& from, CandidateArc candidate) const {
  if (from.engagement < limit_ - kMostRise) return std::nullopt;
  const double whole = candidate.length, half = whole / 2, q = 1 / (radius_ * base::sin(limit_));
  for (int i = 0; i < kMostBends; ++i) {
    const double at_half = engagement_after(from, candidate, half) - limit_ - EngagementTolerance::kPeak,
                 at_end = engagement_after(from, candidate, whole) - limit_ - EngagementTolerance::kPeak;
    if (std::max(std::abs(at_half), std::abs(at_end)) <= kAimed) return candidate;
    // The engagement falls by 1 per radian that the heading turns to the left, and by q per mm that the
    // cutter is to the left.
    const double a = 1 + q * half, b = half + q * half * half / 2, c = 1 + q * whole,
                 d = whole + q * whole * whole / 2;
    candidate.kink += (at_half * d - at_end * b) / (a * d - b * c);
    candidate.curvature += (at_end * a - at_half * c) / (a * d - b * c);
    if (std::abs(candidate.kink) > kMostKink || candidate.curvature > 1 / from.tightest ||
        candidate.curvature < -1 / (kRightTurn * radius_) ||
        std::abs(candidate.curvature) * whole > kMostTurn)
      return std::nullopt;
  }
  return std::nullopt;
}

/// Whether the engagement stays near its limit all along: never above, and not far below in the mean.
bool ArcAimer::is_steady(const CutterState& from, const CandidateArc& candidate) const {
  const int samples = static_cast<int>(candidate.length / (kSamplePitch * radius_)) + 2;
  double missing = 0;
  Strides strides(from, candidate, candidate.length / (samples + 1));
  for (int i = 1; i <= samples; ++i) {
    const double engagement = engagement_at(strides.next());
    if (engagement > limit_ + EngagementTolerance::kExcess) return false;
    missing += std::max(0.0, limit_ - engagement) * candidate.length / samples;
  }
  const double rise = std::max(0.0, limit_ - from.engagement) * kRise * radius_;
  return missing <= kBelow * (std::min(candidate.length, kShortBelow * radius_) + radius_) +
                        kLongBelow * candidate.length + rise;
}

std::optional<CandidateArc> ArcAimer::find_candidate_closely(const CutterState& from, double guess) const {
  for (const double share : {8, 2}) {
    if (const auto candidate = aim(from, share * kShortestArc * radius_, guess, kCloseSamples))
      return candidate;
  }
  return std::nullopt;
}

std::optional<Crossing> ArcAimer::across(const CutterState& from, double guess) const {
  const double tightest = 1 / (kTightestAcross * radius_);
  std::optional<Crossing> best;
  double exceeding = 0, missing = tightest;
  double curvature = guess;
  for (int i = 0; i < kMostAcross && missing > exceeding * kCloseCurvature; ++i) {
    Crossing crossing;
    const Fit fit = cross(from, curvature, crossing);
    if (fit == Fit::kFits) best = crossing;
    (fit == Fit::kExceeds ? exceeding : missing) = curvature;
    if (exceeding == 0) {
      curvature /= kOtherCurvature;
    } else {
      curvature = best || missing < curvature * kOtherCurvature
                      ? (exceeding + missing) / 2
                      : std::min(tightest, curvature * kOtherCurvature);
    }
  }
  return best;
}

bool ArcAimer::meets_wall(const CutterState& from, double curvature) const {
  const double longest = kLongestAcross * radius_;
  return length_inside(from, {curvature, longest}) < longest;
}

/// Tries the arc of that curvature up to the wall ahead; describes it in `crossing`.
ArcAimer::Fit ArcAimer::cross(const CutterState& from, double curvature, Crossing& crossing) const {
  const double longest = std::min(kLongestAcross * radius_, kMostTurn / curvature);
  CandidateArc& candidate = crossing.candidate;
  candidate = {curvature, length_inside(from, {curvature, longest}), 0, true};
  if (candidate.length >= longest) return Fit::kMissesWall;
  const double full = 1 - base::cos(limit_);
  const int samples = static_cast<int>(candidate.length / (kSampleAcross * radius_)) + 3;
  Strides strides(from, candidate, candidate.length / samples);
  for (int i = 1; i < samples; ++i) {
    const double engagement = engagement_at(strides.next());
    if (engagement > limit_ + EngagementTolerance::kLongExcess) return Fit::kExceeds;
    crossing.lost += std::max(0.0, 1 - (1 - base::cos(engagement)) / full) * candidate.length / (samples - 1);
  }
  return Fit::kFits;
}

bool Crossing::loses_little() const {
  return lost <= kMostLost * candidate.length;
}

std::optional<CandidateArc> ArcAimer::to_wall(const CutterState& from, const CandidateArc& candidate) const {
  if (candidate.meets_wall || candidate.curvature <= 0 || !meets_wall(from, candidate.curvature))
    return std::nullopt;
  const auto crossing = across(from, candidate.curvature);
  return crossing && crossing->loses_little() ? surely_within(from, crossing->candidate) : std::nullopt;
}

std::optional<CandidateArc> ArcAimer::surely_within(const CutterState& from, CandidateArc across) const {
  for (int i = 0; i < kMostTighter; ++i) {
    const Edge edge = edge_of(from, across);
    if (remaining_.length_within(edge, limit_ + EngagementTolerance::kExcess) >= edge.length()) return across;
    Crossing tighter;
    if (cross(from, across.curvature * kCloseCurvature, tighter) != Fit::kFits) return std::nullopt;
    across = tighter.candidate;
  }
  return std::nullopt;
}

double ArcAimer::length_inside(const CutterState& from, const CandidateArc& candidate) const {
  // So close that no wall between two samples is missed: walls that bend into the area have at least the
  // cutter's radius.
  const double by_length = candidate.length / (kAsideSpan * radius_),
               by_turn = std::abs(candidate.curvature) * candidate.length / kAsideTurn;
  const int samples = static_cast<int>(std::max(by_length, by_turn)) + 1;
  const double off = length_off(from, candidate);
  double inside = std::min(off, candidate.length);
  Strides strides(from, candidate, candidate.length / samples);
  for (int i = 1; i <= samples; ++i) {
    const double length = candidate.length * i / samples;
    const Vec2 p = strides.next().point;
    if (length <= off) continue;
    if (area_.contains(p)) {
      inside = length;
      continue;
    }
    double outside = length;
    for (int k = 0; k < 25; ++k) {
      const double middle = (inside + outside) / 2;
      (area_.contains(after(from, candidate, middle).point) ? inside : outside) = middle;
    }
    return inside;
  }
  return candidate.length;
}

bool ArcAimer::leaves_wall(const CutterState& from, const CandidateArc& candidate) const {
  const double off = length_off(from, candidate);
  if (off <= 0 || off > candidate.length / 2) return false;
  for (const double share : {0.15, 0.5, 1.0}) {
    if (!remaining_.legal().contains(after(from, candidate, share * off).point)) return false;
  }
  const int samples = static_cast<int>((candidate.length - off) / (kAsideSpan * radius_)) + 1;
  for (int i = 0; i <= samples; ++i) {
    if (!area_.contains(after(from, candidate, off + (candidate.length - off) * i / samples).point))
      return false;
  }
  return true;
}

double ArcAimer::length_off(const CutterState& from, const CandidateArc& candidate) const {
  if (!from.off_wall) return 0;
  // After a length x the cutter is x slope + x^2 curvature / 2 off the wall.
  const double slope = base::sin(*from.off_wall + candidate.kink), aside = kOffWall * radius_,
               root = slope * slope + 2 * candidate.curvature * aside;
  const double rate = root < 0 ? 0 : slope + std::sqrt(root);
  return rate > 0 ? 2 * aside / rate : 0;
}

double ArcAimer::turn_off(double radius) const {
  return std::min(kLargestOff, base::acos(std::max(-1.0, 1 - kOffWall * radius_ / radius)));
}

}  // namespace clearcut::plan::adaptive
