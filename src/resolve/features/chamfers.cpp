#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "features/round_hole.h"
#include "geometry/contours/boolean.h"
#include "geometry/region.h"
#include "geometry/voronoi/clearance.h"
#include "resolve/features/shaping.h"

namespace clearcut::resolve {
namespace {

/// mm beside the line at which milled areas are searched. Lines of drawings are within the repair tolerance of
/// outlines.
constexpr double kBeside = 0.02;
/// mm. Slots may be no wider than their mill.
constexpr double kFits = 0.002;
/// mm. Half the width of seams left by offsets and booleans between touching areas.
constexpr double kSeam = 0.003;
/// mm. A wall of the stock has room for any cutter beside it.
constexpr double kBesideStock = 50;
/// mm; least height of a wall below a chamfer.
constexpr double kLeastWall = 0.01;
/// mm along a line between the places at which its wall is searched.
constexpr double kSampleStep = 2;

Regions joined(const Regions& a, const Regions& b, const Tolerances& tol) {
  return a.empty() ? b : b.empty() ? a : unite(a, b, tol);
}

/// Radius of the narrowest mill used on a feature, including its stock to leave; nothing for drilled holes.
std::optional<double> corner_radius_of(const Part& part, int feature) {
  std::optional<double> least;
  for (const Workingstep& step : part.workplan) {
    if (step.feature != feature || !clears_floors(tool_of(part, step))) continue;
    const double radius = tool_of(part, step).radius() + step.operation.allowance_side;
    least = std::min(least.value_or(radius), radius);
  }
  return least;
}

/// The area of a feature cleared by a mill: all except its corners.
Regions cleared_of(const Feature& feature, double mill_radius, const Tolerances& tol) {
  const double radius = mill_radius - kFits;
  if (!feature.profile) {
    const Regions centers = inset(feature.allowed, radius, tol);
    return centers.empty() ? Regions{} : intersect(feature.target, dilate(centers, radius, tol), tol);
  }
  const Regions within{Region::from_valid_loops(feature.profile->line, {})};
  if (feature.profile->side == ProfileSide::kOutside)
    return subtract(feature.target, inset(dilate(within, radius, tol), radius, tol), tol);
  const Regions centers = inset(within, radius, tol);
  return centers.empty() ? Regions{} : intersect(feature.target, dilate(centers, radius, tol), tol);
}

class WallFinder {
 public:
  WallFinder(Part& part, int feature, const Tolerances& tol)
      : part_(part), index_(feature), feature_(part.features[static_cast<std::size_t>(feature)]), tol_(tol) {}

  /// Whether the wall is made by a cut-out.
  bool find() {
    Chamfer& chamfer = *feature_.chamfer;
    foot_ = feature_.top_z - chamfer.depth;
    collect();
    chamfer.air_inside = side();
    chamfer.free_beside.clear();
    chamfer.reach = kBesideStock / 2;
    chamfer.free_floor = -HUGE_VAL;
    bool cut_out = false;
    for (const int i : beside_line()) {
      const Feature& other = part_.features[static_cast<std::size_t>(i)];
      const auto hole = features::round_hole_of(other, tol_);
      const auto radius = hole ? std::nullopt : corner_radius_of(part_, i);
      const Regions cleared = radius ? cleared_of(other, *radius, tol_) : other.target;
      chamfer.free_beside = joined(chamfer.free_beside, cleared, tol_);
      chamfer.reach = std::min(chamfer.reach, hole ? hole->radius : radius.value_or(chamfer.reach));
      chamfer.free_floor = std::max(chamfer.free_floor, other.floor_z);
      cut_out = cut_out || (other.profile && other.profile->side != ProfileSide::kOn);
    }
    if (stock_beside_) add_stock_side();
    return cut_out;
  }

 private:
  /// Collects features open at the foot's height.
  void collect() {
    const Box near = box(feature_.chamfer->line).grown(kBeside);
    for (std::size_t i = 0; i < part_.features.size(); ++i) {
      const Feature& other = part_.features[i];
      if (static_cast<int>(i) == index_ || other.chamfer || other.carving ||
          other.kind == FeatureKind::kTSlot || other.target.empty())
        continue;
      if (other.floor_z < foot_ - kLeastWall && other.top_z > foot_ && box(other.target).overlaps(near))
        open_.push_back(static_cast<int>(i));
    }
  }

