#include "read/stepnc/shapes/curve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/elementary.h"
#include "base/text.h"
#include "base/units.h"
#include "read/common/curve_fit.h"

namespace clearcut::read::stepnc {

namespace {

constexpr int kDeepest = 16;         // nesting of composite curves
constexpr double kOnCircle = 1e-8;   // mm; trim points this near to their circle are on it
constexpr double kOffCircle = 0.02;  // mm; trim points farther off than this are an error

std::string shown(Vec2 p) {
  return "(" + trimmed(p.x, 4) + ", " + trimmed(p.y, 4) + ")";
}

Path polyline_path(const Node& curve, Context& context) {
  const std::vector<Node> points = curve.refs(1);
  context.spend(points.size(), curve);
  Path path;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 from = in_plan(location_of(points[i - 1])), to = in_plan(location_of(points[i]));
    if (from != to) path.push_back(Edge::line(from, to));
  }
  return path;
}

/// Center, radius and senses of a CIRCLE, in plan.
struct Circle {
  Vec2 center;
  double radius = 0;
  PlanarMap map;
};

Circle circle_of(const Node& node) {
  const Frame frame = frame_of(node.ref(1));
  if (!is_planar(frame))
    node.fail("the circle is tilted out of the plane; only plane outlines can be milled");
  const double radius = node.needed_length(2, "radius");
  if (radius <= 0) node.fail("the radius is not above zero; correct it");
  return {in_plan(frame.origin), radius, planar_map(frame)};
}

Path full_circle(const Circle& circle, double start, bool counter_clockwise) {
  const Vec2 a = circle.map.point(circle.radius * direction_of(start));
  const Vec2 b = circle.center * 2.0 - a;
  const Turn turn = counter_clockwise ? Turn::kCounterClockwise : Turn::kClockwise;
  return {Edge::arc(a, b, circle.center, turn), Edge::arc(b, a, circle.center, turn)};
}

/// What a trim of a curve says: a point, a parameter, or both.
struct Trim {
  std::optional<Vec2> point;
  std::optional<double> parameter;
};

Trim trim_of(const Node& curve, std::size_t argument) {
  Trim trim;
  for (const P21Value& v : curve.list(argument)) {
    if (v.kind == P21Kind::kReference) {
      const P21Entity* entity = curve.file().find(v.id);
      if (entity == nullptr)
        curve.fail("refers to #" + std::to_string(v.id) + ", which is not in the file; add it");
      trim.point = in_plan(location_of(Node(curve.file(), *entity)));
    } else if (v.kind == P21Kind::kTyped) {
      const auto inner = curve.file().children(v);
      if (inner.size() == 1) trim.parameter = inner[0].number;
    } else if (v.kind == P21Kind::kReal || v.kind == P21Kind::kInteger) {
      trim.parameter = v.number;
    }
  }
  if (!trim.point && !trim.parameter)
    curve.fail("a trim has neither point nor parameter; give its end points");
  return trim;
}

Vec2 point_on_circle(const Circle& circle, const Trim& trim, bool by_parameter, const Context& context) {
  if (trim.point && !(by_parameter && trim.parameter)) return *trim.point;
  return circle.map.point(circle.radius * direction_of(context.angle(*trim.parameter)));
}

void check_on_circle(const Node& curve, const Circle& circle, Vec2 p) {
  const double off = std::abs(distance(p, circle.center) - circle.radius);
  if (off > kOffCircle)
    curve.fail("trim point " + shown(p) + " is " + trimmed(off, 4) +
               " mm off its circle; correct point or circle");
}

Path arc_path(const Node& curve, const Node& base, Context& context) {
  const Circle circle = circle_of(base);
  const bool by_parameter = curve.enumeration(5) == "PARAMETER";
  const Vec2 a = point_on_circle(circle, trim_of(curve, 2), by_parameter, context);
  const Vec2 b = point_on_circle(circle, trim_of(curve, 3), by_parameter, context);
  const bool counter_clockwise = curve.flag(4).value_or(true) != circle.map.mirrored;
  check_on_circle(curve, circle, a);
  check_on_circle(curve, circle, b);
  if (distance(a, b) <= context.tol.coincident) {
    Circle at_a = circle;
    at_a.map = {circle.center, unit(a - circle.center), left_of(unit(a - circle.center)), false};
    return full_circle(at_a, 0, counter_clockwise);
  }
  return {arc_through(a, b, circle.center, circle.radius,
                      counter_clockwise ? Turn::kCounterClockwise : Turn::kClockwise)};
}

/// A line whose ends are trimmed by points needs neither its own point nor its direction. Where they are stated, they have to agree with
/// the points: else one of both is wrong, and nobody knows which.
void check_on_line(const Node& curve, const Node& base, Vec2 a, Vec2 b, Context& context) {
  const auto vector = base.sound_ref(2);
  if (base.unset(1) || !vector || vector->unset(1) || a == b) return;
  const Vec2 through = in_plan(location_of(base.needed_ref(1, "point")));
  const Vec2 direction = in_plan(axis_of(vector->needed_ref(1, "direction")));
  vector->use(2);  // the parameters of points are not asked for
  const double length = norm(direction);
  const auto off = [&](Vec2 p) {
    return length > 0 ? std::abs(cross(direction, p - through)) / length : 0.0;
  };
  const bool forwards = dot(direction, b - a) >= 0, stated_forwards = curve.flag(4).value_or(forwards);
  if (std::max(off(a), off(b)) <= kOffCircle && length > 0 && forwards == stated_forwards) return;
  context.diagnostics.doubt(context.file.place(curve.line()), kNotFollowed,
                            "not followed: the line of " + curve.label() + " (" + base.label() +
                                ") does not go from " + shown(a) + " to " + shown(b) +
                                " as its trim points do; the points are used");
}

Path line_path(const Node& curve, const Node& base, Context& context) {
  const Trim first = trim_of(curve, 2), second = trim_of(curve, 3);
  const auto end = [&](const Trim& trim) {
    if (trim.point) return *trim.point;
    const Node vector = base.needed_ref(2, "direction");
    const Vec2 direction = in_plan(axis_of(vector.needed_ref(1, "direction")));
    const double magnitude = vector.length(2).value_or(1.0);
    if (norm(direction) == 0) base.fail("the line has no direction in the plane; correct it");
    return in_plan(location_of(base.needed_ref(1, "point"))) +
           unit(direction) * (magnitude * *trim.parameter);
  };
  const Vec2 a = end(first), b = end(second);
  check_on_line(curve, base, a, b, context);
  return a == b ? Path{} : Path{Edge::line(a, b)};
}

Path ellipse_path(const Node& curve, Context& context) {
  const Frame frame = frame_of(curve.ref(1));
  if (!is_planar(frame))
    curve.fail("the ellipse is tilted out of the plane; only plane outlines can be milled");
  const double a = curve.needed_length(2, "first semi-axis"), b = curve.needed_length(3, "second semi-axis");
  if (a <= 0 || b <= 0) curve.fail("a semi-axis is not above zero; correct it");
  const PlanarMap map = planar_map(frame);
  const Vec2 center = in_plan(frame.origin);
  Path path;
  append_elliptical({center, map.point({a, 0}) - center, map.point({0, b}) - center, 0, 2 * kPi},
                    kCurveTolerance, path);
  context.note("an ellipse or a spline; lines and arcs within 2 um stand for it", curve);
  return path;
}

/// Knots of a BEZIER_CURVE: its pieces one after the other; else of a B_SPLINE_CURVE_WITH_KNOTS.
std::vector<double> knots_of(const Node& curve, int degree, std::size_t poles) {
  std::vector<double> knots;
  const auto add = [&](double times, double value) {
    if (!(times >= 1) || times > degree + 1) curve.fail("a knot's multiplicity is out of range; correct it");
    knots.insert(knots.end(), static_cast<std::size_t>(times), value);
  };
  if (curve.is("BEZIER_CURVE")) {
    const std::size_t pieces = degree > 0 ? (poles - 1) / static_cast<std::size_t>(degree) : 0;
    for (std::size_t i = 0; i <= pieces; ++i)
      add(i == 0 || i == pieces ? degree + 1 : degree, static_cast<double>(i));
    return knots;
  }
  const auto times = curve.numbers(6), values = curve.numbers(7);
  if (times.size() != values.size())
    curve.fail("its knots and their multiplicities differ in number; correct it");
  for (std::size_t i = 0; i < values.size(); ++i) add(times[i], values[i]);
  return knots;
}

Path spline_path(const Node& curve, Context& context) {
  const std::vector<Node> points = curve.refs(2);
  context.spend(points.size(), curve);
  const double degree = curve.needed_number(1, "degree");
  BSpline spline;
  spline.degree = degree >= 1 && degree < 100 ? static_cast<int>(degree) : 0;
  for (const Node& point : points) spline.poles.push_back({in_plan(location_of(point)), 1});
  if (spline.degree > 0 && !spline.poles.empty())
    spline.knots = knots_of(curve, spline.degree, spline.poles.size());
  if (const std::string fault = fault_of(spline); !fault.empty())
    curve.fail("a spline with " + fault + "; correct it");
  Path path;
  append_spline(spline, kCurveTolerance, path);
  context.note("an ellipse or a spline; lines and arcs within 2 um stand for it", curve);
  return path;
}

/// Joins `next` to `path`, whose end it should begin at.
void append_joined(Path& path, Path next, const Node& node, Context& context) {
  if (path.empty() || next.empty()) {
    path.insert(path.end(), next.begin(), next.end());
    return;
  }
  const Vec2 end = path.back().to;
  double gap = distance(end, next.front().from);
  if (gap > context.tol.join_gap && distance(end, next.back().to) <= context.tol.join_gap) {
    next = reversed(next);
    gap = distance(end, next.front().from);
    context.note("runs against its outline; turned round", node);
  }
  if (gap > context.tol.join_gap)
    node.fail("the outline has a gap of " + trimmed(gap, 4) + " mm at " + shown(end) + "; close it (up to " +
              trimmed(context.tol.join_gap, 4) + " mm are closed by themselves)");
  if (gap > context.tol.coincident)
    context.diagnostics.repair(context.file.place(node.line()), node.label() + ": closed a gap of " +
                                                                    trimmed(gap, 5) + " mm at " + shown(end));
  Edge& first = next.front();
  if (first.from != end) {
    first = !first.is_arc() || end == first.to
                ? Edge::line(end, first.to)
                : arc_through(end, first.to, first.center, first.radius(), first.turn);
    if (end == first.to) next.erase(next.begin());
  }
  path.insert(path.end(), next.begin(), next.end());
}

Path path_at(const Node& curve, Context& context, int depth);

Path composite_path(const Node& curve, Context& context, int depth) {
  Path path;
  for (const Node& segment : curve.refs(1)) {
    context.spend(1, segment);
    const Node parent = segment.is("COMPOSITE_CURVE_SEGMENT") ? segment.needed_ref(2, "curve") : segment;
    if (segment.is("COMPOSITE_CURVE_SEGMENT")) segment.use(0);  // ends are joined whatever the transition
    Path next = path_at(parent, context, depth + 1);
    if (segment.is("COMPOSITE_CURVE_SEGMENT") && segment.flag(1) == false) next = reversed(next);
    append_joined(path, std::move(next), parent, context);
  }
  return path;
}

Path path_at(const Node& curve, Context& context, int depth) {
  if (depth > kDeepest)
    curve.fail("composite curves are nested more than 16 deep (or in a circle); flatten them");
  context.spend(1, curve);
  if (curve.is("POLYLINE")) return polyline_path(curve, context);
  if (curve.is("COMPOSITE_CURVE")) return composite_path(curve, context, depth);
  if (curve.is("CIRCLE")) return full_circle(circle_of(curve), 0, true);
  if (curve.is("ELLIPSE")) return ellipse_path(curve, context);
  if (curve.is_any("B_SPLINE_CURVE_WITH_KNOTS", "BEZIER_CURVE")) return spline_path(curve, context);
  if (curve.is("TRIMMED_CURVE")) {
    const Node base = curve.needed_ref(1, "basis curve");
    if (base.is("CIRCLE")) return arc_path(curve, base, context);
    if (base.is("LINE")) return line_path(curve, base, context);
    base.fail("only lines and circles can be trimmed here; write the outline with lines and arcs");
  }
  curve.fail(
      "not a curve that can be read (polyline, trimmed line or circle, ellipse, spline, composite); write it "
      "with lines and "
      "arcs");
}

}  // namespace

