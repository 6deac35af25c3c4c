#include "read/stepnc/toolpaths.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

#include "base/elementary.h"
#include "base/text.h"
#include "base/tolerances.h"

namespace clearcut::read::stepnc {
namespace {

constexpr int kDeepestCurve = 16;       // nesting of composite curves
constexpr double kOffItsCircle = 0.02;  // mm; ends of arcs farther off their circle are an error
constexpr double kOffItsHelix = 0.002;  // mm; points farther off are no helix

/// Arguments of a toolpath.
enum Argument : std::size_t {
  kPriority = 0,
  kType = 1,
  kSpeed = 2,
  kTechnology = 3,
  kFunctions = 4,
  kDirection = 5,  ///< of trajectories; the dwell of a FEEDSTOP
  kCurve = 6,
  kContactType = 8  ///< the surface normal of a CUTTER_LOCATION_TRAJECTORY
};

struct TrajectoryType {
  std::string_view name;
  bool is_link = false;  ///< level moves go through what is cut
};
constexpr TrajectoryType kTrajectoryTypes[] = {{"APPROACH"},          {"LIFT"},      {"CONNECT", true},
                                               {"NON_CONTACT", true}, {"CONTACT"},   {"TRAJECTORY_PATH"},
                                               {"NONCONTACT", true},  {"TRAJECTORY"}};

const TrajectoryType& type_of(const Node& element) {
  if (element.unset(kType)) return kTrajectoryTypes[0];
  const std::string name = element.enumeration(kType);
  for (const TrajectoryType& type : kTrajectoryTypes)
    if (name == type.name) return type;
  element.fail("its type is ." + name +
               ".; write APPROACH, LIFT, CONNECT, NON_CONTACT, CONTACT or TRAJECTORY_PATH");
}

StatedMove reversed_move(StatedMove move) {
  move.path = move.path.from == move.path.to ? move.path : move.path.reversed();
  std::swap(move.z_from, move.z_to);
  return move;
}

using Moves = std::vector<StatedMove>;

void reverse_moves(Moves& moves) {
  std::reverse(moves.begin(), moves.end());
  for (StatedMove& move : moves) move = reversed_move(move);
}

/// Curves in space as moves.
class CurveReader {
 public:
  CurveReader(const Frame& placement, Context& context) : placement_(placement), context_(context) {}

  Moves moves_of(const Node& curve, int depth = 0) const {
    if (depth > kDeepestCurve)
      curve.fail("composite curves are nested more than 16 deep (or in a circle); flatten them");
    context_.spend(1, curve);
    if (curve.is("POLYLINE")) return polyline(curve);
    if (curve.is("COMPOSITE_CURVE")) return composite(curve, depth);
    if (curve.is("CIRCLE")) return whole_circle(curve);
    if (curve.is("TRIMMED_CURVE")) return trimmed_curve(curve);
    curve.fail("toolpaths are read from polylines, lines, arcs and composites of them; write it with these");
  }

 private:
  Vec3 place(const Node& point) const { return placement_.point(location_of(point)); }

  static StatedMove straight(Vec3 from, Vec3 to) {
    StatedMove move;
    const bool is_upright = distance(in_plan(from), in_plan(to)) <= kRoundingMm;
    move.path = Edge::line(in_plan(from), is_upright ? in_plan(from) : in_plan(to));
    move.z_from = from.z;
    move.z_to = to.z;
    return move;
  }

  Moves polyline(const Node& curve) const {
    std::vector<Vec3> points;
    for (const Node& point : curve.refs(1)) points.push_back(place(point));
    context_.spend(points.size(), curve);
    if (points.size() < 2) curve.fail("a polyline of a toolpath needs two points or more; give them");
    if (const auto helix = helix_of(curve, points)) return {*helix};
    Moves moves;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const StatedMove move = straight(points[i - 1], points[i]);
      if (move.path.from != move.path.to || move.z_from != move.z_to) moves.push_back(move);
    }
    return moves;
  }

  /// Part 42 has no helix. A polyline along one says which by its name; its points have to agree.
  std::optional<StatedMove> helix_of(const Node& curve, const std::vector<Vec3>& points) const {
    if (curve.peek(0).kind != P21Kind::kString) return std::nullopt;
    std::istringstream words(curve.text(0));
    words.imbue(std::locale::classic());
    std::string kind, sense;
    Vec3 center;
    if (!(words >> kind >> sense >> center.x >> center.y) || kind != "HELIX") return std::nullopt;
    StatedMove move;
    const Turn turn = sense == "CCW" ? Turn::kCounterClockwise : Turn::kClockwise;
    move.path =
        Edge::arc(in_plan(points.front()), in_plan(points.back()), in_plan(placement_.point(center)), turn);
    move.z_from = points.front().z;
    move.z_to = points.back().z;
    const double sweep = std::abs(move.path.sweep());
    for (const Vec3& point : points) {
      const Nearest near = nearest(move.path, in_plan(point));
      const double z = move.z_from + near.t * (move.z_to - move.z_from);
      if (near.distance > kOffItsHelix || std::abs(z - point.z) > kOffItsHelix || sweep == 0)
        return std::nullopt;
    }
    return move;
  }

