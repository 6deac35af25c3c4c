#include "read/stepnc/shapes/draft.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/elementary.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "read/stepnc/file/entity_list.h"
#include "read/stepnc/shapes/curve.h"

namespace clearcut::read::stepnc {

namespace {

/// z of a depth plane in the feature's frame; fails when the plane is not level.
double depth_of(const Node& feature) {
  const Node surface = feature.needed_ref(4, "depth");
  if (!surface.is_any("PLANE", "ELEMENTARY_SURFACE"))
    surface.fail("the floor is not a plane and cannot be machined yet; give a PLANE");
  const Frame frame = frame_of(surface.needed_ref(1, "position"));
  if (base::hypot(frame.z.x, frame.z.y) > kSameAngleRad)
    surface.fail("the floor is not level and cannot be machined yet; machine it in a set-up in which it is");
  return frame.origin.z;
}

void check_upright(const Member& member) {
  if (!is_upright(member.placement))
    member.feature.fail(
        "its placement is tilted; only features seen from above (+Z) can be machined in this set-up");
}

/// A length with its field; size is its middle.
Toleranced toleranced(const Node& node, std::size_t argument) {
  Toleranced out{node.needed_length(argument, "length"), 0, 0};
  const auto measure = node.sound_ref(argument);
  const auto field =
      measure && measure->is("TOLERANCED_LENGTH_MEASURE") ? measure->sound_ref(1) : std::nullopt;
  if (!field || !field->is("PLUS_MINUS_VALUE")) return out;
  const double half = (field->length(0).value_or(0) + std::abs(field->length(1).value_or(0))) / 2;
  out.below = out.above = std::max(half, 0.0);
  return out;
}

void check_slope(const Node& node, double slope) {
  if (slope < 0)
    node.fail("walls that overhang (negative slope) cannot be milled from above; correct the slope");
}

void read_bosses(const Node& feature, std::size_t argument, const Frame& frame, Draft& draft,
                 Context& context) {
  for (const Node& boss : feature.refs(argument)) {
    if (!boss.is("BOSS")) boss.fail("a BOSS is needed here; correct the reference");
    context.use_head(boss);
    const Frame local = frame_of(boss.ref(3));
    const Frame placed = composed(frame, local);
    if (!is_planar(placed)) boss.fail("its placement is tilted; only upright bosses can be machined around");
    const Loop outline = closed_profile(boss.needed_ref(5, "boundary"), true, context);
    draft.bosses.push_back(planar_map(placed).path(outline));
    draft.boss_tops.push_back(local.origin.z);
    draft.boss_ids.push_back(boss.id());
    if (boss.unset(6) && draft.wall_slope.radians() > 0)
      context.note("no slope is stated; its walls lean as those of its pocket", boss);
    const double slope = boss.unset(6) ? draft.wall_slope.radians() : context.draft_angle(*boss.number(6));
    check_slope(boss, slope);
    if (slope < draft.wall_slope.radians() - kSameAngleRad)
      context.diagnostics.doubt(
          context.file.place(boss.line()), kNotFollowed,
          boss.label() + ": its walls lean by " + trimmed(Radians::of(slope).degrees(), 3) +
              " degrees, less than those of its pocket; all walls are cut with the larger angle");
    if (slope > draft.wall_slope.radians()) {
      context.diagnostics.doubt(context.file.place(boss.line()), kNotFollowed,
                                boss.label() + ": its walls have draft, " +
                                    trimmed(Radians::of(slope).degrees(), 3) +
                                    " degrees, more than the feature's; all walls are cut with the larger "
                                    "angle");
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
  if (bottom) refuse_listed(*bottom);
  draft.through = bottom && bottom->is("THROUGH_POCKET_BOTTOM_CONDITION");
  if (!feature.unset(8)) draft.floor_fillet = toleranced(feature, 8);
  if (draft.floor_fillet && draft.floor_fillet->size <= 0) draft.floor_fillet.reset();
}

/// The fillets between walls that an outline asks for: its own corners and those of its unplaced form.
void round_walls(const Node& feature, Draft& draft, Context& context) {
  const double radius = feature.length(9).value_or(0);
  if (radius <= 0) return;
  const auto told = [&](const Filleted& rounded) {
    for (const Vec2 corner : rounded.sharp)
      context.diagnostics.doubt(context.file.place(feature.line()), kNotFollowed,
                                feature.label() + ": no fillet of " + trimmed(radius, 3) +
                                    " mm (orthogonal_radius) fits into the corner at " +
                                    trimmed(corner.x, 3) + ", " + trimmed(corner.y, 3) +
                                    "; the corner stays as it is drawn");
    return rounded.path;
  };
  const auto rounded = [&](Loop loop) {
    if (signed_area(loop) < 0) loop = reversed(loop);
    return filleted(loop, true, radius);
  };
  if (!draft.boundary.empty()) draft.boundary = told(rounded(draft.boundary));
  if (!draft.unplaced_boundary.empty()) draft.unplaced_boundary = rounded(draft.unplaced_boundary).path;
  if (!draft.wall.empty()) draft.wall = told(filleted_on_the_right(draft.wall, radius));
}

void read_closed_pocket(const Node& feature, const Frame& frame, Draft& draft, Context& context) {
  read_pocket_walls(feature, draft, context);
  read_boundary(feature.needed_ref(10, "feature boundary"), frame, draft, context);
  round_walls(feature, draft, context);
  read_bosses(feature, 5, frame, draft, context);
}

/// The outline that an open boundary and the walls make together; nothing where their ends do not meet or they are the same.
Loop closed_by_walls(const Path& open, const Path& walls, double gap) {
  if (open.empty() || walls.empty()) return {};
  const auto meet = [&](Vec2 a, Vec2 b) { return distance(a, b) <= gap; };
  const Vec2 begin = open.front().from, end = open.back().to;
  Path back;
  if (meet(begin, walls.front().from) && meet(end, walls.back().to)) back = reversed(walls);
  if (meet(begin, walls.back().to) && meet(end, walls.front().from)) back = walls;
  if (back.empty()) return {};
  back.front().from = end;
  back.back().to = begin;
  Loop loop = open;
  loop.insert(loop.end(), back.begin(), back.end());
  return std::abs(signed_area(loop)) > gap ? loop : Loop{};
}

/// The walls of an open pocket close its open boundary, or are a part of it and say nothing more.
void use_wall(const Node& feature, Draft& draft, const Frame& frame, Context& context) {
  if (feature.unset(11)) return;
  const Path walls = planar_map(frame).path(open_profile(feature.needed_ref(11, "wall boundary"), context));
  const Loop closed = closed_by_walls(draft.wall, walls, context.tol.join_gap);
  if (!closed.empty()) {
    draft.boundary = closed;
    draft.wall.clear();
    return;
  }
  const auto lies_on_boundary = [&](Vec2 point) {
    const Path& boundary = draft.wall.empty() ? draft.boundary : draft.wall;
    return std::any_of(boundary.begin(), boundary.end(),
                       [&](const Edge& edge) { return distance(edge, point) <= context.tol.join_gap; });
  };
  for (const Edge& edge : walls) {
    if (lies_on_boundary(edge.from) && lies_on_boundary(edge.to) && lies_on_boundary(edge.at(0.5))) continue;
    return context.diagnostics.doubt(
        context.file.place(feature.line()), kNotFollowed,
        "not followed: the wall_boundary of " + feature.label() +
            " leaves its open_boundary; the open boundary and the stock's edge bound the pocket");
  }
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
  use_wall(feature, draft, frame, context);
  round_walls(feature, draft, context);
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
  if (!feature.unset(7)) {
    read_boundary(feature.needed_ref(7, "face boundary"), frame, draft, context);
    if (!feature.unset(5) || !feature.unset(6))
      context.note("its face boundary goes before its course of travel and removal boundary", feature);
    feature.use(5);
    feature.use(6);
  } else if (!feature.unset(5) && !feature.unset(6)) {
    draft.boundary = swept_face(feature, frame, context);
  } else {
    context.note("no face boundary; the whole stock is faced, except bosses", feature);
  }
  read_bosses(feature, 8, frame, draft, context);
}

/// What a closed curve outlines on the raw piece, as deep everywhere. The curve's own height does not count.
void read_region(const Node& feature, const Frame& frame, Draft& draft, Context& context) {
  draft.kind = FeatureKind::kPlanarFace;
  const Node direction = feature.needed_ref(5, "direction of projection");
  const Vec3 along = frame.direction(axis_of(direction));
  if (base::hypot(along.x, along.y) > kSameAngleRad * std::abs(along.z))
    direction.fail("the curve is projected at a slant; only regions seen from above (+Z) can be machined");
  draft.below_blank = feature.needed_length(6, "depth");
  if (*draft.below_blank <= 0) feature.fail("its depth is not above zero; correct it");
  draft.boundary = planar_map(frame).path(curve_loop(feature.needed_ref(4, "projected curve"), context));
}

SlotEnd slot_end(const Node& end) {
  if (end.is("OPEN_SLOT_END_TYPE")) return SlotEnd::kOpen;
  if (end.is("RADIUSED_SLOT_END_TYPE")) return SlotEnd::kRound;
  if (end.is("FLAT_SLOT_END_TYPE")) return SlotEnd::kFlat;
  refuse_listed(end);
  end.fail("a slot with this kind of end cannot be machined yet; write the end as open, round or flat");
}

/// Two ends, or one LOOP where the course comes back to its begin. One other end is taken for both.
void read_slot_ends(const Node& feature, Draft& draft, Context& context) {
  const auto doubt = [&](const std::string& what) {
    context.diagnostics.doubt(context.file.place(feature.line()), kNotFollowed,
                              feature.label() + ": " + what);
  };
  const std::vector<Node> ends = feature.refs(7);
  if (ends.empty()) return;
  if (ends.size() > 2) feature.fail("it has more than two end conditions; give one for each end");
  if (ends[0].is("LOOP_SLOT_END_TYPE")) {
    if (distance(draft.course.front().from, draft.course.back().to) > context.tol.join_gap)
      doubt("its end is a LOOP, and its course does not come back to its begin; it ends as its course does");
    return;
  }
  if (ends.size() == 1) doubt("one end condition is given; it is taken for both ends");
  draft.ends_given = true;
  draft.ends[0] = slot_end(ends.front());
  draft.ends[1] = slot_end(ends.back());
}

void read_slot(const Node& feature, const Frame& frame, Draft& draft, Context& context) {
  draft.kind = FeatureKind::kSlot;
  draft.course = planar_map(frame).path(travel_path(feature.needed_ref(5, "course of travel"), context));
  if (draft.course.empty()) feature.fail("the course of travel has no length; correct it");
  const CrossSection section = cross_section(feature.needed_ref(6, "swept shape"), context);
  draft.width = section.width;
  draft.wall_slope = Radians::of(section.draft);
  draft.raised_floor = section.rounded_below;
  if (section.rounded_below > 0) draft.groove = Groove{};
  if (section.undercut_width > 0) draft.undercut = Undercut{section.undercut_width, section.undercut_height};
  if (section.vee) {
    draft.groove = Groove{Radians::of(*section.vee)};
    draft.width = 2 * std::abs(draft.depth_z) * base::tan(*section.vee / 2);
  }
  if (section.fillet > 0) draft.floor_fillet = Toleranced{section.fillet, 0, 0};
  read_slot_ends(feature, draft, context);
}

/// The section of a step: the angle between its floor and its wall, and that between the wall and the surface above, which are the
/// same where the floor is level.
void read_step_wall(const Node& profile, Draft& draft, Context& context) {
  constexpr double kSameAngles = 1e-3;  // radians
  if (!profile.is("VEE_PROFILE"))
    return profile.fail("the wall of a step needs a VEE_PROFILE; correct the reference");
  const double angle = context.angle(profile.number(2), kPi / 2);
  const double tilt = context.angle(profile.number(3), kPi / 2);
  if (std::abs(angle - tilt) > kSameAngles)
    profile.fail(
        "its floor is not level (profile_angle and tilt_angle differ); machine it in a set-up in which it "
        "is");
  check_slope(profile, angle - kPi / 2 > -kSameAngles ? 0 : angle - kPi / 2);
  if (angle - kPi / 2 > kSameAngles) draft.wall_slope = Radians::of(angle - kPi / 2);
  if (!profile.unset(1)) draft.floor_fillet = toleranced(profile, 1);
  if (draft.floor_fillet && draft.floor_fillet->size <= 0) draft.floor_fillet.reset();
}

void read_step(const Node& feature, const Frame& frame, Draft& draft, Context& context) {
  draft.kind = FeatureKind::kStep;
  draft.wall = planar_map(frame).path(travel_path(feature.needed_ref(5, "open boundary"), context));
  draft.wall_is_step = true;
  if (draft.wall.empty()) feature.fail("the open boundary has no length; correct it");
  if (const auto profile = feature.ref(6)) read_step_wall(*profile, draft, context);
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

struct BottomRow {
  std::string_view keyword;
  HoleBottom bottom;
};
constexpr BottomRow kHoleBottoms[] = {{"FLAT_HOLE_BOTTOM", HoleBottom::kFlat},
                                      {"THROUGH_BOTTOM_CONDITION", HoleBottom::kThrough},
                                      {"CONICAL_HOLE_BOTTOM", HoleBottom::kCone},
                                      {"SPHERICAL_HOLE_BOTTOM", HoleBottom::kBall},
                                      {"FLAT_WITH_RADIUS_HOLE_BOTTOM", HoleBottom::kFlatWithRadius}};

void read_hole_bottom(const Node& feature, Draft& draft, Context& context) {
  const auto bottom = feature.ref(7);
  if (!bottom) return context.note("no bottom condition; the hole is blind", feature);
  const BottomRow* found = nullptr;
  for (const BottomRow& row : kHoleBottoms)
    if (bottom->is(row.keyword)) found = &row;
  if (found == nullptr)
    bottom->fail("not a bottom of holes that can be read; give a flat, conical or spherical one, or through");
  draft.hole_end.bottom = found->bottom;
  draft.through = found->bottom == HoleBottom::kThrough;
  if (found->bottom == HoleBottom::kCone)
    draft.hole_end.angle = Radians::of(context.angle(bottom->needed_number(0, "tip angle")));
  if (found->bottom == HoleBottom::kBall) draft.hole_end.radius = bottom->needed_length(0, "radius");
  if (found->bottom == HoleBottom::kFlatWithRadius)
    draft.hole_end.radius = bottom->needed_length(0, "corner radius");
}

void read_round_hole(const Node& feature, const Frame& frame, Draft& draft, Context& context) {
  draft.kind = FeatureKind::kRoundHole;
  const double diameter = feature.needed_length(5, "diameter");
  if (diameter <= 0) feature.fail("the diameter is not above zero; correct it");
  draft.hole_diameter = diameter;
  draft.hole = toleranced(feature, 5);
  read_taper(feature, diameter, draft, context);
  read_hole_bottom(feature, draft, context);
  const Vec2 c{frame.origin.x, frame.origin.y};
  const Vec2 r{diameter / 2, 0};
  draft.boundary = {Edge::arc(c + r, c - r, c, Turn::kCounterClockwise),
                    Edge::arc(c - r, c + r, c, Turn::kCounterClockwise)};
}

constexpr double kMmInInch = 25.4;

/// Of a METRIC thread the pitch, of others how many threads an inch has.
double pitch_of(const Node& thread, double major) {
  const Node number = thread.needed_ref(12, "number of threads");
  const double value = number.needed_number(1, "number of threads");
  const std::string unit = number.text(2);
  number.use(2);
  const bool per_inch = unit.find("IN") != std::string::npos || unit.find("in") != std::string::npos ||
                        unit.find("TPI") != std::string::npos;
  const double pitch = per_inch ? kMmInInch / value : value;
  if (!(pitch > 0 && pitch < major / 2)) number.fail("it is no pitch of a thread so wide; give it in mm");
  return pitch;
}

/// Words in which a thread's form is one of 60 degrees: metric and unified threads.
bool is_of_60_degrees(const std::string& form) {
  return form.empty() || form.front() == 'M' || form.front() == 'm' || form.rfind("ISO", 0) == 0 ||
         form.rfind("UN", 0) == 0 || form.find("60") != std::string::npos;
}

std::string described(const Node& feature, std::size_t argument) {
  const auto text = feature.sound_ref(argument);
  return text ? text->text(1) : "";
}

/// thread_hand; a word that is neither LEFT nor RIGHT is named, and the thread taken as right-handed.
bool is_left_hand(const Node& thread, Context& context) {
  std::string hand = described(thread, 13);
  for (char& c : hand)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  const bool left = hand == "LEFT";
  if (!left && !hand.empty() && hand != "RIGHT")
    context.diagnostics.doubt(context.file.place(thread.line()), kNotFollowed,
                              thread.label() + ": its thread_hand '" + hand +
                                  "' is neither LEFT nor RIGHT; the thread is cut right-handed");
  return left;
}

/// What a tap makes in a hole that other features drill.
void read_thread(const Node& feature, const Frame& frame, Draft& draft, Context& context) {
  draft.kind = FeatureKind::kRoundHole;
  if (feature.flag(7) == false)
    feature.fail("external threads are not planned from STEP-NC; cut it elsewhere");
  Thread thread;
  thread.diameter = feature.needed_length(11, "major diameter");
  if (thread.diameter <= 0) feature.fail("the major diameter is not above zero; correct it");
  thread.pitch = pitch_of(feature, thread.diameter);
  thread.left_hand = is_left_hand(feature, context);
  if (!is_of_60_degrees(described(feature, 10)))
    feature.fail("its form is " + described(feature, 10) +
                 "; threads of 60 degrees are cut (metric, unified)");
  thread.name =
      "M" + trimmed(thread.diameter, 3) + "x" + trimmed(thread.pitch, 3) + (thread.left_hand ? "LH" : "");
  for (const Node& shape : feature.refs(6)) (void)shape;  // its placement says where it is
  if (const auto area = feature.sound_ref(5))
    if (const auto length = area->length(0); length && *length > 0) draft.depth_z = -*length;
  draft.thread = thread;
  draft.hole_diameter = minor_diameter(thread);
  draft.hole = {*draft.hole_diameter, 0, 0};
  const Vec2 c{frame.origin.x, frame.origin.y};
  const Vec2 r{thread.diameter / 2, 0};
  draft.boundary = {Edge::arc(c + r, c - r, c, Turn::kCounterClockwise),
                    Edge::arc(c - r, c + r, c, Turn::kCounterClockwise)};
  context.note("a thread of 60 degrees, " + thread.name, feature);
}

/// What is within a closed outside profile stays.
void keep_inside(const Node& feature, Loop outline, Draft& draft) {
  draft.bosses.push_back(std::move(outline));
  draft.boss_tops.push_back(0);
  draft.boss_ids.push_back(feature.id());
}

void read_outside_profile(const Node& feature, const Frame& frame, std::size_t argument, Draft& draft,
                          Context& context) {
  draft.kind = FeatureKind::kOutsideProfile;
  const Node profile = feature.needed_ref(argument, "boundary");
  if (is_closed_profile(profile)) {
    read_boundary(profile, frame, draft, context);
    keep_inside(feature, std::exchange(draft.boundary, {}), draft);
    draft.unplaced_boundary.clear();
  } else {
    draft.wall = planar_map(frame).path(open_profile(profile, context));
    if (draft.wall.empty()) profile.fail("the boundary has no length; give its curve");
    // A full turn, or a curve that ends where it begins, has no open side.
    if (distance(draft.wall.front().from, draft.wall.back().to) <= context.tol.join_gap)
      keep_inside(feature, std::exchange(draft.wall, {}), draft);
  }
  context.note("everything of the stock outside the profile is removed", feature);
}

/// Its place follows from the features whose edge it is.
void read_chamfer(const Node& feature, Draft& draft, Context& context) {
  draft.kind = FeatureKind::kChamfer;
  const double angle = context.angle(feature.needed_number(5, "angle"));
  constexpr double kLeast = 0.01;  // radians
  if (!(angle > kLeast && angle < kPi / 2 - kLeast))
    feature.fail("its angle is not between the two faces of the edge; give one from 1 to 89 degrees");
  const double offset = feature.needed_length(6, "offset");
  if (offset <= 0) feature.fail("its offset is not above zero; correct it");
  draft.edge = BrokenEdge{feature.needed_ref(3, "first feature"), feature.needed_ref(4, "second feature"),
                          Radians::of(angle), offset};
}

[[noreturn]] void refuse(const Node& feature) {
  refuse_listed(feature);
  feature.fail(
      "features of this kind cannot be machined yet; write it as pockets, faces, slots, steps or round "
      "holes");
}

void read_kind(const Node& feature, const Frame& frame, Draft& draft, Context& context) {
  if (feature.is("CHAMFER")) return read_chamfer(feature, draft, context);
  if (feature.is("CLOSED_POCKET")) return read_closed_pocket(feature, frame, draft, context);
  if (feature.is("OPEN_POCKET")) return read_open_pocket(feature, frame, draft, context);
  if (feature.is("PLANAR_FACE")) return read_planar_face(feature, frame, draft, context);
  if (feature.is("REGION_PROJECTION")) return read_region(feature, frame, draft, context);
  if (feature.is("SLOT")) return read_slot(feature, frame, draft, context);
  if (feature.is("STEP")) return read_step(feature, frame, draft, context);
  if (feature.is("ROUND_HOLE")) return read_round_hole(feature, frame, draft, context);
  if (feature.is_any("CATALOGUE_THREAD", "DEFINED_THREAD"))
    return read_thread(feature, frame, draft, context);
  if (feature.is("GENERAL_OUTSIDE_PROFILE")) return read_outside_profile(feature, frame, 6, draft, context);
  if (feature.keyword().find("_SHAPE_PROFILE") != std::string::npos)
    return read_outside_profile(feature, frame, 8, draft, context);
  refuse(feature);
}

}  // namespace

Draft draft_feature(const Member& member, Context& context) {
  const Node& feature = member.feature;
  Draft draft(feature);
  draft.name = member.name;
  if (!is_simple_feature(feature)) refuse(feature);
  if (!feature.is("CHAMFER"))
    check_upright(member);  // its place is that of the edge, whatever way the workpiece lies
  draft.placement = member.placement;
  draft.placement_z = member.placement.origin.z;
  const bool has_length = feature.is_any("CATALOGUE_THREAD", "DEFINED_THREAD") && feature.sound_ref(5);
  const bool has_no_depth =
      (has_length && feature.unset(4)) || feature.is_any("CHAMFER", "REGION_PROJECTION");
  draft.depth_z = has_no_depth ? 0 : depth_of(feature);
  read_kind(feature, member.placement, draft, context);
  return draft;
}

}  // namespace clearcut::read::stepnc