Edge arc_through(Vec2 a, Vec2 b, Vec2 center, double radius, Turn turn) {
  const auto off = [&](Vec2 p) { return std::abs(distance(p, center) - radius); };
  if (off(a) <= kOnCircle && off(b) <= kOnCircle) return Edge::arc(a, b, center, turn);
  const Vec2 middle = lerp(a, b, 0.5);
  const Vec2 normal = left_of(unit(b - a));
  const double along = dot(center - middle, normal);
  const double half = distance(a, b) / 2;
  // Beyond 120 degrees the center is badly determined by the radius: keep it where it was, on the bisector.
  const bool by_radius =
      half < radius * base::sin(kPi / 3) && (along > 0) == (turn == Turn::kCounterClockwise);
  const double height = by_radius ? std::copysign(std::sqrt(radius * radius - half * half), along) : along;
  return Edge::arc(a, b, middle + normal * height, turn);
}

Path without_tiny_edges(Path path, const Tolerances& tol) {
  Path result;
  for (const Edge& edge : path) {
    const bool tiny = distance(edge.from, edge.to) <= tol.coincident && std::abs(edge.sweep()) < kPi;
    if (tiny) continue;
    result.push_back(edge);
    if (result.size() > 1) result.back().from = result[result.size() - 2].to;
  }
  return result;
}