  Moves composite(const Node& curve, int depth) const {
    Moves moves;
    for (const Node& segment : curve.refs(1)) {
      const bool is_segment = segment.is("COMPOSITE_CURVE_SEGMENT");
      const Node parent = is_segment ? segment.needed_ref(2, "curve") : segment;
      if (is_segment) segment.use(0);
      Moves next = moves_of(parent, depth + 1);
      if (is_segment && segment.flag(1) == false) reverse_moves(next);
      moves.insert(moves.end(), next.begin(), next.end());
    }
    return moves;
  }

  struct LevelCircle {
    Frame frame;
    double radius = 0;
    bool is_turned_over = false;

    Vec3 at(double angle) const {
      const Vec2 p = radius * geometry::direction_of(angle);
      return frame.point({p.x, p.y, 0});
    }
  };

  LevelCircle circle_of(const Node& node) const {
    const Frame frame = composed(placement_, frame_of(node.ref(1)));
    if (!is_planar(frame)) node.fail("the circle is tilted; arcs of toolpaths are level");
    const double radius = node.needed_length(2, "radius");
    if (radius <= 0) node.fail("the radius is not above zero; correct it");
    return {frame, radius, !is_upright(frame)};
  }

  static StatedMove arc(const LevelCircle& circle, Vec3 from, Vec3 to, bool is_along) {
    StatedMove move;
    const Turn turn = is_along != circle.is_turned_over ? Turn::kCounterClockwise : Turn::kClockwise;
    move.path = Edge::arc(in_plan(from), in_plan(to), in_plan(circle.frame.origin), turn);
    move.z_from = from.z;
    move.z_to = to.z;
    return move;
  }

  Moves whole_circle(const Node& node) const {
    const LevelCircle circle = circle_of(node);
    const Vec3 a = circle.at(0), b = circle.at(kPi);
    return {arc(circle, a, b, true), arc(circle, b, a, true)};
  }

  /// A trim: its point where there is one, else by the parameter of the curve.
  template <typename ByParameter>
  Vec3 trim(const Node& curve, std::size_t argument, const ByParameter& by_parameter) const {
    const bool prefers_parameter = curve.enumeration(5) == "PARAMETER";
    std::optional<Vec3> point;
    std::optional<double> parameter;
    for (const P21Value& value : curve.list(argument)) {
      if (value.kind == P21Kind::kReference) {
        const P21Entity* entity = curve.file().find(value.id);
        if (entity == nullptr)
          curve.fail("refers to #" + std::to_string(value.id) + ", which is not in the file; add it");
        point = place(Node(curve.file(), *entity));
      } else if (value.kind == P21Kind::kTyped) {
        const auto inner = curve.file().children(value);
        if (inner.size() == 1) parameter = inner[0].number;
      } else if (value.kind == P21Kind::kReal || value.kind == P21Kind::kInteger) {
        parameter = value.number;
      }
    }
    if (point && !(prefers_parameter && parameter)) return *point;
    if (parameter) return by_parameter(*parameter);
    curve.fail("a trim has neither point nor parameter; give its end points");
  }

  Moves trimmed_curve(const Node& curve) const {
    const Node base = curve.needed_ref(1, "basis curve");
    if (base.is("LINE")) return line(curve, base);
    if (!base.is("CIRCLE"))
      base.fail("only lines and circles can be trimmed in toolpaths; write it with these");
    const LevelCircle circle = circle_of(base);
    const auto by_angle = [&](double angle) { return circle.at(context_.angle(angle)); };
    const Vec3 a = trim(curve, 2, by_angle), b = trim(curve, 3, by_angle);
    for (const Vec3& end : {a, b}) {
      const double off = std::abs(distance(in_plan(end), in_plan(circle.frame.origin)) - circle.radius);
      if (off > kOffItsCircle)
        curve.fail("an end is " + trimmed(off, 4) + " mm off its circle; correct point or circle");
    }
    const bool is_along = curve.flag(4).value_or(true);
    if (distance(in_plan(a), in_plan(b)) > kRoundingMm || std::abs(a.z - b.z) > kSamePlaceMm)
      return {arc(circle, a, b, is_along)};
    const Vec2 center = in_plan(circle.frame.origin);
    const Vec2 across = center * 2.0 - in_plan(a);
    const Vec3 opposite{across.x, across.y, a.z};
    return {arc(circle, a, opposite, is_along), arc(circle, opposite, a, is_along)};
  }

