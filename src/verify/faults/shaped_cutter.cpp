#include "verify/faults/shaped_cutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/elementary.h"
#include "model/cutter_profile.h"

namespace clearcut::verify {
namespace {

/// mm. A stretch of a path along which the excess can change by less than this is not halved again.
constexpr double kShortest = 2e-4;
constexpr int kSections = 40;
constexpr double kGolden = 0.6180339887498949;

/// The height between `low` and `high` at which a cutter with its tip at z comes nearest to a wall with draft.
double nearest_height(const Wall& wall, const Tool& tool, double z, double low, double high) {
  // A flank steeper than the wall comes nearest at low, else at its upper end; a rounding where it is as steep.
  if (has_flanks(tool))
    return flank_slope(tool) <= wall.slope ? low : std::clamp(z + flank_height(tool), low, high);
  const double touch = tool.corner_radius * (1 - wall.slope / base::hypot(1.0, wall.slope));
  return std::clamp(z + touch, low, high);
}

/// mm; how far a cutter with its tip at z has to stay from the outline of a wall.
double distance_needed(const Wall& wall, const Tool& tool, double z, bool is_drafted_here) {
  if (z >= wall.z_high) return 0;
  if (!is_drafted_here || wall.slope <= 0) return radius_at(tool, wall.z_high - z);
  const double low = std::max(z, wall.z_low), high = std::max(low, std::min(wall.z_high, wall.top_z));
  const double height = nearest_height(wall, tool, z, low, high);
  // Above its outline the wall is upright, up to z_high.
  return std::max(radius_at(tool, height - z) + wall.draft_offset(height), radius_at(tool, wall.z_high - z));
}

class ShapedCheck {
 public:
  ShapedCheck(const FinishedPart& part, const Move& move, const Tool& tool, double slack)
      : part_(part), move_(move), tool_(tool), slack_(slack) {
    half_ = move.is_vertical() ? 0 : move.path.length() / 2;
  }

  std::optional<Gouge> check() {
    const double low = std::min(move_.z_from, move_.z_to);
    if (low >= part_.top_z()) return std::nullopt;
    part_.wall_tree().within(at(0.5), half_ + widest_radius(tool_) + part_.greatest_draft_offset(),
                             [&](int i) { against_wall(part_.walls()[static_cast<std::size_t>(i)]); });
    for (const double t : {0.0, 0.5, 1.0}) against_inside(t);
    return worst_;
  }

 private:
  Vec2 at(double t) const { return move_.is_vertical() ? move_.path.from : move_.path.at(t); }
  double z_at(double t) const { return move_.z_from + (move_.z_to - move_.z_from) * t; }

  double excess(const Wall& wall, double t) const {
    const Vec2 p = at(t);
    const bool leans = wall.slope > 0 && part_.is_inside(wall.feature, p);
    return distance_needed(wall, tool_, z_at(t), leans) - distance(wall.edge, p);
  }

  /// mm; upper bound of how much the excess changes over the whole move while the tip is below the wall's top.
  double rate_beside(const Wall& wall) const {
    const double flank = has_flanks(tool_) ? flank_slope(tool_) : 0;
    return 2 * half_ + std::abs(move_.z_to - move_.z_from) * (flank + wall.slope);
  }

  /// The parameters between which the tip is below the wall's top.
  std::array<double, 2> below_top(const Wall& wall) const {
    const double dz = move_.z_to - move_.z_from;
    if (dz == 0) return {0, 1};
    const double passes = std::clamp((wall.z_high - move_.z_from) / dz, 0.0, 1.0);
    return dz < 0 ? std::array{passes, 1.0} : std::array{0.0, passes};
  }