Path curve_path(const Node& curve, Context& context) {
  return without_tiny_edges(path_at(curve, context, 0), context.tol);
}

Loop curve_loop(const Node& curve, Context& context) {
  Path path = curve_path(curve, context);
  if (path.empty()) curve.fail("the outline has no length; give its points");
  const Vec2 start = path.front().from, end = path.back().to;
  if (start == end) return path;
  const double gap = distance(start, end);
  if (curve.is("POLYLINE") && gap > context.tol.join_gap) {
    path.push_back(Edge::line(end, start));
    return path;
  }
  if (gap > context.tol.join_gap)
    curve.fail("the outline does not close: its ends are " + trimmed(gap, 4) + " mm apart at " + shown(end) +
               "; close it");
  if (gap > context.tol.coincident)
    context.diagnostics.repair(
        context.file.place(curve.line()),
        curve.label() + ": closed a gap of " + trimmed(gap, 5) + " mm at " + shown(end));
  Edge& last = path.back();
  if (last.from == start) {
    path.pop_back();
    if (path.empty()) curve.fail("the outline has no area; correct it");
    path.back().to = start;
  } else {
    last = last.is_arc() ? arc_through(last.from, start, last.center, last.radius(), last.turn)
                         : Edge::line(last.from, start);
  }
  return path;
}