  Moves line(const Node& curve, const Node& base) const {
    const auto along = [&](double parameter) {
      const Node vector = base.needed_ref(2, "direction");
      const Vec3 direction = axis_of(vector.needed_ref(1, "direction"));
      const double size = base::hypot(base::hypot(direction.x, direction.y), direction.z);
      if (size == 0) base.fail("the line has no direction; correct it");
      const double t = parameter * vector.length(2).value_or(1.0) / size;
      const Vec3 from = location_of(base.needed_ref(1, "point"));
      return placement_.point({from.x + t * direction.x, from.y + t * direction.y, from.z + t * direction.z});
    };
    return {straight(trim(curve, 2, along), trim(curve, 3, along))};
  }

  const Frame& placement_;
  Context& context_;
};

/// What moves of one trajectory are driven with.
struct Drive {
  bool is_rapid = false;
  std::optional<MmPerMin> feed;
};

class ToolpathReader {
 public:
  ToolpathReader(const Node& operation, const ToolpathSetting& setting, Context& context)
      : operation_(operation), setting_(setting), curves_(setting.placement, context), context_(context) {}

  StatedPath read(const Node& list) {
    for (const Node& element : list.refs(0)) {
      if (element.is("FEEDSTOP")) {
        add_dwell(element);
      } else if (element.is_any("CUTTER_LOCATION_TRAJECTORY", "CUTTER_CONTACT_TRAJECTORY")) {
        add_trajectory(element);
      } else if (element.is("CONNECT_DIRECT")) {
        use_head(element);
        straight_on_ = drive_of(element);
      } else {
        element.fail("toolpaths of this kind are not followed; write CUTTER_LOCATION_TRAJECTORY");
      }
    }
    if (path_.moves.empty()) list.fail("it holds no move; write one, or leave its_toolpath out");
    return std::move(path_);
  }

 private:
  /// A path that is a mere proposal is followed, too.
  void use_head(const Node& element) {
    if (element.flag(kPriority) == false)
      context_.note("its_priority is .F., so that another path would do; this one is followed", element);
    element.use(kPriority);
    element.use(kType);
  }

  void add_dwell(const Node& element) {
    use_head(element);
    const double seconds = element.needed_number(kDirection, "dwell");
    if (!(seconds >= 0)) element.fail("its dwell is below zero; correct it");
    if (path_.moves.empty())
      element.fail("it comes before the first move, where there is nothing to wait for");
    path_.moves.back().dwell_s += seconds;
  }

  void add_trajectory(const Node& element) {
    use_head(element);
    const TrajectoryType& type = type_of(element);
    if (element.is("CUTTER_CONTACT_TRAJECTORY")) check_contact(element);
    const Drive drive = drive_of(element);
    Moves moves = curves_.moves_of(curve_of(element));
    if (element.flag(kDirection) == false) reverse_moves(moves);
    if (moves.empty()) return;
    if (straight_on_ && !path_.moves.empty()) go_straight_to(moves.front());
    straight_on_.reset();
    for (StatedMove& move : moves) add(move, drive, type.is_link);
  }

  static Node curve_of(const Node& element) {
    const Node curve = element.needed_ref(kCurve, "basic curve");
    return curve.is("CURVE_WITH_NORMAL") ? curve.needed_ref(0, "curve") : curve;
  }

  /// The middle of a flat end may be where its floor is touched; where a side or a round touches, it lies elsewhere.
  void check_contact(const Node& element) const {
    const std::string contact = element.enumeration(kContactType);
    if (contact == "SIDE")
      element.fail(
          "the way of contact at the cutter's side does not say on which side the wall is; write "
          "CUTTER_LOCATION_TRAJECTORY");
    if (setting_.tool.corner_radius > 0 || setting_.tool.tip_angle)
      element.fail(
          "the way of contact is that of the cutter only where its end is flat; write "
          "CUTTER_LOCATION_TRAJECTORY");
  }

  void go_straight_to(const StatedMove& next) {
    StatedMove move;
    const StatedMove& last = path_.moves.back();
    move.path = Edge::line(last.path.to, next.path.from);
    move.z_from = last.z_to;
    move.z_to = next.z_from;
    if (move.path.from != move.path.to || move.z_from != move.z_to) add(move, *straight_on_, true);
  }

