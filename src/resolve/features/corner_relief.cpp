#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "features/standing.h"
#include "geometry/contours/boolean.h"
#include "resolve/features/shaping.h"

namespace clearcut::resolve {
namespace {

/// mm; excess of the relief's width over the cutter's.
constexpr double kSpare = 0.02;
/// mm. Residual of a cutter in a corner below which no relief is needed.
constexpr double kLeast = 0.02;
/// Sine of the smallest turn of an outline that counts as a corner.
constexpr double kSmoothTurn = 0.02;
/// mm. Rounding of places on an outline.
constexpr double kOnLine = 1e-4;
/// Greatest distance from a corner of the cutter's contact with both walls, in radii of the cutter.
constexpr double kFarthest = 8;
constexpr int kHalvings = 50;
/// Bones whose places a note lists.
constexpr std::size_t kListed = 6;

/// A corner of an outline with the free side on the left: directions along both walls away from it, and their
/// lengths.
struct Corner {
  Vec2 at, back, ahead;
  double back_mm = 0, ahead_mm = 0;

  Vec2 bisector() const { return unit(back + ahead); }
};

std::vector<Corner> inside_corners(const Loop& loop) {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Edge& before = loop[i == 0 ? loop.size() - 1 : i - 1];
    const Edge& after = loop[i];
    const Vec2 in = before.tangent_at(1), out = after.tangent_at(0);
    if (cross(in, out) > kSmoothTurn)
      corners.push_back({after.from, in * -1, out, before.length(), after.length()});
  }
  return corners;
}

/// The area permitted to the cutter by the outline: inside a region, or around one.
class Room {
 public:
  Room(const Region& region, bool is_within) : region_(region), is_within_(is_within) {}

  /// mm; radius of the largest cutter permitted at p; negative if none is.
  double clearance(Vec2 p) const {
    return region_.contains(p) == is_within_ ? region_.boundary_distance(p) : -1;
  }

 private:
  const Region& region_;
  bool is_within_;
};

/// The place on the bisector at which a cutter touches both walls; absent if there is no room.
std::optional<Vec2> touching_place(const Corner& corner, double radius, const Room& room) {
  const Vec2 bisector = corner.bisector();
  const double sine = std::abs(cross(bisector, corner.ahead));
  double low = 0, high = radius / std::max(sine, 1 / kFarthest) + kOnLine;
  const auto place = [&](double along) { return corner.at + bisector * along; };
  if (room.clearance(place(high)) < radius) return std::nullopt;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (room.clearance(place(middle)) < radius ? low : high) = middle;
  }
  return place(high);
}

/// The area swept by a disc on a straight move.
Region swept(Vec2 from, Vec2 to, double radius) {
  const Vec2 along = unit(to - from), aside = left_of(along) * radius;
  const auto turn = Turn::kCounterClockwise;
  return Region::from_valid_loops(
      {Edge::line(from - aside, to - aside), Edge::arc(to - aside, to + along * radius, to, turn),
       Edge::arc(to + along * radius, to + aside, to, turn), Edge::line(to + aside, from + aside),
       Edge::arc(from + aside, from - along * radius, from, turn),
       Edge::arc(from - along * radius, from - aside, from, turn)},
      {});
}

struct Bone {
  Vec2 corner;
  Region shape;
};

class CornerRelief {
 public:
  CornerRelief(Part& part, const PlanOptions& options, double radius)
      : part_(part), tol_(options.tol), t_bone_(*options.shop.dogbones == "t-bone"), radius_(radius) {}

  /// Whether a corner was found that needs relief, with room for it or not.
  bool has_corners() const { return !made_.empty() || left_ > 0; }

  /// Returns whether the feature has got a bone.
  bool relieve(std::size_t index) {
    feature_ = &part_.features[index];
    made_.clear();
    left_ = 0;
    if (feature_->profile)
      relieve_profile(*feature_->profile);
    else
      relieve_pocket();
    tell();
    return !made_.empty();
  }

 private:
  void relieve_profile(ProfileCut& cut) {
    const bool inside = cut.side == ProfileSide::kInside;
    Regions shape{Region::from_valid_loops(cut.line, {})};
    const Region drawn = shape.front();
    const Room room(drawn, inside);
    for (const Corner& corner : inside_corners(inside ? cut.line : reversed(cut.line))) {
      if (!leaves_much(corner)) continue;
      const auto bone = bone_at(corner, room);
      if (bone &&
          accept(inside ? unite(shape, {bone->shape}, tol_) : subtract(shape, {bone->shape}, tol_), shape))
        made_.push_back(bone->corner);
      else
        ++left_;
    }
    cut.line = shape.front().outer();
  }

  /// Relieves corners of the permitted area that are on the target's boundary; there are none at open sides.
  void relieve_pocket() {
    const Regions drawn = feature_->allowed;
    for (const Region& region : drawn) {
      for (const Loop& loop : loops_of({region})) {
        for (const Corner& corner : inside_corners(loop)) relieve_corner(corner, Room(region, true));
      }
    }
  }

  void relieve_corner(const Corner& corner, const Room& room) {
    const auto is_of_target = [&](const Region& region) {
      return region.boundary_distance(corner.at) < kOnLine;
    };
    if (std::none_of(feature_->target.begin(), feature_->target.end(), is_of_target) || !leaves_much(corner))
      return;
    const auto bone = feature_->wall_slope.radians() == 0 ? bone_at(corner, room) : std::nullopt;
    if (!bone || meets_another(bone->shape) ||
        !accept(unite(feature_->allowed, {bone->shape}, tol_), feature_->allowed)) {
      ++left_;
      return;
    }
    feature_->target = unite(feature_->target, {bone->shape}, tol_);
    made_.push_back(bone->corner);
  }

