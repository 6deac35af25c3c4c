// How far a cutter may go beyond a feature.
//
// A closed feature has walls all round: target and allowed are its boundary minus its bosses. Faces, slots,
// steps, open pockets and outside profiles are open where their boundary B reaches the stock's edge. With S
// the stock and `air` = everything outside S up to kOpenReach,
//     target  = (B - bosses) within S
//     allowed = (B - bosses) united with air
// so that only true walls, those inside S, bound `allowed`. B is first snapped to edges of S that it misses
// by less than tol.join_gap, and it reaches beyond S where a side is open, so that the union needs no
// coincident edges.
#include "read/stepnc/shapes/regions.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "base/tolerances.h"
#include "geometry/contours/boolean.h"
#include "geometry/region.h"
#include "read/repair/edge_index.h"
#include "read/repair/repair.h"

namespace clearcut::read::stepnc {

namespace {

bool within(const Box& inner, const Box& outer) {
  return outer.contains(inner.min) && outer.contains(inner.max);
}

/// A loop as valid regions, mended where it must be.
Regions valid_regions(const Loop& loop, const Draft& draft, Context& context) {
  context.spend(loop.size(), draft.node);
  RepairOptions options;
  options.tol = context.tol;
  options.where = context.file.place(draft.node.line()) + ": " + draft.node.label();
  return repair({RawCurve{loop, true, draft.node.label()}}, options, context.diagnostics);
}

/// Vertices nearer than tol.join_gap to an edge line of the stock are moved onto it.
Loop snapped(const Loop& loop, const Box& stock, const Tolerances& tol) {
  std::vector<BulgeVertex> vertices = to_bulges(loop);
  bool moved = false;
  const auto snap = [&](double& value, double edge) {
    if (value == edge || std::abs(value - edge) > tol.join_gap) return;
    value = edge;
    moved = true;
  };
  for (BulgeVertex& v : vertices) {
    snap(v.point.x, stock.min.x);
    snap(v.point.x, stock.max.x);
    snap(v.point.y, stock.min.y);
    snap(v.point.y, stock.max.y);
  }
  return moved ? loop_from_bulges(vertices) : loop;
}

bool crosses(const Loop& a, const Loop& b) {
  const std::vector<Loop> others{b};
  const EdgeIndex index(others);
  bool found = false;
  for (const Edge& e : a) {
    index.visit(e.box().grown(kSamePlaceMm), [&](EdgeId id) {
      found = distance(e, index.edge(id)) < kSamePlaceMm;
      return !found;
    });
    if (found) return true;
  }
  return false;
}

bool inside(const Loop& inner, const Loop& outer) {
  return within(box(inner), box(outer)) && !crosses(inner, outer) && contains(outer, inner.front().from);
}

/// Are the islands strictly inside `outer` and apart from each other? Then no boolean is needed.
bool plainly_nested(const Loop& outer, const std::vector<Loop>& islands) {
  for (std::size_t i = 0; i < islands.size(); ++i) {
    if (!inside(islands[i], outer)) return false;
    for (std::size_t j = i + 1; j < islands.size(); ++j) {
      const bool apart =
          !box(islands[i]).overlaps(box(islands[j])) ||
          (!crosses(islands[i], islands[j]) && !contains(islands[i], islands[j].front().from) &&
           !contains(islands[j], islands[i].front().from));
      if (!apart) return false;
    }
  }
  return true;
}

/// `outers` minus the bosses. Bosses in plain view keep every edge exactly.
Regions without_bosses(Regions outers, const Draft& draft, Context& context) {
  if (draft.bosses.empty()) return outers;
  Regions bosses;
  bool simple = outers.size() == 1 && outers[0].islands().empty();
  std::vector<Loop> islands;
  for (const Loop& boss : draft.bosses) {
    for (const Region& region : valid_regions(boss, draft, context)) {
      bosses.push_back(region);
      islands.push_back(region.outer());
      simple = simple && region.islands().empty();
    }
  }
  if (simple && plainly_nested(outers[0].outer(), islands))
    return {Region::from_valid_loops(outers[0].outer(), islands)};
  for (const Region& boss : bosses) outers = subtract(outers, {boss}, context.tol);
  return outers;
}

/// Closes a wall (material on its left) around the outside of the stock, on the side to be removed.
class OpenSide {
 public:
  OpenSide(const Draft& draft, const Box& stock) : draft_(draft), stock_(stock) {}