  void add(StatedMove move, const Drive& drive, bool is_link) {
    const bool is_upright = move.path.from == move.path.to;
    if (drive.is_rapid)
      move.kind = MoveKind::kRapid;
    else if (is_upright)
      move.kind = move.z_to < move.z_from ? MoveKind::kPlunge : MoveKind::kRetract;
    else if (move.z_to < move.z_from)
      move.kind = MoveKind::kRamp;
    else
      move.kind = is_link ? MoveKind::kLink : MoveKind::kCut;
    move.feed = drive.feed;
    path_.moves.push_back(move);
  }

  Drive drive_of(const Node& element) {
    Drive drive;
    if (const auto technology = element.ref(kTechnology)) {
      drive.feed = feed_of_technology(*technology, context_);
      const auto whole = operation_.ref(6);
      if (whole && technology->peek(3).number == whole->peek(3).number) technology->use(3);
      if (technology->peek(1).text == "TCP") technology->use(1);
    }
    if (same_functions(element)) element.use(kFunctions);
    use_speed(element, drive);
    return drive;
  }

  bool same_functions(const Node& element) const {
    const P21Value own = element.peek(kFunctions), of_operation = operation_.peek(7);
    return own.kind == P21Kind::kReference && of_operation.kind == P21Kind::kReference &&
           own.id == of_operation.id;
  }

  /// RAPID, a ratio of the feed, or a speed along the curve.
  void use_speed(const Node& element, Drive& drive) {
    P21Value speed = element.peek(kSpeed);
    if (speed.kind == P21Kind::kUnset) return;
    element.use(kSpeed);
    if (speed.kind == P21Kind::kTyped) {
      const auto inner = element.file().children(speed);
      if (inner.size() != 1) element.fail("its speed is no value; write SPEED_NAME(.RAPID.) or a ratio");
      speed = inner[0];
    }
    if (speed.kind == P21Kind::kEnum) {
      if (speed.text != "RAPID")
        element.fail("its speed is ." + std::string(speed.text) + ".; write RAPID or a ratio");
      drive.is_rapid = true;
      drive.feed = MmPerMin::of(0);
    } else if (speed.kind == P21Kind::kReal || speed.kind == P21Kind::kInteger) {
      scale(element, drive, speed.number);
    } else {
      follow_profile(element, drive);
    }
  }

  MmPerMin feed_of_operation(const Node& element) {
    const auto technology = operation_.ref(6);
    const auto feed = technology ? feed_of_technology(*technology, context_) : std::nullopt;
    if (!feed) element.fail("its speed is a share of a feed that nobody states; give the operation a feed");
    return *feed;
  }

  void scale(const Node& element, Drive& drive, double ratio) {
    if (!(ratio > 0)) element.fail("its speed is a ratio of zero or less; correct it");
    const MmPerMin whole = drive.feed ? *drive.feed : feed_of_operation(element);
    drive.feed = MmPerMin::of(whole.mm_per_min() * ratio);
  }

  /// The speed is that of the poles: where they differ the least of them, because a feed is constant along a move.
  void follow_profile(const Node& element, Drive& drive) {
    const Node profile = element.needed_ref(kSpeed, "speed profile");
    if (!profile.is("TOOLPATH_SPEED")) profile.fail("a TOOLPATH_SPEED is needed here; correct the reference");
    const Node curve = profile.needed_ref(0, "curve of the speed");
    double least = 0, most = 0;
    for (const Node& pole : curve.refs(2)) {
      const std::vector<double> values = pole.numbers(1);
      if (values.empty() || !(values.back() > 0)) pole.fail("a speed of zero or less; correct it");
      least = least == 0 ? values.back() : std::min(least, values.back());
      most = std::max(most, values.back());
    }
    if (least == 0) curve.fail("the profile of the speed has no poles; correct it");
    for (std::size_t i = 0; i < curve.arguments(); ++i) curve.use(i);
    drive.feed = MmPerMin::of(least * 60000);
    if (most > least)
      context_.warn("the speed varies along the curve; its least value is the feed all along", profile);
  }

  const Node& operation_;
  const ToolpathSetting& setting_;
  CurveReader curves_;
  Context& context_;
  StatedPath path_;
  std::optional<Drive> straight_on_;
};

}  // namespace

std::optional<StatedPath> read_toolpath(const Node& operation, const ToolpathSetting& setting,
                                        Context& context) {
  const auto list = operation.ref(0);
  if (!list) return std::nullopt;
  if (!list->is("TOOLPATH_LIST")) list->fail("a TOOLPATH_LIST is needed here; correct the reference");
  return ToolpathReader(operation, setting, context).read(*list);
}

}  // namespace clearcut::read::stepnc
