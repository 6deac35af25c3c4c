#include "verify/program/shaped_cutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/elementary.h"
#include "base/tolerances.h"

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

namespace {

/// mm. Stretches of a path are not halved again if the excess can change by less than the first value, or if they are
/// shorter than the second.
constexpr double kExact = 1e-5, kShortest = 2e-4;
constexpr int kSections = 40;
constexpr double kGolden = 0.6180339887498949;
/// Alternate projections between a path and a wall: good enough for messages.
constexpr int kProjections = 12;

bool has_flat_end(const Wall& wall) {
  return wall.flat_from || wall.flat_to;
}

/// The height between `low` and `high` of the nearest approach of a cutter with its tip at z to a wall with draft.
double nearest_height(const Wall& wall, const CutterProfile& cutter, double z, double low, double high) {
  // A flank steeper than the wall comes nearest at low, else at its upper end; a rounding at its point of equal
  // slope.
  if (cutter.round > 0) {
    const double touch = cutter.round * (1 - wall.slope / base::hypot(1.0, wall.slope));
    return std::clamp(z + touch, low, high);
  }
  return cutter.slope <= wall.slope ? low : std::clamp(z + cutter.full_height(), low, high);
}

/// mm; required distance of a cutter with its tip at z from the outline of a wall.
double distance_needed(const Wall& wall, const CutterProfile& cutter, double z, bool is_drafted_here) {
  if (z >= wall.z_high) return 0;
  if (!is_drafted_here || wall.slope <= 0) return cutter.radius_at(wall.z_high - z);
  const double low = std::max(z, wall.z_low), high = std::max(low, std::min(wall.z_high, wall.top_z));
  const double height = nearest_height(wall, cutter, z, low, high);
  // Above its outline the wall is upright, up to z_high.
  return std::max(cutter.radius_at(height - z) + wall.draft_offset(height),
                  cutter.radius_at(wall.z_high - z));
}

/// Golden section search: the greatest value of a concave function between two places, its ends among them.
template <typename Function>
double greatest_of_concave(double low, double high, const Function& value) {
  double best = std::max(value(low), value(high));
  double a = high - kGolden * (high - low), b = low + kGolden * (high - low), fa = value(a), fb = value(b);
  for (int i = 0; i < kSections; ++i) {
    best = std::max({best, fa, fb});
    if (fa < fb) {
      low = a, a = b, fa = fb;
      fb = value(b = low + kGolden * (high - low));
    } else {
      high = b, b = a, fb = fa;
      fa = value(a = high - kGolden * (high - low));
    }
  }
  return std::max({best, fa, fb});
}

class ShapedCheck {
 public:
  ShapedCheck(const FinishedPart& part, const Move& move, const CutterProfile& cutter, double slack)
      : part_(part), move_(move), cutter_(cutter), slack_(slack) {
    half_ = move.is_vertical() ? 0 : move.path.length() / 2;
  }

  std::optional<Gouge> check() {
    const double low = std::min(move_.z_from, move_.z_to);
    if (low >= part_.top_z()) return std::nullopt;
    part_.wall_tree().within(at(0.5), half_ + cutter_.widest + part_.greatest_draft_offset(),
                             [&](int i) { against_wall(part_.walls()[static_cast<std::size_t>(i)]); });
    for (const double t : {0.0, 0.5, 1.0}) against_inside(t);
    return worst_;
  }

 private:
  /// A place of the path with its excess over one wall.
  struct Sample {
    double t, excess;
    bool leans;  ///< whether the wall's draft counts there
  };

  Vec2 at(double t) const { return move_.is_vertical() ? move_.path.from : move_.path.at(t); }
  double z_at(double t) const { return move_.z_from + (move_.z_to - move_.z_from) * t; }

  Sample sample(const Wall& wall, double t) const {
    const Vec2 p = at(t);
    const bool leans = wall.slope > 0 && part_.is_inside(wall.feature, p);
    if (leans && has_flat_end(wall)) return {t, excess_at_flat_end(wall, p, z_at(t)), true};
    return {t, distance_needed(wall, cutter_, z_at(t), leans) - distance(wall.edge, p), leans};
  }