  /// The standard puts the material on the wall's left. A step that would take the larger part of the stock
  /// so was drawn the other way round.
  Loop closed(Context& context) const {
    warn_of_inner_ends(context);
    const Loop standard = closed_around(reversed(draft_.wall));
    const Loop other = closed_around(draft_.wall);
    if (draft_.kind == FeatureKind::kOutsideProfile)
      return standard;  // what stays is on its left, however small
    if (!draft_.wall_is_step) return closed_pocket(standard, other, context);
    if (removed_area(standard) <= removed_area(other)) return standard;
    context.warn(
        "read by the standard the step would take the larger part of the stock; the other side is taken",
        draft_.node);
    return other;
  }

 private:
  /// An open pocket whose outline bulges to the side of the material, and that would take the larger part of the stock, was drawn the other
  /// way round. A pocket about a block that stands in a corner of the stock is drawn like that too: who is to tell has to know.
  Loop closed_pocket(const Loop& standard, const Loop& other, Context& context) const {
    Loop chord = draft_.wall;
    if (chord.back().to != chord.front().from)
      chord.push_back(Edge::line(chord.back().to, chord.front().from));
    double area = 0;
    for (const Edge& edge : chord) area += edge.signed_area();
    if (!(area > 0) || removed_area(standard) <= removed_area(other)) return standard;
    const std::string where = context.file.place(draft_.node.line());
    const std::string what =
        draft_.node.label() +
        ": read by the standard (material on the left of its open boundary) the pocket would take the "
        "larger part of the stock, and its outline bulges to the other side; that side is taken";
    if (ends_on_one_side())
      context.diagnostics.warn(where, what);
    else
      context.diagnostics.doubt(where, kNotFollowed, what);
    return other;
  }

  /// Whether it leaves the stock by the side by which it comes in, so that one side of the stock closes it.
  bool ends_on_one_side() const {
    const Vec2 begin = draft_.wall.front().from, end = draft_.wall.back().to;
    const auto both = [&](auto is_beyond) { return is_beyond(begin) && is_beyond(end); };
    constexpr double kOnSide = 0.01;  // mm
    return both([&](Vec2 p) { return p.x <= stock_.min.x + kOnSide; }) ||
           both([&](Vec2 p) { return p.x >= stock_.max.x - kOnSide; }) ||
           both([&](Vec2 p) { return p.y <= stock_.min.y + kOnSide; }) ||
           both([&](Vec2 p) { return p.y >= stock_.max.y - kOnSide; });
  }

  void warn_of_inner_ends(Context& context) const {
    const Box inner = stock_.grown(-context.tol.join_gap);
    if (!inner.contains(draft_.wall.front().from) && !inner.contains(draft_.wall.back().to)) return;
    if (draft_.wall_is_step)
      context.warn("an end of the step lies inside the stock; a wall is left there", draft_.node);
    else
      context.diagnostics.doubt(
          context.file.place(draft_.node.line()), kNotFollowed,
          draft_.node.label() +
              ": an end of its open side lies inside the stock; it is opened straight to the nearest edge");
  }

  double reach() const { return stock_.width() + stock_.height() + 10; }

  /// How much of the stock the loop takes, roughly.
  int removed_area(const Loop& loop) const {
    int inside_count = 0;
    constexpr int kSteps = 40;
    for (int i = 0; i < kSteps; ++i)
      for (int j = 0; j < kSteps; ++j) {
        const Vec2 p{stock_.min.x + stock_.width() * (i + 0.5) / kSteps,
                     stock_.min.y + stock_.height() * (j + 0.5) / kSteps};
        if (contains(loop, p)) ++inside_count;
      }
    return inside_count;
  }