  bool is_open(Vec2 p) const {
    if (part_.stock && !part_.stock->plan.contains(p)) return true;
    return std::any_of(open_.begin(), open_.end(), [&](int i) {
      return contains(part_.features[static_cast<std::size_t>(i)].target, p);
    });
  }

  template <typename Sampling>
  void along(Sampling sample) const {
    for (const Edge& edge : feature_.chamfer->line) {
      const int pieces = std::max(1, static_cast<int>(std::ceil(edge.length() / kSampleStep)));
      for (int i = 0; i < pieces; ++i) {
        const double t = (i + 0.5) / pieces;
        sample(edge.at(t), left_of(edge.tangent_at(t)) * kBeside);
      }
    }
  }

  /// Whether the milled area is inside the line.
  bool side() const {
    const bool left_is_inside = signed_area(feature_.chamfer->line) > 0;
    int left = 0, right = 0, none = 0;
    Vec2 bad;
    along([&](Vec2 p, Vec2 aside) {
      const bool a = is_open(p + aside), b = is_open(p - aside);
      if (a == b)
        ++none, bad = p;
      else
        ++(a ? left : right);
    });
    if (none > 0 || (left > 0) == (right > 0)) {
      throw InputError(
          feature_.name,
          fmt::format(
              "no wall stands along its whole line (look at x {} y {}): a chamfer breaks the edge of what is "
              "milled "
              "(a pocket, hole or cut-out deeper than {} mm) or of the stock; draw it on such an edge",
              trimmed(bad.x, 3), trimmed(bad.y, 3), trimmed(feature_.chamfer->depth, 3)));
    }
    return (left > 0) == left_is_inside;
  }

  /// Features beside the line; notes whether the stock ends there.
  std::vector<int> beside_line() {
    std::vector<int> found;
    // A corner of the line on the stock's side, as for a part rotated in its block.
    if (part_.stock)
      for (const Edge& edge : feature_.chamfer->line)
        stock_beside_ = stock_beside_ || !part_.stock->plan.grown(-kBeside).contains(edge.from);
    along([&](Vec2 p, Vec2 aside) {
      for (const Vec2 q : {p + aside, p - aside}) {
        stock_beside_ = stock_beside_ || (part_.stock && !part_.stock->plan.contains(q));
        for (const int i : open_) {
          const bool known = std::find(found.begin(), found.end(), i) != found.end();
          if (!known && contains(part_.features[static_cast<std::size_t>(i)].target, q)) found.push_back(i);
        }
      }
    });
    return found;
  }

  void add_stock_side() {
    Chamfer& chamfer = *feature_.chamfer;
    const Box& plan = part_.stock->plan;
    const Region beside = frame_around(plan, kBesideStock);
    chamfer.free_beside = joined(chamfer.free_beside, {beside}, tol_);
    chamfer.free_floor = std::max(chamfer.free_floor, part_.stock->z_bottom);
  }

