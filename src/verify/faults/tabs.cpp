#include "verify/faults/tabs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"
#include "base/text/format.h"
#include "base/units.h"
#include "verify/faults/lowest_tip.h"

namespace clearcut::verify {
namespace {

/// mm, square to the side of a tab. Sampled places are so close that an error between them is greater by at most
/// this.
constexpr double kBetweenPlaces = 0.0025;
/// mm. Distance beside a tab up to which places are sampled.
constexpr double kBesideBody = 0.5;
/// Number of lines of places along the kerf; one of them is its middle.
constexpr int kLines = 9;

/// The lowest tip of a cutter while covering a place.
struct Lowest {
  double z = std::numeric_limits<double>::infinity();
  int line = 0;
};

void lower(const CheckedMove& checked, Vec2 at, Lowest& lowest) {
  if (checked.low_z() >= lowest.z) return;
  const auto tip = lowest_tip(checked, at);
  if (tip && *tip < lowest.z) lowest = {*tip, checked.move->line};
}

Lowest lowest_over(Vec2 at, const std::vector<const CheckedMove*>& moves) {
  Lowest lowest;
  for (const CheckedMove* checked : moves) lower(*checked, at, lowest);
  return lowest;
}

/// The moves whose cutter comes near a tab.
std::vector<const CheckedMove*> moves_near(const Tab& tab, const CheckedProgram& program) {
  Box around = box(tab.body).grown(kBesideBody);
  around.add(tab.center);
  std::vector<const CheckedMove*> near;
  for (const CheckedMove& checked : program.moves) {
    if (checked.radius() <= 0) continue;
    if (checked.move->path.box().grown(checked.radius()).overlaps(around)) near.push_back(&checked);
  }
  return near;
}

std::string place_of(Vec2 at, int line) {
  std::string text = " at x " + trimmed(at.x, 3) + " y " + trimmed(at.y, 3);
  if (line > 0) text += ", line " + std::to_string(line);
  return text + ".";
}

/// mm from the tab's edge on the outline to the middle of the kerf.
double to_middle(const Tab& tab) {
  return distance(tab.foot, tab.center);
}

/// mm along the foot: in the middle of a curved kerf the cutter touches a shorter stretch of a tab than beside the
/// middle.
double excess_of(const Tab& tab) {
  if (!tab.foot.is_arc()) return 0;
  const double around = distance(tab.foot.center, tab.center), r = to_middle(tab);
  return tab.foot.radius() *
         (base::asin(std::min(1.0, r / around)) - 2 * base::asin(std::min(1.0, r / (2 * around))));
}

/// mm of stock to leave where a profile is cut: on its walls and the sides of its tabs, and on its floor.
struct StockLeft {
  double sides = 0;
  double floor = 0;
};

/// The least stock left of all steps on the feature.
StockLeft stock_left(const Part& part, const Feature& feature) {
  StockLeft left{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const Workingstep& step : part.workplan) {
    if (&feature_of(part, step) != &feature) continue;
    left.sides = std::min(left.sides, step.operation.allowance_side);
    left.floor = std::min(left.floor, step.operation.allowance_floor);
  }
  return std::isinf(left.sides) ? StockLeft{} : left;
}

/// The middle of the kerf `out` mm along the foot beyond one of its ends, `sides` mm of stock being left on the wall.
Vec2 beyond_foot(const Tab& tab, bool ahead, double out, double sides) {
  const Edge& foot = tab.foot;
  const Vec2 end = ahead ? foot.to : foot.from, along = foot.tangent_at(ahead ? 1 : 0);
  const double way = ahead ? out : -out;
  if (!foot.is_arc())
    return end + along * way + left_of(along) * ((to_middle(tab) + sides) * (tab.aside < 0 ? -1 : 1));
  const double outer = distance(foot.center, tab.center);
  const double angle = way / foot.radius(), around = outer + (outer > foot.radius() ? sides : -sides);
  const Vec2 outwards = (end - foot.center) / foot.radius();
  return foot.center + (outwards * base::cos(angle) + along * base::sin(angle)) * around;
}

/// Deviation of the material on one side of a triangular tab from this side.
struct SideError {
  double off = 0;  ///< mm, square to the side; below 0 if there is too little material
  Vec2 at;
  Lowest lowest;
};

/// Whether the sides of a triangular tab are as they should be: nowhere lower, and in the middle of the kerf nowhere
/// higher.
class SideCheck {
 public:
  SideCheck(const Tab& tab, const std::vector<const CheckedMove*>& moves, StockLeft left)
      : tab_(tab),
        moves_(moves),
        left_(left),
        half_(tab.foot.length() / 2),
        steepness_((tab.top_z - tab.bottom_z) / half_) {}

  SideError worst() const {
    const double step = kBetweenPlaces * base::hypot(1.0, steepness_) / steepness_;
    const int count = std::max(2, static_cast<int>(std::ceil(2 * half_ / step)));
    SideError worst;
    for (int line = 0; line < kLines; ++line) {
      for (int i = 0; i <= count; ++i) {
        const SideError here = error_at(static_cast<double>(i) / count, line);
        if (std::abs(here.off) > std::abs(worst.off)) worst = here;
      }
    }
    return worst;
  }

