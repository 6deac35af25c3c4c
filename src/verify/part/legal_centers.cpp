#include "verify/part/legal_centers.h"

#include <algorithm>
#include <cmath>

#include "base/tolerances.h"
#include "verify/part/trimmed_curve.h"

namespace clearcut::verify {
namespace {

/// mm, for rounding of parallel curves: a wall nearer than reach by less than this is not too near.
constexpr double kRounding = 1e-7;
/// mm. A curve on which the cutter fits only within the fit tolerance is a slot if it is this long, or this
/// far from all legal places; else the curve is the tip of a sharp corner.
constexpr double kSlot = 0.1;

/// Permitted excess of the cutter's width over its place, as shares of the fit tolerance.
struct Allowances {
  double slot;   ///< permitted intrusion into the far wall while running along the near one
  double hole;   ///< permitted intrusion into all walls around if all remaining curves are shorter than kSlot
  double point;  ///< the same at the centre of round walls
};
/// The verifier requires less than the tolerance allows, because a planner may use walls with rounded or simplified
/// edges. If nothing fits by the first row, the next rows are tried.
constexpr Allowances kAllowances[] = {{1, 0.75, 0.5}, {1.7, 0.85, 0.85}, {1.9, 0.95, 0.95}};

/// Number of walls before and after a curve's own tested first.
constexpr int kNeighbours = 3;

/// Number of rounds in which only the wall nearest to the middle of a curve's rest is tested, before all other walls.
constexpr int kProbes = 12;

using Interval = TrimmedCurve::Interval;

/// The parts of `part` outside of all intervals, which must be ascending.
std::vector<Interval> outside(const std::vector<Interval>& intervals, Interval part) {
  std::vector<Interval> rest;
  for (const Interval& i : intervals) {
    if (i.second <= part.first || i.first >= part.second) continue;
    if (i.first > part.first) rest.push_back({part.first, i.first});
    part.first = i.second;
  }
  if (part.first < part.second) rest.push_back(part);
  return rest;
}

}  // namespace

LegalCenters::LegalCenters(const FinishedPart& part, double z, double reach, double corner, const Box& area,
                           const Tolerances& tol)
    : part_(part), z_(z), reach_(reach), corner_(corner) {
  std::vector<int> walls;
  part.wall_tree().overlapping(area.grown(reach + most_farther()), [&](int i) {
    if (part.walls()[i].stands_at(z)) walls.push_back(i);
  });
  for (const Allowances& allowed : kAllowances) {
    slot_ = allowed.slot * tol.fit;
    hole_ = allowed.hole * tol.fit;
    point_ = allowed.point * tol.fit;
    add_wall_curves(walls);
    add_corner_curves(walls);
    add_end_curves(walls);
    add_tight_places();
    within_fit_ = found_.empty() || &allowed == std::begin(kAllowances);
    if (!found_.empty()) break;
    tight_.clear();
  }
  boundary_ = EdgeTree(std::move(found_));
}

void LegalCenters::add_wall_curves(const std::vector<int>& walls) {
  for (const int i : walls) {
    const Wall& wall = part_.walls()[i];
    for (const Edge& curve : parallel(wall.edge, reach_ + farther_from(wall), point_)) {
      if (curve.from == curve.to) {
        add_fit_point(curve.from);
      } else {
        add_legal_parts(curve, i);
      }
    }
  }
}

/// Adds arcs about the ends of walls at corners of the part pointing into the free area.
void LegalCenters::add_corner_curves(const std::vector<int>& walls) {
  std::vector<std::pair<Vec2, int>> starts;
  for (const int i : walls) starts.emplace_back(part_.walls()[i].edge.from, i);
  std::sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) {
    return std::make_pair(a.first.x, a.second) < std::make_pair(b.first.x, b.second);
  });
  for (const int i : walls) {
    const Wall& wall = part_.walls()[i];
    const Vec2 corner = wall.edge.to, heading = wall.edge.tangent_at(1);
    const double d = reach_ + farther_from(wall);
    bool matched = false;
    auto next = std::lower_bound(starts.begin(), starts.end(), corner.x - kSamePlaceMm,
                                 [](const auto& start, double x) { return start.first.x < x; });
    for (; next != starts.end() && next->first.x <= corner.x + kSamePlaceMm; ++next) {
      if (distance(next->first, corner) > kSamePlaceMm) continue;
      matched = true;
      const Vec2 after = part_.walls()[next->second].edge.tangent_at(0);
      if (cross(heading, after) >= 0) continue;
      const Edge arc =
          Edge::arc(corner + left_of(heading) * d, corner + left_of(after) * d, corner, Turn::kClockwise);
      if (distance(arc.from, arc.to) > kRounding) add_legal_parts(arc, i);
    }
    if (matched || (wall.flat_to && d > reach_)) continue;
    for (const Edge& half : circle(corner, d)) add_legal_parts(half.reversed(), i);
  }
}

/// Adds curves beside the ends of walls with draft cut off by the stock's side.
void LegalCenters::add_end_curves(const std::vector<int>& walls) {
  for (const int i : walls) {
    for (const Edge& end : part_.walls()[i].flat_ends(z_)) {
      for (const Edge& curve : parallel(end, reach_, 0)) add_legal_parts(curve, i);
      for (const Vec2 corner : {end.from, end.to}) {
        for (const Edge& half : circle(corner, reach_)) add_legal_parts(half.reversed(), i);
      }
    }
  }
}