  /// The region to the left of `wall`.
  Loop closed_around(const Path& wall) const {
    Loop loop = wall;
    const Vec2 begin = wall.front().from, end = wall.back().to;
    if (draft_.wall_is_step) {
      const Vec2 out = left_of(unit(end - begin)) * reach();
      append(loop, {end + out, begin + out, begin});
      return loop;
    }
    const Box ring = around(wall);
    std::vector<Vec2> points{exit(end, ring)};
    walk(ring, points, exit(begin, ring));
    points.push_back(begin);
    append(loop, points);
    return loop;
  }

  Box around(const Path& wall) const {
    Box ring = stock_;
    ring.add(box(wall));
    return ring.grown(10);
  }

  static void append(Loop& loop, const std::vector<Vec2>& points) {
    for (const Vec2 p : points)
      if (p != loop.back().to) loop.push_back(Edge::line(loop.back().to, p));
  }

  /// Straight out from p to the nearest side of the ring.
  static Vec2 exit(Vec2 p, const Box& ring) {
    const double to[] = {p.y - ring.min.y, ring.max.x - p.x, ring.max.y - p.y, p.x - ring.min.x};
    switch (std::min_element(to, to + 4) - to) {
      case 0:
        return {p.x, ring.min.y};
      case 1:
        return {ring.max.x, p.y};
      case 2:
        return {p.x, ring.max.y};
      default:
        return {ring.min.x, p.y};
    }
  }

  /// Place of a point of the ring on its way round, counter-clockwise from the lower left corner.
  static double along(Vec2 p, const Box& ring) {
    const double w = ring.width(), h = ring.height();
    if (p.y == ring.min.y) return p.x - ring.min.x;
    if (p.x == ring.max.x) return w + (p.y - ring.min.y);
    if (p.y == ring.max.y) return w + h + (ring.max.x - p.x);
    return 2 * w + h + (ring.max.y - p.y);
  }

  /// From the last of `points` counter-clockwise round the ring to `target`.
  static void walk(const Box& ring, std::vector<Vec2>& points, Vec2 target) {
    const Vec2 corners[] = {{ring.max.x, ring.min.y}, ring.max, {ring.min.x, ring.max.y}, ring.min};
    const double round = 2 * (ring.width() + ring.height());
    const double start = along(points.back(), ring);
    double goal = along(target, ring) - start;
    if (goal <= 0) goal += round;
    std::vector<std::pair<double, Vec2>> passed;
    for (const Vec2 corner : corners) {
      double at = along(corner, ring) - start;
      if (at <= 0) at += round;
      if (at < goal) passed.push_back({at, corner});
    }
    std::sort(passed.begin(), passed.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [at, corner] : passed) points.push_back(corner);
    points.push_back(target);
  }

