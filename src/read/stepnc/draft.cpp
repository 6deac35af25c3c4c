#include "read/stepnc/draft.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/text/format.h"
#include "read/stepnc/refusal.h"

namespace clearcut::read::stepnc {

namespace {

constexpr double kFlatFloor = 1e-6;  // radians

/// z of a depth plane in the feature's frame; fails when the plane is not level.
double depth_of(const Node& feature) {
  const Node surface = feature.needed_ref(4, "depth");
  if (!surface.is_any("PLANE", "ELEMENTARY_SURFACE"))
    surface.fail("the floor is not a plane and cannot be machined yet; give a PLANE");
  const Frame frame = frame_of(surface.needed_ref(1, "position"));
  if (base::hypot(frame.z.x, frame.z.y) > kFlatFloor)
    surface.fail("the floor is not level and cannot be machined yet; machine it in a set-up in which it is");
  return frame.origin.z;
}

void check_upright(const Member& member) {
  if (!is_upright(member.placement))
    member.feature.fail(
        "its placement is tilted; only features seen from above (+Z) can be machined in this set-up");
}

void check_slope(const Node& node, double slope) {
  if (slope < 0)
    node.fail("walls that overhang (negative slope) cannot be milled from above; correct the slope");
}

void read_bosses(const Node& feature, std::size_t argument, const Frame& frame, Draft& draft,
                 Context& context) {
  for (const Node& boss : feature.refs(argument)) {
    if (!boss.is("BOSS")) boss.fail("a BOSS is needed here; correct the reference");
    const Frame local = frame_of(boss.ref(3));
    const Frame placed = composed(frame, local);
    if (!is_planar(placed)) boss.fail("its placement is tilted; only upright bosses can be machined around");
    if (local.origin.z < -context.tol.join_gap)
      context.note("the boss begins below the feature's top; it is left standing at full height", boss);
    const Loop outline = closed_profile(boss.needed_ref(5, "boundary"), true, context);
    draft.bosses.push_back(planar_map(placed).path(outline));
    const double slope = context.draft_angle(boss.number(6).value_or(0));
    check_slope(boss, slope);
    if (slope > draft.wall_slope.radians()) {
      context.warn(
          "the boss's walls have draft more than the feature's; all walls are cut with the larger angle",
          boss);
      draft.wall_slope = Radians::of(slope);
    }
  }
}

void read_boundary(const Node& profile, const Frame& frame, Draft& draft, Context& context) {
  const PlanarMap map = planar_map(frame);
  draft.boundary = map.path(closed_profile(profile, true, context));
  if (has_own_placement(profile)) draft.unplaced_boundary = map.path(closed_profile(profile, false, context));
}

void read_pocket_walls(const Node& feature, Draft& draft, Context& context) {
  const double slope = context.draft_angle(feature.number(6).value_or(0));
  check_slope(feature, slope);
  draft.wall_slope = Radians::of(slope);
  const auto bottom = feature.ref(7);
  if (!bottom) context.note("no bottom condition; the floor is taken as flat", feature);
  if (bottom && bottom->is("GENERAL_POCKET_BOTTOM_CONDITION"))
    bottom->fail(
        "the pocket's bottom is a free-form surface and cannot be machined yet; write what lies above it as "
        "a flat pocket");
  if (bottom && bottom->is("RADIUSED_POCKET_BOTTOM_CONDITION"))
    bottom->fail(
        "the pocket's bottom is rounded and cannot be machined yet; write what lies above it as a flat "
        "pocket");
  draft.through = bottom && bottom->is("THROUGH_POCKET_BOTTOM_CONDITION");
  if (feature.length(8).value_or(0) > 0)
    context.note("floor fillets (planar_radius) are left to the cutter's own corner radius", feature);
}

/// A corner that a fillet between walls would round.
bool has_sharp_corner(const Loop& loop) {
  constexpr double kSharp = 0.02;  // sine of the turn
  const double side = signed_area(loop) > 0 ? 1 : -1;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Edge& next = loop[(i + 1) % loop.size()];
    if (side * cross(loop[i].tangent_at(1), next.tangent_at(0)) > kSharp) return true;
  }
  return false;
}

void read_closed_pocket(const Node& feature, const Frame& frame, Draft& draft, Context& context) {
  read_pocket_walls(feature, draft, context);
  read_boundary(feature.needed_ref(10, "feature boundary"), frame, draft, context);
  if (feature.length(9).value_or(0) > 0 && has_sharp_corner(draft.boundary))
    context.warn(
        "corners stay as the profile draws them: fillets between walls (orthogonal_radius) are not added to "
        "it",
        feature);
  read_bosses(feature, 5, frame, draft, context);
}

void read_open_pocket(const Node& feature, const Frame& frame, Draft& draft, Context& context) {
  draft.kind = FeatureKind::kOpenPocket;
  read_pocket_walls(feature, draft, context);
  const Node open = feature.needed_ref(10, "open boundary");
  if (is_closed_profile(open))
    read_boundary(open, frame, draft, context);
  else
    draft.wall = planar_map(frame).path(open_profile(open, context));
  if (draft.boundary.empty() && draft.wall.empty()) open.fail("the boundary has no length; give its curve");
  if (!feature.unset(11))
    context.note("the wall boundary is not used: the open boundary and the stock's edge bound the pocket",
                 feature);
  read_bosses(feature, 5, frame, draft, context);
}

/// Course of travel times removal boundary: the rectangle that a face covers.
Loop swept_face(const Node& feature, const Frame& frame, Context& context) {
  const Node course_node = feature.needed_ref(5, "course of travel");
  const Path course = travel_path(course_node, context);
  if (course.size() != 1 || course[0].is_arc())
    course_node.fail("a face's course of travel must be one straight line");
  const Node profile = feature.needed_ref(6, "removal boundary");
  if (!profile.is("LINEAR_PROFILE")) profile.fail("a face's removal boundary must be a LINEAR_PROFILE");
  const double width = profile.needed_length(1, "profile length");
  const Frame across = frame_of(profile.ref(0));
  const Vec2 along = course[0].to - course[0].from;
  Vec2 side{across.x.x, across.x.y};
  if (std::abs(cross(along, side)) < 1e-3 * norm(along)) side = {across.y.x, across.y.y};
  if (std::abs(cross(along, side)) < 1e-3 * norm(along)) side = left_of(unit(along));
  if (width <= 0) profile.fail("the profile length is not above zero; correct it");
  const Vec2 start = course[0].from + Vec2{across.origin.x, across.origin.y};
  const Vec2 corners[] = {start, start + side * width, start + side * width + along, start + along};
  return planar_map(frame).path(loop_from_points(corners));
}

void read_planar_face(const Node& feature, const Frame& frame, Draft& draft, Context& context) {
  draft.kind = FeatureKind::kPlanarFace;
  if (!feature.unset(7))
    read_boundary(feature.needed_ref(7, "face boundary"), frame, draft, context);
  else if (!feature.unset(5) && !feature.unset(6))
    draft.boundary = swept_face(feature, frame, context);
  else
    context.note("no face boundary; the whole stock is faced, except bosses", feature);
  read_bosses(feature, 8, frame, draft, context);
}

SlotEnd slot_end(const Node& end, Context& context) {
  if (end.is("OPEN_SLOT_END_TYPE")) return SlotEnd::kOpen;
  if (end.is("RADIUSED_SLOT_END_TYPE")) return SlotEnd::kRound;
  if (end.is("FLAT_SLOT_END_TYPE")) {
    context.note("corner radii of flat slot ends are left to the cutter's radius", end);
    return SlotEnd::kFlat;
  }
  end.fail("a slot with this kind of end cannot be machined yet; write the end as open, round or flat");
}

void read_slot(const Node& feature, const Frame& frame, Draft& draft, Context& context) {
  draft.kind = FeatureKind::kSlot;
  draft.course = planar_map(frame).path(travel_path(feature.needed_ref(5, "course of travel"), context));
  if (draft.course.empty()) feature.fail("the course of travel has no length; correct it");
  const CrossSection section = cross_section(feature.needed_ref(6, "swept shape"), context);
  draft.width = section.width;
  draft.wall_slope = Radians::of(section.draft);
  draft.raised_floor = section.rounded_below;
  const std::vector<Node> ends = feature.refs(7);
  const bool loop = !ends.empty() && ends[0].is("LOOP_SLOT_END_TYPE");
  draft.ends_given = ends.size() >= 2 && !loop;
  if (!draft.ends_given || loop) return;
  draft.ends[0] = slot_end(ends[0], context);
  draft.ends[1] = slot_end(ends[1], context);
}

void read_step(const Node& feature, const Frame& frame, Draft& draft, Context& context) {
  draft.kind = FeatureKind::kStep;
  draft.wall = planar_map(frame).path(travel_path(feature.needed_ref(5, "open boundary"), context));
  draft.wall_is_step = true;
  if (draft.wall.empty()) feature.fail("the open boundary has no length; correct it");
  if (const auto profile = feature.ref(6)) {
    const auto square = [&](std::size_t i) {
      const auto angle = profile->number(i);
      return !angle || std::abs(context.angle(*angle) - kPi / 2) < 1e-3;
    };
    if (profile->is("VEE_PROFILE") && !(square(2) && square(3)))
      profile->fail(
          "a step whose wall is not upright cannot be machined yet; write it as an open pocket with a slope");
  }
  read_bosses(feature, 7, frame, draft, context);
}

/// mm across at the floor of a tapered hole; nothing for an upright one.
std::optional<double> floor_diameter(const Node& feature, double diameter, double depth, Context& context) {
  const auto taper = feature.ref(6);
  if (!taper) return std::nullopt;
  if (taper->is("DIAMETER_TAPER")) return taper->needed_length(0, "final diameter");
  if (!taper->is("ANGLE_TAPER"))
    taper->fail("not a taper that can be read; give a DIAMETER_TAPER or an ANGLE_TAPER");
  const double angle = context.draft_angle(taper->needed_number(0, "angle"));
  return diameter - 2 * depth * base::tan(angle);
}

/// A hole that narrows is a round pocket with drafted walls.
void read_taper(const Node& feature, double diameter, Draft& draft, Context& context) {
  const double depth = -draft.depth_z;
  const auto floor = floor_diameter(feature, diameter, depth, context);
  if (!floor || std::abs(*floor - diameter) < 1e-9) return;
  if (*floor > diameter)
    feature.fail("the hole widens downwards and cannot be milled from above; correct the taper");
  if (*floor <= 0 || depth <= 0)
    feature.fail("its taper comes to a point above the floor; correct the taper or the depth");
  draft.kind = FeatureKind::kClosedPocket;
  draft.wall_slope = Radians::of(base::atan((diameter - *floor) / 2 / depth));
  draft.hole_diameter.reset();
}

void read_hole_bottom(const Node& feature, Draft& draft, Context& context) {
  const auto bottom = feature.ref(7);
  if (!bottom) return context.note("no bottom condition; the hole is blind", feature);
  draft.through = bottom->is("THROUGH_BOTTOM_CONDITION");
  if (bottom->is_any("CONICAL_HOLE_BOTTOM", "SPHERICAL_HOLE_BOTTOM", "FLAT_WITH_RADIUS_HOLE_BOTTOM"))
    context.note("the form of its bottom is left to the tool, whose tip goes down to the depth", *bottom);
}

void read_round_hole(const Node& feature, const Frame& frame, Draft& draft, Context& context) {
  draft.kind = FeatureKind::kRoundHole;
  const double diameter = feature.needed_length(5, "diameter");
  if (diameter <= 0) feature.fail("the diameter is not above zero; correct it");
  draft.hole_diameter = diameter;
  read_taper(feature, diameter, draft, context);
  read_hole_bottom(feature, draft, context);
  const Vec2 c{frame.origin.x, frame.origin.y};
  const Vec2 r{diameter / 2, 0};
  draft.boundary = {Edge::arc(c + r, c - r, c, Turn::kCounterClockwise),
                    Edge::arc(c - r, c + r, c, Turn::kCounterClockwise)};
}

void read_outside_profile(const Node& feature, const Frame& frame, std::size_t argument, Draft& draft,
                          Context& context) {
  draft.kind = FeatureKind::kOutsideProfile;
  const Node profile = feature.needed_ref(argument, "boundary");
  if (is_closed_profile(profile)) {
    read_boundary(profile, frame, draft, context);
    draft.bosses.push_back(draft.boundary);
    draft.boundary.clear();
    draft.unplaced_boundary.clear();
  } else {
    draft.wall = planar_map(frame).path(open_profile(profile, context));
    if (draft.wall.empty()) profile.fail("the boundary has no length; give its curve");
  }
  context.note("everything of the stock outside the profile is removed", feature);
}

constexpr Refusal kRefusedFeatures[] = {
    {"CHAMFER",
     "an edge is broken with a chamfering cutter along it, which is not planned; deburr it by hand or add a "
     "V-cutter pass"},
    {"EDGE_ROUND",
     "an edge is rounded with a form cutter along it, which is not planned; round it by hand or add the "
     "pass"},
    {"THREAD", "threads are not cut; drill the core hole here and tap it elsewhere"},
    {"CATALOGUE_THREAD", "threads are not cut; drill the core hole here and tap it elsewhere"},
    {"DEFINED_THREAD", "threads are not cut; drill the core hole here and tap it elsewhere"},
    {"ROUNDED_END", "its wall is round from the side and is no 2.5-D feature; write it as a pocket or step"},
    {"SPHERICAL_CAP", "a ball is no 2.5-D feature; it needs free-form milling"},
    {"TOOLPATH_FEATURE", "it is only a path; write what is to be removed as a pocket, face, slot or step"},
    {"REGION_PROJECTION", "it is a free-form surface; write flat parts of it as pockets or faces"},
    {"GENERAL_FREEFORM", "it is a free-form surface; write flat parts of it as pockets or faces"}};

[[noreturn]] void refuse(const Node& feature) {
  refuse_listed(feature, kRefusedFeatures);
  feature.fail(
      "features of this kind cannot be machined yet; write it as pockets, faces, slots, steps or round "
      "holes");
}

void read_kind(const Node& feature, const Frame& frame, Draft& draft, Context& context) {
  if (feature.is("CLOSED_POCKET")) return read_closed_pocket(feature, frame, draft, context);
  if (feature.is("OPEN_POCKET")) return read_open_pocket(feature, frame, draft, context);
  if (feature.is("PLANAR_FACE")) return read_planar_face(feature, frame, draft, context);
  if (feature.is("SLOT")) return read_slot(feature, frame, draft, context);
  if (feature.is("STEP")) return read_step(feature, frame, draft, context);
  if (feature.is("ROUND_HOLE")) return read_round_hole(feature, frame, draft, context);
  if (feature.is("GENERAL_OUTSIDE_PROFILE")) return read_outside_profile(feature, frame, 6, draft, context);
  if (feature.is_any("CIRCULAR_CLOSED_SHAPE_PROFILE", "RECTANGULAR_CLOSED_SHAPE_PROFILE"))
    return read_outside_profile(feature, frame, 8, draft, context);
  refuse(feature);
}

}  // namespace

Draft draft_feature(const Member& member, Context& context) {
  const Node& feature = member.feature;
  Draft draft(feature);
  draft.name = member.name;
  if (!is_simple_feature(feature)) refuse(feature);
  check_upright(member);
  draft.placement = member.placement;
  draft.placement_z = member.placement.origin.z;
  draft.depth_z = depth_of(feature);
  read_kind(feature, member.placement, draft, context);
  return draft;
}

}  // namespace clearcut::read::stepnc