// The centre of a fillet lies `radius` to the left of both edges: where their offset lines and circles cross, nearest to the corner.

namespace {

constexpr double kCorner = 0.02;  ///< sine of the turn; less goes on smoothly
constexpr double kOnEdge = 1e-7;  // mm; touching points that are nearer to an edge's end are its end

/// What lies `radius` to the left of an edge's line or circle.
struct OffsetEdge {
  bool is_arc = false;
  Vec2 at;            ///< a point of the line; the centre of the circle
  Vec2 along;         ///< of lines, length 1
  double radius = 0;  ///< of circles
};

std::optional<OffsetEdge> offset_left(const Edge& edge, double by) {
  if (!edge.is_arc()) {
    const Vec2 along = edge.tangent_at(0);
    return OffsetEdge{false, edge.from + left_of(along) * by, along, 0};
  }
  const double radius = edge.radius() + (edge.turn == Turn::kCounterClockwise ? -by : by);
  if (radius <= kOnEdge) return std::nullopt;
  return OffsetEdge{true, edge.center, {}, radius};
}

void cross_line_circle(const OffsetEdge& line, const OffsetEdge& circle, std::vector<Vec2>& out) {
  const double along = dot(circle.at - line.at, line.along);
  const Vec2 foot = line.at + line.along * along;
  const double aside = distance(foot, circle.at);
  if (aside > circle.radius) return;
  const double half = std::sqrt(circle.radius * circle.radius - aside * aside);
  out.push_back(foot + line.along * half);
  out.push_back(foot - line.along * half);
}

void cross_circles(const OffsetEdge& a, const OffsetEdge& b, std::vector<Vec2>& out) {
  const double apart = distance(a.at, b.at);
  if (apart == 0 || apart > a.radius + b.radius || apart < std::abs(a.radius - b.radius)) return;
  const double along = (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2 * apart);
  const double half = std::sqrt(std::max(0.0, a.radius * a.radius - along * along));
  const Vec2 way = (b.at - a.at) / apart;
  out.push_back(a.at + way * along + left_of(way) * half);
  out.push_back(a.at + way * along - left_of(way) * half);
}

std::vector<Vec2> crossings_of(const OffsetEdge& a, const OffsetEdge& b) {
  std::vector<Vec2> out;
  if (a.is_arc && b.is_arc) {
    cross_circles(a, b, out);
  } else if (a.is_arc) {
    cross_line_circle(b, a, out);
  } else if (b.is_arc) {
    cross_line_circle(a, b, out);
  } else if (const double turn = cross(a.along, b.along); turn != 0) {
    out.push_back(a.at + a.along * (cross(b.at - a.at, b.along) / turn));
  }
  return out;
}

/// Where an arc about `center` touches the edge's line or circle.
Vec2 touching(const Edge& edge, Vec2 center) {
  if (edge.is_arc()) return edge.center + unit(center - edge.center) * edge.radius();
  const Vec2 along = edge.tangent_at(0);
  return edge.from + along * dot(center - edge.from, along);
}

/// The part of the edge before (or after) `point`; nothing where the point does not lie on it, an edge without length where it is the
/// edge's other end.
std::optional<Edge> cut_at(const Edge& edge, Vec2 point, bool before) {
  if (distance(edge, point) > kOnEdge) return std::nullopt;
  Edge piece = edge;
  (before ? piece.to : piece.from) = point;
  if (distance(piece.from, piece.to) < kOnEdge) piece.to = piece.from = point;
  return piece;
}

bool turns_left(const Edge& a, const Edge& b) {
  return cross(a.tangent_at(1), b.tangent_at(0)) > kCorner;
}

struct Corner {
  Edge before, arc, after;
};

std::optional<Corner> round_corner(const Edge& a, const Edge& b, double radius) {
  const auto left_of_a = offset_left(a, radius), left_of_b = offset_left(b, radius);
  if (!left_of_a || !left_of_b) return std::nullopt;
  std::optional<Corner> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vec2 center : crossings_of(*left_of_a, *left_of_b)) {
    const Vec2 from = touching(a, center), to = touching(b, center);
    const auto before = cut_at(a, from, true), after = cut_at(b, to, false);
    const double away = distance(center, a.to);
    if (!before || !after || away >= nearest) continue;
    nearest = away;
    best = Corner{*before, Edge::arc(from, to, center, Turn::kCounterClockwise), *after};
  }
  return best;
}

}  // namespace

Filleted filleted(const Path& path, bool closed, double radius) {
  Filleted out;
  Path edges = path;
  std::vector<std::optional<Edge>> arcs(edges.size());  // after each edge
  const std::size_t corners = closed ? edges.size() : edges.size() - std::min<std::size_t>(1, edges.size());
  for (std::size_t i = 0; i < corners; ++i) {
    Edge& a = edges[i];
    const std::size_t next = (i + 1) % edges.size();
    Edge& b = edges[next];
    if (!turns_left(path[i], path[next])) continue;
    // The fillets before may have taken an edge whole.
    const bool is_left = a.from != a.to && b.from != b.to;
    const auto corner = is_left ? round_corner(a, b, radius) : std::nullopt;
    if (!corner) {
      out.sharp.push_back(path[i].to);
      continue;
    }
    a = corner->before;
    b = corner->after;
    arcs[i] = corner->arc;
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].from != edges[i].to) out.path.push_back(edges[i]);
    if (arcs[i]) out.path.push_back(*arcs[i]);
  }
  return out;
}

Filleted filleted_on_the_right(const Path& path, double radius) {
  Filleted out = filleted(reversed(path), false, radius);
  out.path = reversed(out.path);
  return out;
}

}  // namespace clearcut::read::stepnc