  const Draft& draft_;
  const Box& stock_;
};

/// One edge of a slot's course widened to both sides.
Loop widened(const Edge& edge, double half_width, const Draft& draft) {
  if (!edge.is_arc()) {
    const Vec2 side = left_of(edge.tangent_at(0)) * half_width;
    const Vec2 corners[] = {edge.from - side, edge.to - side, edge.to + side, edge.from + side};
    return loop_from_points(corners);
  }
  const double radius = edge.radius();
  if (radius <= half_width)
    draft.node.fail("the course of travel bends tighter than half the slot's width; widen its arc");
  const auto at = [&](Vec2 p, double r) { return edge.center + unit(p - edge.center) * r; };
  const double inner = radius - half_width, outer = radius + half_width;
  return {Edge::arc(at(edge.from, outer), at(edge.to, outer), edge.center, edge.turn),
          Edge::line(at(edge.to, outer), at(edge.to, inner)),
          Edge::arc(at(edge.to, inner), at(edge.from, inner), edge.center,
                    edge.turn == Turn::kCounterClockwise ? Turn::kClockwise : Turn::kCounterClockwise),
          Edge::line(at(edge.from, inner), at(edge.from, outer))};
}

Loop disc(Vec2 center, double radius) {
  const Vec2 r{radius, 0};
  return {Edge::arc(center + r, center - r, center, Turn::kCounterClockwise),
          Edge::arc(center - r, center + r, center, Turn::kCounterClockwise)};
}

bool is_closed_course(const Path& course, const Context& context) {
  return distance(course.front().from, course.back().to) <= context.tol.join_gap;
}

/// The course, prolonged at open ends so that the slot leaves the stock.
Path prolonged_course(const Draft& draft, const Box& stock, Context& context) {
  Path course = draft.course;
  if (is_closed_course(course, context)) return course;
  const double extra = draft.width + 2;
  const auto open = [&](int end, Vec2 at) {
    const bool at_edge = !stock.grown(-context.tol.join_gap).contains(at);
    const bool said_open = draft.ends_given && draft.ends[end] == SlotEnd::kOpen;
    if (said_open && !at_edge)
      context.warn("an open end lies inside the stock; a wall is left there", draft.node);
    return at_edge && (said_open || !draft.ends_given);
  };
  const auto prolong = [&](Edge& edge, bool at_start) {
    const Vec2 tangent = edge.tangent_at(at_start ? 0 : 1);
    const Edge stub = at_start ? Edge::line(edge.from - tangent * extra, edge.from)
                               : Edge::line(edge.to, edge.to + tangent * extra);
    if (!edge.is_arc() && at_start) edge.from = stub.from;
    if (!edge.is_arc() && !at_start) edge.to = stub.to;
    if (edge.is_arc()) course.insert(at_start ? course.begin() : course.end(), stub);
  };
  if (open(0, course.front().from)) prolong(course.front(), true);
  if (open(1, course.back().to)) prolong(course.back(), false);
  return course;
}

/// The band that a slot of `course` takes.
Regions slot_regions(const Draft& draft, const Path& course, Context& context) {
  context.spend(course.size(), draft.node);
  std::vector<Loop> pieces;
  for (const Edge& edge : course) pieces.push_back(widened(edge, draft.width / 2, draft));
  for (std::size_t i = 1; i < course.size(); ++i)
    if (std::abs(cross(course[i - 1].tangent_at(1), course[i].tangent_at(0))) > 1e-9)
      pieces.push_back(disc(course[i].from, draft.width / 2));
  if (draft.ends_given && draft.ends[0] == SlotEnd::kRound)
    pieces.push_back(disc(course.front().from, draft.width / 2));
  if (draft.ends_given && draft.ends[1] == SlotEnd::kRound)
    pieces.push_back(disc(course.back().to, draft.width / 2));
  Regions band = valid_regions(pieces[0], draft, context);
  for (std::size_t i = 1; i < pieces.size(); ++i)
    band = unite(band, {Region::from_valid_loops(pieces[i], {})}, context.tol);
  return band;
}

/// B of the head comment, without bosses taken off. `whole_stock` where nothing bounds the feature.
Regions boundary_regions(const Draft& draft, const Box& stock, Context& context) {
  if (draft.kind == FeatureKind::kSlot)
    return slot_regions(draft, prolonged_course(draft, stock, context), context);
  if (!draft.wall.empty())
    return valid_regions(snapped(OpenSide(draft, stock).closed(context), stock, context.tol), draft, context);
  return valid_regions(snapped(draft.boundary, stock, context.tol), draft, context);
}

FeatureRegions whole_stock_regions(const Draft& draft, const Box& stock, Context& context) {
  FeatureRegions result;
  result.target = without_bosses({rectangular_region(stock)}, draft, context);
  result.allowed = without_bosses({rectangular_region(stock.grown(kOpenReach))}, draft, context);
  return result;
}

FeatureRegions open_regions(const Draft& draft, const Box& stock, Context& context) {
  if (draft.boundary.empty() && draft.wall.empty() && draft.course.empty())
    return whole_stock_regions(draft, stock, context);
  const Regions cut = without_bosses(boundary_regions(draft, stock, context), draft, context);
  const Box reach = box(cut);
  FeatureRegions result;
  const bool inside_stock = within(reach, stock);
  result.target = inside_stock ? cut : intersect(cut, {rectangular_region(stock)}, context.tol);
  const bool open = !within(reach, stock.grown(-context.tol.join_gap / 2));
  if (!open) {
    context.note("it does not reach the edge of the stock; all its sides are walls", draft.node);
    result.allowed = result.target;
    return result;
  }
  const Region air = frame_around(stock, kOpenReach);
  result.allowed = unite(cut, {air}, context.tol);
  return result;
}

/// Some writers repeat the feature's placement in the profile; read by the standard the pocket then lies off
/// the stock.
Loop placed_boundary(const Draft& draft, const std::optional<Stock>& stock, Context& context) {
  if (!stock || draft.unplaced_boundary.empty()) return draft.boundary;
  const Box near = stock->plan.grown(context.tol.join_gap);
  if (within(box(draft.boundary), near) || !within(box(draft.unplaced_boundary), near)) return draft.boundary;
  context.diagnostics.warn(
      context.file.place(draft.node.line()),
      draft.node.label() +
          ": its profile's placement puts it outside the stock, and without that placement it fits; "
          "the profile's placement is left out");
  return draft.unplaced_boundary;
}

FeatureRegions closed_regions(const Draft& draft, const std::optional<Stock>& stock, Context& context) {
  const Regions cut = without_bosses(valid_regions(draft.boundary, draft, context), draft, context);
  if (stock && !within(box(cut), stock->plan.grown(context.tol.join_gap)))
    context.warn("reaches beyond the stock, though its walls are closed", draft.node);
  return {cut, cut};
}

/// A slot with a wall at either end, or that runs in a circle.
bool is_closed_slot(const Draft& draft, const Context& context) {
  if (draft.kind != FeatureKind::kSlot) return false;
  const bool walls = draft.ends_given && draft.ends[0] != SlotEnd::kOpen && draft.ends[1] != SlotEnd::kOpen;
  return walls || is_closed_course(draft.course, context);
}

}  // namespace

std::optional<Box> plan_of_drafts(const std::vector<Draft>& drafts) {
  Box plan;
  bool face = false;
  for (const Draft& draft : drafts) {
    face = face || (draft.kind == FeatureKind::kPlanarFace && !draft.boundary.empty());
    for (const Path* path : {&draft.boundary, &draft.wall, &draft.course})
      if (!path->empty()) plan.add(box(*path));
    for (const Loop& boss : draft.bosses) plan.add(box(boss));
  }
  return face ? std::optional(plan) : std::nullopt;
}

FeatureRegions feature_regions(const Draft& draft_in, const std::optional<Stock>& stock, Context& context) {
  Draft draft = draft_in;
  draft.boundary = placed_boundary(draft_in, stock, context);
  const bool closed = draft.kind == FeatureKind::kClosedPocket || draft.kind == FeatureKind::kRoundHole;
  if (!stock && is_closed_slot(draft, context)) {
    const Regions band = slot_regions(draft, draft.course, context);
    return {band, band};
  }
  if (!closed && !stock)
    draft.node.fail(
        "its open sides need the size of the stock; give the WORKPIECE a BLOCK as bounding geometry");
  FeatureRegions result =
      closed ? closed_regions(draft, stock, context) : open_regions(draft, stock->plan, context);
  if (result.target.empty() || area(result.target) < 1e-6)
    draft.node.fail("nothing of the stock lies inside its boundary; check placement and profile");
  return result;
}

Path groove_course(const Draft& draft, const std::optional<Stock>& stock, Context& context) {
  if (draft.ends_given && (draft.ends[0] == SlotEnd::kFlat || draft.ends[1] == SlotEnd::kFlat))
    draft.node.fail(
        "its end is flat, and the cutter that makes its section leaves a round one; write the end as round "
        "or open");
  if (stock) return prolonged_course(draft, stock->plan, context);
  return draft.course;
}

}  // namespace clearcut::read::stepnc