void LegalCenters::add_fit_point(Vec2 p) {
  if (clearance_over_reach(p) >= -point_) found_.push_back(Edge::line(p, p));
}

void LegalCenters::add_legal_parts(const Edge& curve, int wall) {
  const auto add = [&](const Interval& part) {
    const Edge piece = curve.part(part.first, part.second);
    if (piece.from != piece.to && part_.is_free(piece.at(0.5), z_)) found_.push_back(piece);
  };
  const TrimmedCurve legal = legal_parts(curve, wall, kRounding);
  for (const Interval& part : legal.parts()) {
    if ((part.second - part.first) * legal.length() > kRounding) add(part);
  }
  if (legal.whole()) return;
  const TrimmedCurve fitting = legal_parts(curve, wall, slot_);
  for (const Interval& part : fitting.parts()) {
    for (const Interval& beyond : outside(legal.parts(), part)) {
      if ((beyond.second - beyond.first) * legal.length() > kSlot) {
        add(beyond);
      } else {
        tight_.emplace_back(curve.part(beyond.first, beyond.second), wall);
      }
    }
  }
}

/// Adds the places in holes just as wide as the cutter: only some micrometres of each wall's curve are left there,
/// without another legal place nearby. A cutter reduced all round by the permitted intrusion must fit.
void LegalCenters::add_tight_places() {
  const EdgeTree known(found_);
  for (const auto& [piece, wall] : tight_) {
    const Vec2 middle = piece.from == piece.to ? piece.from : piece.at(0.5);
    if (piece.from == piece.to || !part_.is_free(middle, z_)) continue;
    if (known.nearest(middle, kSlot + norm(piece.to - piece.from)).edge >= 0) continue;
    for (const Edge& nearer : parallel(piece, -hole_, 0)) add_fitting_parts(nearer, wall);
  }
}

void LegalCenters::add_fitting_parts(const Edge& curve, int wall) {
  if (curve.from == curve.to) return;
  const TrimmedCurve fitting = legal_parts(curve, wall, hole_ + kRounding);
  for (const Interval& part : fitting.parts()) {
    const Edge left = curve.part(part.first, part.second);
    if (left.from != left.to) found_.push_back(left);
  }
}

TrimmedCurve LegalCenters::legal_parts(const Edge& curve, int wall, double allowed) const {
  TrimmedCurve left(curve);
  const double upright = reach_ - allowed;
  const int last = static_cast<int>(part_.walls().size()) - 1;
  for (int i = std::max(0, wall - kNeighbours); i <= std::min(last, wall + kNeighbours) && !left.empty();
       ++i) {
    cut_by_wall(left, part_.walls()[i], upright);
  }
  // A wall too near to the middle of the rest removes much of it, so that few walls decide.
  for (int round = 0; round < kProbes && !left.empty(); ++round) {
    const auto stands = [&](int i) { return part_.walls()[i].stands_at(z_); };
    const auto hit = part_.wall_tree().nearest(left.middle(), upright, stands);
    if (hit.edge < 0) break;
    cut_by_wall(left, part_.walls()[hit.edge], upright);
  }
  if (left.empty()) return left;
  part_.wall_tree().within(left.middle(), upright + most_farther() + left.half(), [&](int i) {
    if (!left.empty()) cut_by_wall(left, part_.walls()[i], upright);
  });
  return left;
}

void LegalCenters::cut_by_wall(TrimmedCurve& left, const Wall& wall, double upright) const {
  const double farthest = upright + farther_from(wall);
  if (!wall.stands_at(z_) || distance(wall.edge, left.middle()) >= farthest + left.half()) return;
  if (left.stays_beyond(wall.edge, farthest)) return;
  left.add_cuts(wall.edge, upright);
  if (farthest > upright) left.add_cuts(wall.edge, farthest);
  for (const Edge& end : wall.flat_ends(z_)) left.add_cuts(end, upright);
  const double off = upright + off_fillet(wall);
  left.keep([&](Vec2 p) { return distance(wall.edge, p) >= off + part_.draft_offset(wall, z_, p); });
}

/// On the floor the cutter keeps off the fillet until its corner touches the floor where the fillet ends; beside upright walls that is the
/// difference of the radii. Higher up it could come nearer, which is not asked of it: within micrometres over the floor that would be much.
double LegalCenters::off_fillet(const Wall& wall) const {
  if (z_ - wall.z_low >= wall.height_of_touching(wall.fillet - corner_)) return 0;
  return wall.center_of_touching(wall.fillet) - corner_;
}

/// mm; the least distance - reach over all walls, if it is negative; else 0.
double LegalCenters::clearance_over_reach(Vec2 p) const {
  double least = 0;
  const double far = reach_ + most_farther();
  part_.wall_tree().nearest(p, far, [&](int i) {
    const Wall& wall = part_.walls()[i];
    if (!wall.stands_at(z_)) return false;
    const double apart = distance(wall.edge, p) - reach_ - off_fillet(wall);
    if (apart < wall.draft_offset(z_)) least = std::min(least, apart - part_.draft_offset(wall, z_, p));
    return false;
  });
  return least;
}

bool LegalCenters::contains(Vec2 p) const {
  return clearance_over_reach(p) >= -kRounding && part_.is_free(p, z_);
}

}  // namespace clearcut::verify