  void against_wall(const Wall& wall) {
    double worst_t = 0, worst = -HUGE_VAL;
    const auto sample = [&](double t) {
      const double e = excess(wall, t);
      if (e > worst) worst = e, worst_t = t;
      return e;
    };
    const double first = sample(0), last = sample(1);
    if (!move_.is_vertical()) {
      const double rate = rate_beside(wall);
      if ((first + last + rate) / 2 <= 0) return;
      if (!wall.edge.is_arc() && !move_.path.is_arc()) {
        by_sections(sample, below_top(wall));
      } else {
        by_halves(sample, {0, first}, {1, last}, rate, worst);
      }
    }
    if (worst > 0) keep(wall, worst_t, worst);
  }

  /// Golden section search. Below the wall's top the excess is concave, because the distance from the wall is convex.
  template <typename Sampling>
  static void by_sections(Sampling sample, std::array<double, 2> range) {
    auto [low, high] = range;
    double a = high - kGolden * (high - low), b = low + kGolden * (high - low), fa = sample(a),
           fb = sample(b);
    for (int i = 0; i < kSections; ++i) {
      if (fa < fb) {
        low = a, a = b, fa = fb;
        fb = sample(b = low + kGolden * (high - low));
      } else {
        high = b, b = a, fb = fa;
        fa = sample(a = high - kGolden * (high - low));
      }
    }
  }

  struct Sample {
    double t, excess;
  };

  template <typename Sampling>
  void by_halves(Sampling sample, Sample a, Sample b, double rate, const double& worst) {
    const double change = rate * (b.t - a.t);
    const double above = (a.excess + b.excess + change) / 2;
    if (above <= std::max(slack_ / 2, worst) || change < kShortest) return;
    const double t = (a.t + b.t) / 2;
    const Sample middle{t, sample(t)};
    by_halves(sample, a, middle, rate, worst);
    by_halves(sample, middle, b, rate, worst);
  }

  void keep(const Wall& wall, double t, double sideways) {
    const double upwards = has_flanks(tool_) ? sideways / flank_slope(tool_) : sideways;
    const double depth = std::min({sideways, upwards, wall.z_high - z_at(t)});
    if (depth <= 0 || (worst_ && depth <= worst_->depth)) return;
    worst_ = Gouge{depth, at(t), z_at(t), false, wall.feature};
  }

  /// The tip itself may be below a floor or inside a wall.
  void against_inside(double t) {
    const double height = part_.height(at(t)), z = z_at(t);
    if (height <= z + slack_ || (worst_ && height - z <= worst_->depth)) return;
    if (part_.is_film(at(t), z)) return;
    worst_ = Gouge{height - z, at(t), z, true, -1};
  }

  const FinishedPart& part_;
  const Move& move_;
  const Tool& tool_;
  double slack_;
  double half_ = 0;
  std::optional<Gouge> worst_;
};

/// mm. More than rounding takes of a bound for heights.
constexpr double kRounding = 1e-9;

/// Parameter along a straight move, prolonged at both ends, at which a cone's flank is lowest over p.
double lowest_place(const Move& move, double slope, Vec2 p) {
  const Vec2 along = move.path.to - move.path.from;
  const double length = norm(along), near = dot(p - move.path.from, along) / (length * length);
  const double aside = std::abs(cross(p - move.path.from, along)) / length;
  const double rise = (move.z_to - move.z_from) / length, steep = rise * slope;
  if (std::abs(steep) >= 1) return rise < 0 ? 1 : 0;
  return near - steep * aside / std::sqrt(1 - steep * steep) / length;
}

}  // namespace

std::optional<Gouge> shaped_gouge_of(const FinishedPart& part, const Move& move, const Tool& tool,
                                     double slack) {
  return ShapedCheck(part, move, tool, slack).check();
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

/// mm; no cutter's surface comes lower over p along this move.
double CutHeights::least_height(const Entry& entry, Vec2 p) {
  const double low = std::min(entry.move->z_from, entry.move->z_to);
  if (entry.slope <= 0) return low;
  return low + std::max(0.0, entry.path.distance_to(p) - tip_radius(*entry.tool)) / entry.slope - kRounding;
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