  Part& part_;
  int index_;
  Feature& feature_;
  const Tolerances& tol_;
  double foot_ = 0;
  std::vector<int> open_;
  bool stock_beside_ = false;
};

/// The strip of the top removed by a chamfer, `width` mm wide.
Regions strip_of(const Chamfer& chamfer, double width, const Tolerances& tol) {
  const Regions within{Region::from_valid_loops(chamfer.line, {})};
  if (chamfer.air_inside) return subtract(dilate(within, width, tol), within, tol);
  const Regions rest = inset(within.front(), width, tol);
  return rest.empty() ? within : subtract(within, rest, tol);
}

/// Throws if the remaining wall is so narrow that chamfers on both its sides would meet.
void refuse_narrow_top(const Feature& feature, double width, const Tolerances& tol) {
  if (feature.chamfer->air_inside) return;
  const Regions rest = inset(Region::from_valid_loops(feature.chamfer->line, {}), width, tol);
  if (rest.size() == 1) return;
  throw InputError(
      feature.name,
      fmt::format("it is {} mm wide at the top, and what stands between its lines is {}: nothing of the top "
                  "would be left there; use less depth",
                  trimmed(width, 3),
                  rest.empty() ? "no wider than twice that" : "in places no wider than twice that"));
}

void refuse_narrow_cone(const Feature& feature, const Tool& tool) {
  if (!is_conical(tool))
    throw InputError(feature.name,
                     "a chamfer needs a chamfer mill or a V-bit; give one besides, for example "
                     "--tool chamfer:90deg:6");
  if (feature.chamfer->depth <= flank_height(tool)) return;
  throw InputError(feature.name,
                   fmt::format("it is {} mm deep and the flanks of T{} ({} {} mm) are {} mm high; use less "
                               "depth or a wider cutter",
                               trimmed(feature.chamfer->depth, 3), tool.number, name_of(tool.kind),
                               trimmed(tool.diameter, 4), trimmed(flank_height(tool), 3)));
}

/// Throws if the tool's angle differs from that of the solid's modelled edge.
void refuse_other_lean(const Feature& feature, const Tool& tool) {
  constexpr double kSameLean = 0.002;  // radians
  const double asked = feature.wall_slope.radians();
  if (asked == 0 || std::abs(tool.tip_angle->radians() / 2 - asked) < kSameLean) return;
  throw InputError(
      feature.name,
      fmt::format("its edge leans {} degrees and T{} is a cone of {}; give a cone of {} degrees, or leave "
                  "the edge out (--op ignore:{})",
                  trimmed(asked * 180 / kPi, 2), tool.number,
                  trimmed(tool.tip_angle->radians() * 180 / kPi, 2), trimmed(2 * asked * 180 / kPi, 2),
                  feature.name));
}

/// Throws if the chamfer would remove more of the top than there is.
void refuse_thin_top(const Part& part, int index, const Tolerances& tol) {
  const Feature& feature = part.features[static_cast<std::size_t>(index)];
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    const Feature& other = part.features[i];
    if (static_cast<int>(i) == index || other.kind == FeatureKind::kTSlot ||
        other.floor_z >= feature.top_z - kLeastWall)
      continue;
    if (!box(other.target).overlaps(box(feature.target))) continue;
    const Regions met = inset(intersect(feature.target, other.target, tol), kSeam, tol);
    if (met.empty()) continue;
    const Vec2 at = box(met).center();
    throw InputError(feature.name,
                     fmt::format("it is {} mm wide at the top and meets {} at x {} y {}; use less depth",
                                 trimmed(feature.chamfer->depth * base::tan(feature.wall_slope.radians()), 3),
                                 other.name, trimmed(at.x, 2), trimmed(at.y, 2)));
  }
}

}  // namespace

void shape_chamfers(Part& part, const Tolerances& tol) {
  std::vector<Workingstep> early, late;
  for (const Workingstep& step : part.workplan) {
    Feature& feature = part.features[static_cast<std::size_t>(step.feature)];
    if (!feature.chamfer) {
      early.push_back(step);
      continue;
    }
    const Tool& tool = tool_of(part, step);
    refuse_narrow_cone(feature, tool);
    refuse_other_lean(feature, tool);
    feature.wall_slope = Radians::of(tool.tip_angle->radians() / 2);
    feature.floor_z = feature.top_z - feature.chamfer->depth;
    const bool cut_out = WallFinder(part, step.feature, tol).find();
    refuse_narrow_top(feature, feature.chamfer->depth * flank_slope(tool), tol);
    feature.target = strip_of(*feature.chamfer, feature.chamfer->depth * flank_slope(tool), tol);
    feature.allowed = feature.target;
    (cut_out && tool.kind == ToolKind::kChamferMill && tool.tip_diameter > 0 ? late : early).push_back(step);
  }
  for (const Workingstep& step : late) early.push_back(step);
  part.workplan = std::move(early);
  for (const Workingstep& step : part.workplan) {
    if (feature_of(part, step).chamfer) refuse_thin_top(part, step.feature, tol);
  }
}

}  // namespace clearcut::resolve
