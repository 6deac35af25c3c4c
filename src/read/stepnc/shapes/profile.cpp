#include "read/stepnc/shapes/profile.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "model/part.h"
#include "read/stepnc/file/entity_list.h"

namespace clearcut::read::stepnc {

namespace {

constexpr double kMostSides = 1000;
constexpr double kSameLean = 1e-3;  // radians

double positive_length(const Node& node, std::size_t argument, std::string_view what) {
  const double value = node.needed_length(argument, what);
  if (value <= 0) node.fail("the " + std::string(what) + " is not above zero; correct it");
  return value;
}

PlanarMap placement_map(const Node& owner, std::size_t argument) {
  const Frame frame = frame_of(owner.ref(argument));
  if (!is_planar(frame))
    owner.fail("its placement is tilted out of the feature's plane; only plane outlines can be milled");
  return planar_map(frame);
}

Loop circle_loop(double radius) {
  const Vec2 right{radius, 0}, left{-radius, 0};
  return {Edge::arc(right, left, {}, Turn::kCounterClockwise),
          Edge::arc(left, right, {}, Turn::kCounterClockwise)};
}

Loop rectangle_loop(const Node& profile) {
  const double half_width = positive_length(profile, 1, "profile width") / 2;
  const double half_length = positive_length(profile, 2, "profile length") / 2;
  const Vec2 corners[] = {{-half_length, -half_width},
                          {half_length, -half_width},
                          {half_length, half_width},
                          {-half_length, half_width}};
  return loop_from_points(corners);
}

/// Flag .T.: the circle touches the sides; else the corners lie on it. One side is parallel to X, below.
Loop ngon_loop(const Node& profile, Context& context) {
  const double sides = profile.needed_number(2, "number of sides");
  if (sides < 3 || sides > kMostSides || sides != std::floor(sides))
    profile.fail("the number of sides must be a whole number from 3 to 1000; correct it");
  context.spend(static_cast<std::size_t>(sides), profile);
  const double step = 2 * kPi / sides;
  double radius = positive_length(profile, 1, "diameter") / 2;
  if (profile.flag(3) == true) radius /= base::cos(step / 2);
  std::vector<Vec2> corners;
  for (int k = 0; k < static_cast<int>(sides); ++k)
    corners.push_back(radius * direction_of(-kPi / 2 - step / 2 + step * k));
  return loop_from_points(corners);
}

Loop unplaced(const Node& profile, Context& context) {
  if (profile.is("GENERAL_CLOSED_PROFILE"))
    return curve_loop(profile.needed_ref(1, "closed profile shape"), context);
  if (profile.is("CIRCULAR_CLOSED_PROFILE")) return circle_loop(positive_length(profile, 1, "diameter") / 2);
  if (profile.is("RECTANGULAR_CLOSED_PROFILE")) return rectangle_loop(profile);
  if (profile.is_any("NGON_CLOSED_PROFILE", "NGON_PROFILE")) return ngon_loop(profile, context);
  profile.fail(
      "not a closed profile that can be read (general, circular, rectangular, n-gon); use one of those");
}

/// Arc about the origin from +X.
Path arc_from_x(double radius, double sweep) {
  if (sweep == 0) return {};
  const Turn turn = sweep > 0 ? Turn::kCounterClockwise : Turn::kClockwise;
  const int pieces = std::abs(sweep) > kPi ? 2 : 1;
  Path path;
  Vec2 from{radius, 0};
  for (int k = 1; k <= pieces; ++k) {
    const Vec2 to = std::abs(sweep) >= 2 * kPi && k == pieces ? Vec2{radius, 0}
                                                              : radius * direction_of(sweep * k / pieces);
    path.push_back(Edge::arc(from, to, {}, turn));
    from = to;
  }
  return path;
}

double sweep_of(const Node& node, std::size_t argument, Context& context) {
  const double sweep = context.angle(node.needed_number(argument, "sweep angle"));
  if (sweep == 0 || std::abs(sweep) > kRoundedTurn)
    node.fail("the sweep angle must be up to a full turn, not zero; correct it");
  return std::clamp(sweep, -2 * kPi, 2 * kPi);
}

Path linear_path(const Node& path, Context& context) {
  const double distance = positive_length(path, 1, "distance");
  const Vec3 axis = path.unset(2) ? Vec3{1, 0, 0} : axis_of(path.needed_ref(2, "direction"));
  const Vec2 direction{axis.x, axis.y};
  if (norm(direction) == 0) path.fail("its direction is not in the plane; correct it");
  if (std::abs(axis.z) > kSameAngleRad * norm(direction))
    context.diagnostics.doubt(context.file.place(path.line()), kNotFollowed,
                              path.label() + ": its direction leaves the plane; the path is read level");
  return {Edge::line({}, unit(direction) * distance)};
}

}  // namespace

bool is_closed_profile(const Node& profile) {
  return profile.is_any("GENERAL_CLOSED_PROFILE", "CIRCULAR_CLOSED_PROFILE", "RECTANGULAR_CLOSED_PROFILE",
                        "NGON_CLOSED_PROFILE", "NGON_PROFILE");
}

bool has_own_placement(const Node& profile) {
  return !profile.unset(0) && !is_identity(frame_of(profile.ref(0)));
}

Loop closed_profile(const Node& profile, bool placed, Context& context) {
  context.spend(1, profile);
  const Loop loop = unplaced(profile, context);
  return placed ? placement_map(profile, 0).path(loop) : loop;
}

namespace {

/// Three sides, the middle one along X about the origin; the two others lead out of the stock along Y. What stays is between them.
Path open_rectangle(const Node& profile) {
  const double half = positive_length(profile, 1, "width") / 2;
  return {Edge::line({-half, kOpenReach}, {-half, 0}), Edge::line({-half, 0}, {half, 0}),
          Edge::line({half, 0}, {half, kOpenReach})};
}

}  // namespace

Path open_profile(const Node& profile, Context& context) {
  const PlanarMap map = placement_map(profile, 0);
  if (profile.is("GENERAL_PROFILE")) return map.path(curve_path(profile.needed_ref(1, "profile"), context));
  if (profile.is("LINEAR_PROFILE"))
    return map.path({Edge::line({}, {positive_length(profile, 1, "profile length"), 0})});
  if (profile.is("PARTIAL_CIRCULAR_PROFILE"))
    return map.path(arc_from_x(positive_length(profile, 1, "radius"), sweep_of(profile, 2, context)));
  if (profile.is("SQUARE_U_PROFILE")) return map.path(open_rectangle(profile));
  profile.fail("not an open outline that can be read (general, linear, partial circular); use one of those");
}

namespace {

/// Radians between the sides of an upright vee. The tilt is the angle between a side and the surface.
double vee_angle(const Node& profile, Context& context) {
  const double angle = context.angle(profile.needed_number(2, "profile angle"));
  if (!(angle > 0 && angle < kPi))
    profile.fail("the angle between its sides is not from 0 to 180 degrees; correct it");
  const double tilt = context.angle(profile.number(3), (kPi - angle) / 2);
  if (std::abs(tilt - (kPi - angle) / 2) > kSameLean)
    profile.fail(
        "its sides do not lean alike (tilt_angle), and no upright cutter makes both at once; write each side "
        "as a "
        "drafted wall");
  if (profile.length(1).value_or(0) > 0)
    profile.fail(
        "a vee with a rounded point (profile_radius) needs a cutter of that form, which is not planned with; "
        "write it with a sharp one");
  return angle;
}

/// A T: its undercut is a box about the neck, as discs make it.
void read_tee(const Node& profile, CrossSection& section, Context& context) {
  section.width = positive_length(profile, 6, "width");
  section.undercut_width = positive_length(profile, 3, "cross bar width");
  section.undercut_height = positive_length(profile, 4, "cross bar depth");
  if (section.undercut_width <= section.width)
    profile.fail("its cross bar is no wider than its neck; write it with SQUARE_U_PROFILE");
  for (const std::size_t angle : {std::size_t{1}, std::size_t{2}}) {
    const double lean = context.angle(profile.number(angle), 0);
    if (std::abs(lean) > kSameLean && std::abs(lean - kPi / 2) > kSameLean)
      profile.fail("its undercut leans, and T-slot cutters leave it level; give angles of 0");
  }
  if (profile.length(5).value_or(0) > 0)
    profile.fail("its undercut has rounded corners (radius), and T-slot cutters leave sharp ones; give none");
  const double each = (section.undercut_width - section.width) / 2;
  for (const std::size_t offset : {std::size_t{7}, std::size_t{8}})
    if (const auto aside = profile.length(offset); aside && *aside > 0 && std::abs(*aside - each) > kSameLean)
      profile.fail("its cross bar does not lie evenly about its neck; T-slot cutters make it so");
}

}  // namespace

CrossSection cross_section(const Node& profile, Context& context) {
  CrossSection section;
  if (profile.is("LINEAR_PROFILE")) {
    section.width = positive_length(profile, 1, "profile length");
  } else if (profile.is("SQUARE_U_PROFILE")) {
    section.width = positive_length(profile, 1, "width");
    section.draft = std::max(context.draft_angle(profile.number(3).value_or(0)),
                             context.draft_angle(profile.number(5).value_or(0)));
    const double fillet = std::max(profile.length(2).value_or(0), profile.length(4).value_or(0));
    if (section.draft < 0)
      profile.fail("walls that overhang (negative angle) cannot be milled from above; correct it");
    if (section.draft > 0)
      context.warn(
          "slot with drafted walls: its width is taken at the top, so that nothing is cut away that should "
          "stay",
          profile);
    section.fillet = fillet;
  } else if (profile.is("ROUNDED_U_PROFILE")) {
    section.width = positive_length(profile, 1, "width");
    section.rounded_below = section.width / 2;
  } else if (profile.is("VEE_PROFILE")) {
    section.vee = vee_angle(profile, context);
  } else if (profile.is("TEE_PROFILE")) {
    read_tee(profile, section, context);
  } else {
    refuse_listed(profile);
    profile.fail("not a cross-section of slots that can be read (square, rounded, linear); use one of those");
  }
  return section;
}

namespace {

/// Some writers turn the path's frame so that the cross-section lies in its XY plane: the directions are then still given in the
/// feature's frame, so only the place counts. A frame that leans otherwise is not followed.
PlanarMap map_of_path(const Node& path, Context& context) {
  const Frame frame = frame_of(path.ref(0));
  if (is_planar(frame)) return planar_map(frame);
  const bool stands_upright = std::abs(frame.z.z) < kSameAngleRad;
  const std::string what =
      path.label() + ": its placement is not level; the path is read level, in the directions of its feature";
  if (stands_upright)
    context.diagnostics.warn(context.file.place(path.line()), what);
  else
    context.diagnostics.doubt(context.file.place(path.line()), kNotFollowed, what);
  return PlanarMap{{frame.origin.x, frame.origin.y}};
}

}  // namespace

Path travel_path(const Node& path, Context& context) {
  context.spend(1, path);
  const PlanarMap map = map_of_path(path, context);
  if (path.is("LINEAR_PATH")) return map.path(linear_path(path, context));
  if (path.is("GENERAL_PATH")) return map.path(curve_path(path.needed_ref(1, "swept path"), context));
  if (path.is("PARTIAL_CIRCULAR_PATH"))
    return map.path(arc_from_x(positive_length(path, 1, "radius"), sweep_of(path, 2, context)));
  if (path.is("COMPLETE_CIRCULAR_PATH")) return map.path(circle_loop(positive_length(path, 1, "radius")));
  path.fail(
      "not a travel path that can be read (linear, general, partial or complete circular); use one of those");
}

}  // namespace clearcut::read::stepnc
