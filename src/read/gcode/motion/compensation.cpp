#include "read/gcode/motion/compensation.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "read/gcode/motion/arc.h"

namespace clearcut::read::gcode {

namespace {

bool is_in_plan(const Move& move) {
  return move.path.is_arc() || distance(move.path.from, move.path.to) > kRoundingMm;
}

double swept_between(const Edge& arc, Vec2 from, Vec2 to) {
  const double side = arc.turn == Turn::kCounterClockwise ? 1 : -1;
  const double angle =
      side * base::atan2(cross(from - arc.center, to - arc.center), dot(from - arc.center, to - arc.center));
  return angle < 0 ? angle + 2 * kPi : angle;
}

}  // namespace

Compensation::Compensation(const CompensationRules& rules, CompensationSide side, double radius, Vec2 place,
                           std::string file_name)
    : rules_(rules), side_(side), radius_(radius), place_(place), file_name_(std::move(file_name)) {}

void Compensation::refuse(int line, const std::string& what) const {
  throw InputError(file_name_ + ":" + std::to_string(line), what);
}

/// The centre of a tool that touches the contour at `place`, where it runs in `direction`.
Vec2 Compensation::beside(Vec2 place, Vec2 direction) const {
  return place + left_of(direction) * (static_cast<double>(side_) * radius_);
}

/// The tool is on the side of the arc's centre.
bool Compensation::is_inside(const Edge& arc) const {
  return (arc.turn == Turn::kCounterClockwise) == (side_ == CompensationSide::kLeft);
}

double Compensation::radius_beside(const Edge& arc) const {
  return distance(arc.center, arc.to) + (is_inside(arc) ? -radius_ : radius_);
}

std::vector<OffsetMove> Compensation::add(const Move& said) {
  given_.clear();
  if (!is_in_plan(said)) {
    stand(said);
  } else if (!began_) {
    begin(said);
  } else {
    go_on(said);
  }
  ++count_;
  z_ = said.z_to;
  return std::move(given_);
}

std::vector<OffsetMove> Compensation::end() {
  given_.clear();
  if (!waiting_.empty()) settle(beside(before_.to, heading_), true);
  return std::move(given_);
}

/// Up or down beside the corner that is not known yet.
void Compensation::stand(const Move& said) {
  if (!began_ && rules_.begins_in_plan)
    refuse(said.line,
           "the first move of cutter compensation is not longer in X and Y than the tool's radius, at which "
           "the control stops; enter along a longer line");
  OffsetMove offset{said, count_};
  offset.move.path = Edge::line(place_, place_);
  if (waiting_.empty()) return give(offset);
  waiting_.push_back({offset, {}, 0, place_});
}

void Compensation::begin(const Move& said) {
  if (said.path.is_arc())
    refuse(said.line, "cutter compensation begins with an arc; enter along a straight line");
  const Vec2 way = said.path.to - said.path.from;
  if (rules_.begins_in_plan && norm(way) <= radius_)
    refuse(said.line, "the first move of cutter compensation is " + trimmed(norm(way), 4) +
                          " mm long and not longer than the tool's radius, " + trimmed(radius_, 4) +
                          " mm, at which the control stops; enter along a longer line");
  began_ = true;
  entry_open_ = rules_.entry == EntryRule::kAcrossNext;
  wait_for(said);
  // What the interpreter looks at is not the way of the move but the direction across it.
  waiting_.back().direction = entry_open_ ? Vec2{} : beside(said.path.to, heading_) - said.path.to;
  waiting_.back().begins = said.path.from;
}

void Compensation::wait_for(const Move& said) {
  before_ = said.path;
  heading_ = said.path.tangent_at(1);
  const Vec2 to = beside(said.path.to, heading_);
  OffsetMove offset{said, count_};
  offset.move.path.from = place_;
  offset.move.path.to = to;
  Waiting waiting{offset, said.path.to - said.path.from, 0, place_};
  if (said.path.is_arc()) waiting.sweep = std::abs(said.path.sweep());
  waiting_.push_back(waiting);
}

void Compensation::go_on(const Move& said) {
  if (said.path.is_arc() && radius_beside(said.path) <= 0)
    refuse(said.line, "the arc's radius, " + trimmed(distance(said.path.center, said.path.to), 4) +
                          " mm, is not larger than that of the tool that compensation keeps inside it, " +
                          trimmed(radius_, 4) + " mm; the control stops");
  const Vec2 next = said.path.tangent_at(0);
  if (entry_open_) {
    entry_open_ = false;
    settle(beside(said.path.from, next), false);
    return wait_for(said);
  }
  // > 0: the contour turns away from the tool. From -90 to 270 degrees.
  double outside = -static_cast<double>(side_) * base::atan2(cross(heading_, next), dot(heading_, next));
  if (outside < -kPi / 2) outside += 2 * kPi;
  const bool cusp_of_next =
      said.path.is_arc() && std::abs(outside - kPi) < rules_.tangent && !is_inside(said.path);
  const bool cusp_of_last =
      !said.path.is_arc() && outside > kPi - rules_.tangent && before_.is_arc() && !is_inside(before_);
  if (outside < -rules_.tangent || outside > kPi + rules_.tangent || cusp_of_next || cusp_of_last) {
    join_inside(said);
  } else if (outside > rules_.tangent) {
    join_outside(said, outside);
  } else {
    settle(beside(before_.to, heading_), rules_.looks_at_all);
  }
  wait_for(said);
}

void Compensation::join_inside(const Move& said) {
  if (static_cast<int>(waiting_.size()) - 1 > rules_.most_still)
    refuse(said.line, "more than " + std::to_string(rules_.most_still) +
                          " moves without X and Y stand in an inside corner of a compensated contour; the "
                          "control does not look beyond them and cuts into the corner");
  settle(meeting(said), true);
}

void Compensation::join_outside(const Move& said, double outside) {
  if (outside_line_ == 0) outside_line_ = said.line;
  const Vec2 next_begins = beside(said.path.from, said.path.tangent_at(0));
  if (rules_.outside == OutsideCorner::kArc)
    join_by_arc(said, next_begins);
  else
    join_by_lines(said, next_begins, outside);
}

void Compensation::join_by_arc(const Move& said, Vec2 next_begins) {
  settle(beside(before_.to, heading_), rules_.looks_at_all || !said.path.is_arc());
  if (is_rapid(said.kind)) return put_in_line(said, next_begins);
  OffsetMove arc{said, count_};
  arc.move.kind = MoveKind::kCut;
  arc.move.z_from = arc.move.z_to = z_;
  arc.move.path = Edge::arc(place_, next_begins, said.path.from,
                            side_ == CompensationSide::kLeft ? Turn::kClockwise : Turn::kCounterClockwise);
  give(arc);
}

void Compensation::join_by_lines(const Move& said, Vec2 next_begins, double outside) {
  const Vec2 corner = said.path.from, last_ends = beside(before_.to, heading_);
  const Vec2 next = said.path.tangent_at(0);
  std::vector<Vec2> places;
  if (outside < kPi / 2) {
    const double along = radius_ * base::tan(outside / 2);
    places = {last_ends + heading_ * along};
  } else {
    places = {last_ends + heading_ * radius_, beside(corner, next) - next * radius_};
  }
  if (before_.is_arc()) {
    settle(last_ends, true);
    put_in_line(said, places.front());
  } else {
    settle(places.front(), true);
  }
  if (places.size() > 1) put_in_line(said, places.back());
  if (said.path.is_arc()) put_in_line(said, next_begins);
}

void Compensation::put_in_line(const Move& said, Vec2 to) {
  OffsetMove offset{said, count_};
  if (!is_rapid(said.kind)) offset.move.kind = MoveKind::kCut;
  offset.move.z_from = offset.move.z_to = z_;
  offset.move.path = Edge::line(place_, to);
  give(offset);
}

/// Those that wait end at `end`. Throws where the first would have to run backwards.
void Compensation::settle(Vec2 end, bool looks) {
  if (looks && !waiting_.empty()) check(waiting_.front(), end);
  const std::vector<Waiting> waiting = std::move(waiting_);
  waiting_.clear();
  for (const Waiting& one : waiting) {
    OffsetMove offset = one.offset;
    offset.move.path.from = place_;
    offset.move.path.to = end;
    give(offset);
  }
}

void Compensation::check(const Waiting& waiting, Vec2 end) const {
  const Edge& path = waiting.offset.move.path;
  const std::string why =
      " cannot be followed by the compensated tool without cutting into the next one; the control stops";
  if (!path.is_arc()) {
    if (dot(waiting.direction, end - waiting.begins) < 0)
      refuse(waiting.offset.move.line, "the line up to an inside corner" + why);
  } else if (swept_between(path, waiting.begins, end) > waiting.sweep + rules_.more_sweep) {
    refuse(waiting.offset.move.line, "the arc up to an inside corner" + why);
  }
}

void Compensation::give(const OffsetMove& offset) {
  const Edge& path = offset.move.path;
  const bool moves = distance(path.from, path.to) > kRoundingMm;
  if (!moves && offset.move.z_from == offset.move.z_to) return;
  if (path.is_arc() && moves) {
    give_arc(offset);
  } else {
    given_.push_back(offset);
    if (!moves || path.is_arc()) given_.back().move.path = Edge::line(place_, path.to);
  }
  place_ = path.to;
}

/// In pieces where its radii at both ends differ, as behind a tangent corner that is none quite.
void Compensation::give_arc(const OffsetMove& offset) {
  const Move& move = offset.move;
  const double sweep = swept_between(move.path, move.path.from, move.path.to);
  const std::vector<Edge> edges =
      arc_edges({move.path.from, move.path.to, move.path.center, move.path.turn, sweep});
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const auto share = [&](std::size_t n) {
      return std::lerp(move.z_from, move.z_to, static_cast<double>(n) / static_cast<double>(edges.size()));
    };
    OffsetMove piece = offset;
    piece.move.path = edges[k];
    piece.move.z_from = share(k);
    piece.move.z_to = share(k + 1);
    given_.push_back(piece);
  }
}

