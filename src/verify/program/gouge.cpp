#include "verify/program/gouge.h"

#include <algorithm>
#include <cmath>

namespace clearcut::verify {
namespace {

/// mm. The distance of a wall with draft from its outline may change by this over a piece of a sloping move.
constexpr double kDraftError = 1e-4;

double edge_distance(const Edge& path, const Edge& wall) {
  return path.from == path.to ? distance(wall, path.from) : distance(path, wall);
}

/// The point of the path nearest to the wall, found by dividing the path: good enough for messages.
Vec2 nearest_place(const Edge& path, const Edge& wall) {
  if (path.from == path.to) return path.from;
  double best_t = 0, best = std::numeric_limits<double>::infinity(), low = 0, high = 1;
  for (int round = 0; round < 4; ++round) {
    const double step = (high - low) / 32;
    for (int i = 0; i <= 32; ++i) {
      const double t = low + step * i, d = distance(wall, path.at(t));
      if (d < best) best = d, best_t = t;
    }
    low = std::max(0.0, best_t - step), high = std::min(1.0, best_t + step);
  }
  return path.at(best_t);
}

class LevelCheck {
 public:
  LevelCheck(const FinishedPart& part, double radius, double slack)
      : part_(part), radius_(radius), slack_(slack) {}

  /// The deepest gouge of a path whose tip is at z all along.
  std::optional<Gouge> check(const Edge& path, double z, bool free_start) {
    worst_.reset();
    worst_wall_ = nullptr;
    const double checked_z = z + slack_;
    if (checked_z >= part_.top_z()) return std::nullopt;
    const bool point = path.from == path.to;
    const double half = point ? 0 : path.length() / 2;
    part_.wall_tree().within(point ? path.from : path.at(0.5), half + radius_ + part_.greatest_draft_offset(),
                             [&](int i) { against_wall(path, half, z, part_.walls()[i]); });
    if (!free_start) against_inside(path.from, z);
    if (worst_ && path.from != path.to) {
      against_inside(path.at(0.5), z);
      against_inside(path.to, z);
    }
    if (worst_wall_) worst_->point = nearest_place(path, worst_wall_->edge);
    return worst_;
  }

 private:
  void against_wall(const Edge& path, double half, double z, const Wall& wall) {
    if (!wall.stands_at(z + slack_)) return;
    const double farthest = radius_ + wall.draft_offset(z);
    if (distance(wall.edge, path.from == path.to ? path.from : path.at(0.5)) >= farthest + half) return;
    const double apart = edge_distance(path, wall.edge);
    if (apart >= farthest) return;
    const double depth = std::min(radius_ - apart_from(path, apart, z, wall), wall.z_high - z);
    if (depth <= 0 || (worst_ && depth <= worst_->depth)) return;
    worst_ = Gouge{depth, {}, z, false, wall.feature};
    worst_wall_ = &wall;
  }

  /// mm; distance from the wall at this height; `apart`: from its outline.
  double apart_from(const Edge& path, double apart, double z, const Wall& wall) const {
    if (wall.slope <= 0) return apart;
    if (wall.flat_from || wall.flat_to) return part_.apart(wall, z, path);
    return apart - part_.draft_offset(wall, z, nearest_place(path, wall.edge));
  }

  /// The centre itself may be inside the part, behind a wall or below a floor.
  void against_inside(Vec2 center, double z) {
    const double height = part_.height(center);
    if (height <= z + slack_ || part_.is_sliver(center, z + slack_)) return;
    const auto stands = [&](int i) { return part_.walls()[i].stands_at(z + slack_); };
    const auto wall = part_.wall_tree().nearest(center, height - z, stands);
    const double sideways = wall.edge < 0 ? height - z : radius_ + wall.distance;
    const double depth = std::min(sideways, height - z);
    if (worst_ && depth <= worst_->depth) return;
    const bool floor = depth == height - z;
    worst_wall_ = nullptr;
    worst_ = Gouge{depth, center, z, floor, wall.edge < 0 || floor ? -1 : part_.walls()[wall.edge].feature};
  }

  const FinishedPart& part_;
  double radius_, slack_;
  std::optional<Gouge> worst_;
  /// The wall gouged by worst_; null if the centre itself is inside the part.
  const Wall* worst_wall_ = nullptr;
};

class GougeCheck {
 public:
  GougeCheck(const FinishedPart& part, double radius, double slack)
      : part_(part), level_(part, radius, slack) {}

  void check(const Edge& path, double z_from, double z_to, bool free_start) {
    const double low = std::min(z_from, z_to);
    if (low >= part_.top_z()) return;
    const std::optional<Gouge> found = level_.check(path, low, free_start);
    if (!found) return;
    const Vec2 middle = path.at(0.5);
    const bool is_divided =
        overstates_draft(path, z_from, z_to, *found) && middle != path.from && middle != path.to;
    if (is_divided) {
      const double z = (z_from + z_to) / 2;
      check(path.part(0, 0.5), z_from, z, free_start);
      check(path.part(0.5, 1), z, z_to, false);
      return;
    }
    if (!worst_ || found->depth > worst_->depth) worst_ = found;
  }

  std::optional<Gouge> worst() const { return worst_; }

 private:
  /// Walls with draft are nearer at the lowest tip than at earlier ones: a gouge computed with the lowest tip along
  /// the whole move is too deep, unless the cutter really cuts so deep at its lowest point, as on a helix about a
  /// cone.
  bool overstates_draft(const Edge& path, double z_from, double z_to, const Gouge& found) {
    const double span = std::abs(z_to - z_from);
    if (!(part_.greatest_draft_offset() > 0) || span <= kDraftError || path.length() <= kDraftError)
      return false;
    const Vec2 lowest = z_from < z_to ? path.from : path.to;
    const std::optional<Gouge> there = level_.check(Edge::line(lowest, lowest), found.z, false);
    return found.depth - (there ? there->depth : 0) > kDraftError;
  }

  const FinishedPart& part_;
  LevelCheck level_;
  std::optional<Gouge> worst_;
};

/// Parameters of the tip's passage through the height of a floor, with 0 and 1, ascending.
std::vector<double> cuts_at_heights(const FinishedPart& part, const Move& move, double slack) {
  std::vector<double> cuts{0, 1};
  const double dz = move.z_to - move.z_from;
  for (const double height : part.heights()) {
    // Half a slack lower, so that the piece above ends at a height at which the floor still counts as reached.
    const double t = (height - slack / 2 - move.z_from) / dz;
    if (t > 0 && t < 1) cuts.push_back(t);
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

}  // namespace

std::optional<Gouge> gouge_of(const FinishedPart& part, const Move& move, double radius, double slack,
                              bool free_start) {
  GougeCheck check(part, radius, slack);
  if (move.is_vertical() || move.z_from == move.z_to) {
    check.check(move.path, move.z_from, move.z_to, free_start && move.z_from == move.z_to);
    return check.worst();
  }
  const std::vector<double> cuts = cuts_at_heights(part, move, slack);
  const double dz = move.z_to - move.z_from;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Edge piece = cuts.size() == 2 ? move.path : move.path.part(cuts[i], cuts[i + 1]);
    const double z0 = move.z_from + dz * cuts[i], z1 = move.z_from + dz * cuts[i + 1];
    check.check(piece, z0, z1, false);
  }
  return check.worst();
}

}  // namespace clearcut::verify