  bool leaves_much(const Corner& corner) const {
    const Vec2 bisector = corner.bisector();
    return radius_ / std::max(std::abs(cross(bisector, corner.ahead)), 1e-9) - radius_ > kLeast;
  }

  std::optional<Bone> bone_at(const Corner& corner, const Room& room) const {
    const double radius = radius_ + kSpare;
    const auto start = touching_place(corner, radius, room);
    if (!start) return std::nullopt;
    const Vec2 shorter = corner.back_mm < corner.ahead_mm ? corner.back : corner.ahead;
    const Vec2 away = t_bone_ ? shorter : corner.bisector();
    return Bone{corner.at, swept(*start, corner.at + away * radius, radius)};
  }

  /// Whether the bone cuts into another feature outside of the feature itself.
  bool meets_another(const Region& bone) const {
    const Regions besides = subtract({bone}, feature_->target, tol_);
    return std::any_of(part_.features.begin(), part_.features.end(), [&](const Feature& other) {
      const bool beside = &other != feature_ && !other.profile && other.floor_z < feature_->top_z &&
                          other.top_z > feature_->floor_z;
      return beside && box(other.target).overlaps(bone.box()) &&
             area(intersect(other.target, besides, tol_)) > kLeast * kLeast;
    });
  }

  /// Takes `wider` unless a wall was broken through: then an island is joined to its surroundings, or areas to each
  /// other.
  static bool accept(Regions wider, Regions& shape) {
    if (wider.size() != shape.size() || loops_of(wider).size() != loops_of(shape).size()) return false;
    shape = std::move(wider);
    return true;
  }

  void tell() {
    if (!made_.empty()) {
      std::vector<std::string> places;
      for (const Vec2 at : made_)
        if (places.size() < kListed) places.push_back(trimmed(at.x, 3) + "," + trimmed(at.y, 3));
      const std::string more =
          made_.size() > kListed ? fmt::format(" and {} more", made_.size() - kListed) : "";
      part_.diagnostics.note(
          feature_->name,
          fmt::format("{} {} for a cutter of {} mm at {}{}", made_.size(), t_bone_ ? "T-bones" : "dogbones",
                      trimmed(2 * radius_, 4), fmt::join(places, "; "), more));
    }
    if (left_ > 0)
      part_.diagnostics.warn(
          feature_->name,
          fmt::format("{} inside corners have no {}: the cutter has no room there, the walls lean, or a bone "
                      "would break through a wall or an edge that is broken",
                      left_, t_bone_ ? "T-bone" : "dogbone"));
  }

  Part& part_;
  const Tolerances& tol_;
  bool t_bone_;
  double radius_;  ///< mm; radius of the cutter
  Feature* feature_ = nullptr;
  std::vector<Vec2> made_;
  int left_ = 0;  ///< corners without relief
};

bool takes_relief(const Feature& feature) {
  if (feature.profile) return feature.profile->side != ProfileSide::kOn && feature.profile->closed;
  return !feature.carving && !feature.chamfer && !feature.hole && !feature.hole_diameter &&
         feature.kind != FeatureKind::kIsolation;
}

/// mm; radius of the narrowest mill used on the feature; absent without one. Other available mills do not change its
/// corners.
std::optional<double> narrowest_radius(const Part& part, std::size_t feature) {
  std::optional<double> radius;
  for (const Workingstep& step : part.workplan) {
    const Tool& tool = tool_of(part, step);
    if (step.feature == static_cast<int>(feature) && clears_floors(tool))
      radius = std::min(radius.value_or(tool.radius()), tool.radius());
  }
  return radius;
}

/// A pocket under another one begins at the other's floor; what its bones take beside the other one begins above that.
void raise_top(Part& part, std::size_t index, const Tolerances& tol) {
  Part as_drawn = part;
  Feature& feature = as_drawn.features[index];
  for (const Feature& other : part.features) {
    if (!other.chamfer && other.top_z > feature.top_z && box(other.target).overlaps(box(feature.target)))
      feature.top_z = other.top_z;
  }
  part.features[index].top_z =
      std::max(part.features[index].top_z, features::stacked_tops(as_drawn, tol)[index]);
}

/// Returns whether a corner was found that needs relief.
bool relieve(Part& part, const PlanOptions& options, bool profiles) {
  bool any = false;
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    if (!takes_relief(part.features[i]) || part.features[i].profile.has_value() != profiles) continue;
    const auto radius = narrowest_radius(part, i);
    if (!radius) continue;
    CornerRelief relief(part, options, *radius);
    if (relief.relieve(i) && !profiles) raise_top(part, i, options.tol);
    any = any || relief.has_corners();
  }
  return any;
}

}  // namespace

void relieve_profiles(Part& part, const PlanOptions& options) {
  if (!options.shop.dogbones) return;
  if (!relieve(part, options, true))
    part.idle["dogbones"] = "no pocket and no profile has an inside corner to relieve";
}

void relieve_pockets(Part& part, const PlanOptions& options) {
  if (!options.shop.dogbones) return;
  if (relieve(part, options, false)) part.idle.erase("dogbones");
}

}  // namespace clearcut::resolve