  /// If the stock's side cuts the wall off square, the excess is computed at the height where it is greatest: it is concave over the
  /// heights, as the cutter's radius is, and minus the distance from a body whose sections shrink evenly upwards.
  double excess_at_flat_end(const Wall& wall, Vec2 p, double z) const {
    if (z >= wall.z_high) return -distance(wall.edge, p);
    const double low = std::max(z, wall.z_low), high = std::max(low, std::min(wall.z_high, wall.top_z));
    const Edge place = Edge::line(p, p);
    const double above = cutter_.radius_at(wall.z_high - z) - distance(wall.edge, p);
    const auto excess = [&](double height) {
      return cutter_.radius_at(height - z) - part_.apart(wall, height, place);
    };
    return std::max(above, greatest_of_concave(low, high, excess));
  }

  /// The range of parameters with the tip below the wall's top.
  std::array<double, 2> below_top(const Wall& wall) const {
    const double dz = move_.z_to - move_.z_from;
    if (dz == 0) return {0, 1};
    const double passes = std::clamp((wall.z_high - move_.z_from) / dz, 0.0, 1.0);
    return dz < 0 ? std::array{passes, 1.0} : std::array{0.0, passes};
  }

  void against_wall(const Wall& wall) {
    if (std::min(move_.z_from, move_.z_to) >= wall.z_high) return;
    const Sample first = sample(wall, 0), last = sample(wall, 1);
    Sample worst = first.excess > last.excess ? first : last;
    if (!move_.is_vertical()) {
      const bool is_level = move_.z_from == move_.z_to;
      if (is_level || wall.edge.is_arc() || move_.path.is_arc() || has_flat_end(wall)) {
        by_halves(wall, first, last, worst);
      } else if (greatest_between(wall, first, last) > worst.excess) {
        by_sections(wall, below_top(wall), worst);
      }
    }
    if (worst.excess > 0) keep(wall, worst);
  }

  /// Below the wall's top the excess is concave, because the distance from the wall is convex.
  void by_sections(const Wall& wall, std::array<double, 2> range, Sample& worst) const {
    greatest_of_concave(range[0], range[1], [&](double t) {
      const Sample found = sample(wall, t);
      if (found.excess > worst.excess) worst = found;
      return found.excess;
    });
  }

  Edge piece_of(double from, double to) const {
    return from == 0 && to == 1 ? move_.path : move_.path.part(from, to);
  }

  /// Upper bound of the excess between two samples: that of the lowest tip at the least distance.
  double greatest_between(const Wall& wall, const Sample& a, const Sample& b) const {
    const bool leans = a.leans || b.leans || sample_leans(wall, (a.t + b.t) / 2);
    const double low = std::min(z_at(a.t), z_at(b.t));
    return distance_needed(wall, cutter_, low, leans) - distance(piece_of(a.t, b.t), wall.edge);
  }
  bool sample_leans(const Wall& wall, double t) const {
    return wall.slope > 0 && part_.is_inside(wall.feature, at(t));
  }

  /// mm; greatest difference between the excess at the lowest tip and that at the highest, at the same distance.
  double change_by_height(const Wall& wall, const Sample& a, const Sample& b) const {
    const double low = std::min(z_at(a.t), z_at(b.t)), high = std::max(z_at(a.t), z_at(b.t));
    return distance_needed(wall, cutter_, low, a.leans || b.leans) -
           distance_needed(wall, cutter_, high, a.leans && b.leans);
  }

  void by_halves(const Wall& wall, const Sample& a, const Sample& b, Sample& worst) const {
    const double length = 2 * half_ * (b.t - a.t), change = change_by_height(wall, a, b);
    double above = greatest_between(wall, a, b);
    // At ends cut off square there is less material than the distance from the outline suggests.
    const bool is_told = !has_flat_end(wall) && a.leans == b.leans;
    if (!is_told) above = std::min(above, (a.excess + b.excess + length) / 2 + change);
    if (above <= std::max(slack_ / 2, worst.excess + kExact)) return;
    if (is_told && change < kExact) {
      worst = {nearest_parameter(wall, a.t, b.t), above, a.leans};
      return;
    }
    if (length < kShortest) return;
    const Sample middle = sample(wall, (a.t + b.t) / 2);
    if (middle.excess > worst.excess) worst = middle;
    by_halves(wall, a, middle, worst);
    by_halves(wall, middle, b, worst);
  }

  double nearest_parameter(const Wall& wall, double from, double to) const {
    const Edge piece = piece_of(from, to);
    double t = 0.5;
    for (int i = 0; i < kProjections; ++i)
      t = std::clamp(nearest(piece, nearest_point(wall.edge, piece.at(t))).t, 0.0, 1.0);
    return from + (to - from) * t;
  }