 private:
  /// `along`: share of the foot, from 0 to 1.
  SideError error_at(double along, int line) const {
    constexpr int kMiddle = kLines / 2;
    const double side = tab_.aside < 0 ? -1 : 1;
    const double aside = side * (to_middle(tab_) + left_.sides) * line / kMiddle;
    const Vec2 at = tab_.foot.at(along) + left_of(tab_.foot.tangent_at(along)) * aside;
    const Lowest lowest = lowest_over(at, moves_);
    const double from_ridge = std::abs(2 * along - 1) * half_;
    const double least = tab_.top_z - steepness_ * from_ridge;
    const double side_z =
        tab_.top_z - steepness_ * std::max(0.0, from_ridge - std::max(0.0, excess_of(tab_)));
    const double most = std::max(side_z, tab_.bottom_z + left_.floor);
    SideError error{0, at, lowest};
    if (lowest.z < least) error.off = lowest.z - least;
    if (line == kMiddle && lowest.z > most) error.off = std::min(lowest.z, tab_.top_z + 1) - most;
    error.off /= base::hypot(1.0, steepness_);
    return error;
  }

  const Tab& tab_;
  const std::vector<const CheckedMove*>& moves_;
  StockLeft left_;
  double half_;       ///< mm
  double steepness_;  ///< mm up for each mm along the outline
};

std::optional<Fault> fault_of_sides(const Feature& feature, const Tab& tab,
                                    const std::vector<const CheckedMove*>& moves, StockLeft left,
                                    const Tolerances& tol) {
  if (tab.shape != TabShape::kTriangular) return std::nullopt;
  const SideError worst = SideCheck(tab, moves, left).worst();
  if (std::abs(worst.off) <= tol.uncut) return std::nullopt;
  const std::string what = "a side of the triangular tab stands " + trimmed(std::abs(worst.off), 3) +
                           " mm too " + (worst.off < 0 ? "low" : "high");
  return Fault{FaultKind::kTabHeight,
               feature.name,
               {worst.at, worst.lowest.z, worst.lowest.line},
               std::abs(worst.off),
               feature.name + ": " + what + place_of(worst.at, worst.lowest.line)};
}

/// Fault of a square tab that is longer along the middle of the kerf than required.
std::optional<Fault> fault_of_width(const Feature& feature, const Tab& tab,
                                    const std::vector<const CheckedMove*>& moves, StockLeft left,
                                    const Tolerances& tol) {
  if (tab.shape != TabShape::kSquare) return std::nullopt;
  const double may_stand = std::max(0.0, excess_of(tab)) + left.sides + tol.uncut;
  const auto is_cut = [&](Vec2 at) {
    return lowest_over(at, moves).z <= tab.bottom_z + left.floor + tol.uncut;
  };
  for (const bool ahead : {false, true}) {
    if (is_cut(beyond_foot(tab, ahead, may_stand, left.sides))) continue;
    double out = may_stand;
    while (out < may_stand + kBesideBody && !is_cut(beyond_foot(tab, ahead, out + tol.uncut, left.sides)))
      out += tol.uncut;
    const Vec2 at = beyond_foot(tab, ahead, out, left.sides);
    return Fault{
        FaultKind::kUncut,
        feature.name,
        {at, tab.bottom_z, 0},
        out,
        feature.name + ": the tab stands " + trimmed(out, 2) + " mm too wide on one side" + place_of(at, 0)};
  }
  return std::nullopt;
}

}  // namespace

std::vector<Fault> faults_of_tabs(const Part& part, const CheckedProgram& program, const Tolerances& tol) {
  std::vector<Fault> faults;
  for (const Feature& feature : part.features) {
    if (!feature.profile) continue;
    const StockLeft left = stock_left(part, feature);
    for (const Tab& tab : feature.profile->tabs) {
      const std::vector<const CheckedMove*> near = moves_near(tab, program);
      const Lowest lowest = lowest_over(tab.center, near);
      if (std::abs(lowest.z - tab.top_z) <= tol.uncut) {
        if (const auto fault = fault_of_sides(feature, tab, near, left, tol)) faults.push_back(*fault);
        if (const auto fault = fault_of_width(feature, tab, near, left, tol)) faults.push_back(*fault);
        continue;
      }
      const double under = tab.bottom_z + feature.profile->beyond;
      const double asked = tab.top_z - under, height = std::min(lowest.z, feature.top_z + asked) - under;
      const bool missing = height <= tol.uncut;
      const std::string what = missing ? "the tab is cut away"
                               : std::isinf(lowest.z)
                                   ? "nothing is cut over the tab"
                                   : "the tab stands " + trimmed(height, 3) + " mm high where " +
                                         trimmed(asked, 3) + " mm is asked";
      faults.push_back({missing ? FaultKind::kMissingTab : FaultKind::kTabHeight,
                        feature.name,
                        {tab.center, std::isinf(lowest.z) ? tab.top_z : lowest.z, lowest.line},
                        std::abs(asked - height),
                        feature.name + ": " + what + place_of(tab.center, lowest.line)});
    }
  }
  return faults;
}

}  // namespace clearcut::verify