/// Where the paths beside the last move and beside this one meet in an inside corner.
Vec2 Compensation::meeting(const Move& said) const {
  const Vec2 last_ends = beside(before_.to, heading_), next = said.path.tangent_at(0);
  if (before_.is_arc() && said.path.is_arc()) return arc_meets_arc(before_, said.path, said.line);
  if (before_.is_arc())
    return line_meets_arc(beside(said.path.from, next), next, before_, !is_inside(before_), said.line);
  if (said.path.is_arc())
    return line_meets_arc(last_ends, heading_, said.path, is_inside(said.path), said.line);
  const double turn = std::abs(base::atan2(cross(heading_, next), dot(heading_, next)));
  if (kPi - turn < 1e-9)
    refuse(said.line, "a compensated contour runs back on itself; no tool fits into the corner");
  return last_ends - heading_ * (radius_ * base::tan(turn / 2));
}

/// `later`: of the two places the one farther along the line.
Vec2 Compensation::line_meets_arc(Vec2 on_line, Vec2 along, const Edge& arc, bool later, int line) const {
  const double radius = radius_beside(arc);
  const Vec2 arm = on_line - arc.center;
  const double across = cross(along, arm);
  if (std::abs(across) > radius)
    refuse(line,
           "the compensated tool does not fit into the corner of a line and an arc without cutting into one "
           "of them; the control stops");
  const double half = std::sqrt((radius - across) * (radius + across));
  return on_line + along * (-dot(along, arm) + (later ? half : -half));
}

Vec2 Compensation::arc_meets_arc(const Edge& before, const Edge& after, int line) const {
  const double first = radius_beside(before), second = radius_beside(after);
  const Vec2 between = after.center - before.center;
  const double apart = norm(between);
  const double share =
      apart > 0 && first > 0 ? (first * first + apart * apart - second * second) / (2 * first * apart) : 2;
  if (std::abs(share) > 1)
    refuse(line,
           "the compensated tool does not fit into the corner of two arcs without cutting into one of them; "
           "the control stops");
  const bool left = is_inside(before) == (after.turn == Turn::kCounterClockwise);
  const Vec2 along = between / apart;
  const double across = std::sqrt(std::max(0.0, (1 - share) * (1 + share)));
  return before.center + (along * share + left_of(along) * (left ? across : -across)) * first;
}

}  // namespace clearcut::read::gcode