  void keep(const Wall& wall, const Sample& worst) {
    const double z = z_at(worst.t), sideways = worst.excess;
    // A cutter in contact on its flank is also freed by an upward shift.
    const bool by_flank = cutter_.slope > 0 && cutter_.radius_at(wall.z_high - z) < cutter_.widest;
    const double upwards = by_flank ? sideways / cutter_.slope : sideways;
    const double depth = std::min({sideways, upwards, wall.z_high - z});
    if (depth <= 0 || (worst_ && depth <= worst_->depth)) return;
    worst_ = Gouge{depth, at(worst.t), z, false, wall.feature};
  }

  /// The tip itself may be below a floor or inside a wall.
  void against_inside(double t) {
    const double height = part_.height(at(t)), z = z_at(t);
    if (height <= z + slack_ || (worst_ && height - z <= worst_->depth)) return;
    if (part_.is_sliver(at(t), z)) return;
    worst_ = Gouge{height - z, at(t), z, true, -1};
  }

  const FinishedPart& part_;
  const Move& move_;
  const CutterProfile& cutter_;
  double slack_;
  double half_ = 0;
  std::optional<Gouge> worst_;
};

/// Parameter along a straight move, prolonged at both ends, of the lowest place of a cone's flank over p.
double lowest_place(const Move& move, double slope, Vec2 p) {
  const Vec2 along = move.path.to - move.path.from;
  const double length = norm(along), near = dot(p - move.path.from, along) / (length * length);
  const double aside = std::abs(cross(p - move.path.from, along)) / length;
  const double rise = (move.z_to - move.z_from) / length, steep = rise * slope;
  if (std::abs(steep) >= 1) return rise < 0 ? 1 : 0;
  return near - steep * aside / std::sqrt(1 - steep * steep) / length;
}

}  // namespace

std::optional<Gouge> shaped_gouge_of(const FinishedPart& part, const Move& move, const CutterProfile& cutter,
                                     double slack) {
  return ShapedCheck(part, move, cutter, slack).check();
}

std::optional<double> height_at(const Tool& tool, double distance) {
  const double height = outer_profile(tool).height_at(distance);
  return std::isinf(height) ? std::nullopt : std::optional(height);
}

void CutHeights::add(const Move& move, const Tool& tool) {
  const Box path = move.path.box();
  index_.add(path.grown(widest_radius(tool)), static_cast<std::uint32_t>(entries_.size()));
  entries_.push_back({&move, &tool, has_flanks(tool) ? flank_slope(tool) : 0, path});
}

std::optional<double> CutHeights::height_over(const Entry& entry, double distance) {
  if (entry.slope <= 0) return height_at(*entry.tool, distance);
  if (distance > widest_radius(*entry.tool)) return std::nullopt;
  return std::max(0.0, distance - tip_radius(*entry.tool)) / entry.slope;
}

/// mm; lower bound of the height of the cutter's surface over p along this move.
double CutHeights::least_height(const Entry& entry, Vec2 p) {
  const double low = std::min(entry.move->z_from, entry.move->z_to);
  if (entry.slope <= 0) return low;
  return low + std::max(0.0, entry.path.distance_to(p) - tip_radius(*entry.tool)) / entry.slope - kRoundingMm;
}

double CutHeights::at(Vec2 p) const {
  double lowest = std::numeric_limits<double>::infinity();
  for (const std::uint32_t i : index_.at(p)) {
    const Entry& entry = entries_[i];
    if (least_height(entry, p) >= lowest) continue;
    const Move& move = *entry.move;
    const auto sample = [&](double t) {
      const double c = std::clamp(t, 0.0, 1.0);
      const Vec2 center = move.is_vertical() ? move.path.from : move.path.at(c);
      const double z =
          move.is_vertical() ? std::min(move.z_from, move.z_to) : move.z_from + (move.z_to - move.z_from) * c;
      if (const auto above = height_over(entry, distance(center, p))) lowest = std::min(lowest, z + *above);
    };
    if (move.is_vertical()) {
      sample(0);
      continue;
    }
    sample(nearest(move.path, p).t);
    if (move.z_from == move.z_to) continue;
    sample(0);
    sample(1);
    if (entry.slope > 0 && !move.path.is_arc()) sample(lowest_place(move, entry.slope, p));
  }
  return lowest;
}

}  // namespace clearcut::verify
