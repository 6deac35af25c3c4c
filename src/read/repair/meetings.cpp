#include "read/repair/meetings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "base/elementary.h"
#include "base/error.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "read/repair/edge_index.h"

namespace clearcut::read {
namespace {

/// mm. Neighbours separated by less than this beyond their joint count as tangent, not as meeting again.
constexpr double kTangentGap = 1e-7;
/// mm. Shared stretches shorter than this are points.
constexpr double kShortestOverlap = 1e-6;
/// Overlapping boxes per box before they are made smaller: ordinary drawings have about ten.
constexpr double kPairsPerBox = 30;
/// Number of pairs with negligible cost.
constexpr long long kAlwaysPairs = 1'000'000;
/// Boxes in all, and overlapping pairs of them, before the search gives up: some seconds and half a
/// gigabyte.
constexpr double kMostBoxes = 2e6;
constexpr long long kMostPairs = 50'000'000;

/// Departure of a path from a point: its direction and curvature, 1/mm, positive to the left.
struct Departure {
  Vec2 direction;
  double bend = 0;
};

double bend_of(const Edge& edge) {
  if (!edge.is_arc()) return 0;
  return (edge.turn == Turn::kCounterClockwise ? 1 : -1) / edge.radius();
}
/// Departure at share t of the edge, towards its end or back towards its start.
Departure ahead_along(const Edge& edge, double t) {
  return {edge.tangent_at(t), bend_of(edge)};
}
Departure back_along(const Edge& edge, double t) {
  return {-edge.tangent_at(t), -bend_of(edge)};
}

/// The two departures of a loop from one of its points.
struct Passage {
  Departure back, ahead;
};

class Search {
 public:
  /// `longest_box` of the index.
  Search(const std::vector<Loop>& loops, std::size_t most, double longest_box)
      : loops_(loops), index_(loops, longest_box), most_(most) {}

  /// Nothing when more than `budget` pairs of boxes overlap.
  std::optional<std::vector<Meeting>> run(long long budget) {
    for (std::size_t l = 0; l < loops_.size(); ++l) {
      for (std::size_t e = 0; e < loops_[l].size() && found_.size() < most_; ++e) {
        find_meetings_near({static_cast<int>(l), static_cast<int>(e)});
        if (pairs_ > budget) return std::nullopt;
      }
    }
    return std::move(found_);
  }

 private:
  void find_meetings_near(EdgeId id) {
    std::vector<EdgeId> later;
    for (const Box& box : index_.boxes(id)) {
      index_.visit(box.grown(kRoundingMm), [&](EdgeId other) {
        if (id < other) later.push_back(other);
        ++pairs_;
        return true;
      });
    }
    std::sort(later.begin(), later.end());
    later.erase(std::unique(later.begin(), later.end()), later.end());
    for (const EdgeId other : later) {
      if (are_neighbours(id, other)) {
        compare_neighbours(id, other);
      } else {
        compare(id, other);
      }
    }
  }

  int size_of(int loop) const { return static_cast<int>(loops_[static_cast<std::size_t>(loop)].size()); }
  EdgeId next(EdgeId id) const { return {id.loop, (id.edge + 1) % size_of(id.loop)}; }
  EdgeId previous(EdgeId id) const { return {id.loop, (id.edge + size_of(id.loop) - 1) % size_of(id.loop)}; }
  bool are_neighbours(EdgeId a, EdgeId b) const { return a.loop == b.loop && (next(a) == b || next(b) == a); }

  void compare(EdgeId a, EdgeId b) {
    const auto places = intersections(index_.edge(a), index_.edge(b));
    if (places.empty()) return;
    if (places.size() > 1 && stay_together(index_.edge(a), index_.edge(b), places[0], places[1])) {
      found_.push_back({a, b, places[0], MeetingKind::kOverlap});
      return;
    }
    for (const Vec2 place : places) found_.push_back({a, b, place, kind_at(a, b, place)});
  }

  static bool stay_together(const Edge& a, const Edge& b, Vec2 p, Vec2 q) {
    return distance(p, q) > kShortestOverlap &&
           distance(b, nearest(a, (p + q) / 2.0).point) <= 2 * kRoundingMm;
  }

  void compare_neighbours(EdgeId a, EdgeId b) {
    if (next(a) == b && turns_back(a, b))
      found_.push_back({a, b, index_.edge(b).from, MeetingKind::kOverlap});
    if (next(b) == a && turns_back(b, a))
      found_.push_back({a, b, index_.edge(a).from, MeetingKind::kOverlap});
    for (const Vec2 place : intersections(index_.edge(a), index_.edge(b))) {
      const bool joint = (next(a) == b && is_joint(a, b, place)) || (next(b) == a && is_joint(b, a, place));
      if (!joint) found_.push_back({a, b, place, kind_at(a, b, place)});
    }
  }

  /// `second` runs back along `first`.
  bool turns_back(EdgeId first, EdgeId second) const {
    const Edge& a = index_.edge(first);
    const Edge& b = index_.edge(second);
    if (dot(-a.tangent_at(1), b.tangent_at(0)) < 0.99) return false;
    const bool a_shorter = a.length() < b.length();
    return distance(a_shorter ? b : a, (a_shorter ? a : b).at(0.5)) <= kRoundingMm;
  }

  /// The place is the joint of the neighbours, or so near to the joint that they coincide in between.
  bool is_joint(EdgeId first, EdgeId second, Vec2 place) const {
    const Edge& a = index_.edge(first);
    const Edge& b = index_.edge(second);
    if (distance(place, b.from) <= kTangentGap) return true;
    return distance(b, nearest(a, (place + b.from) / 2.0).point) <= kTangentGap;
  }

  Passage passage(EdgeId id, Vec2 place) const {
    const Edge& edge = index_.edge(id);
    if (distance(place, edge.from) <= 2 * kRoundingMm) {
      return {back_along(index_.edge(previous(id)), 1), ahead_along(edge, 0)};
    }
    if (distance(place, edge.to) <= 2 * kRoundingMm)
      return {back_along(edge, 1), ahead_along(index_.edge(next(id)), 0)};
    const double t = nearest(edge, place).t;
    return {back_along(edge, t), ahead_along(edge, t)};
  }

  MeetingKind kind_at(EdgeId a, EdgeId b, Vec2 place) const {
    const Passage one = passage(a, place), other = passage(b, place);
    const auto back = is_left(one, other.back), ahead = is_left(one, other.ahead);
    return back && ahead && *back != *ahead ? MeetingKind::kCrossing : MeetingKind::kTouch;
  }

  /// Whether a path departs to the left of a passage; nothing if it runs along the passage. Of equal directions the
  /// one with more curvature to the left is to the left.
  static std::optional<bool> is_left(const Passage& way, const Departure& path) {
    constexpr double kSame = 1e-7;      // radians
    constexpr double kSameBend = 1e-6;  // 1/mm
    const auto turn = [](Vec2 from, Vec2 to) {
      const double angle = base::atan2(cross(from, to), dot(from, to));
      return angle < 0 ? angle + 2 * kPi : angle;
    };
    const double to_back = turn(way.ahead.direction, way.back.direction);
    const double to_path = turn(way.ahead.direction, path.direction);
    const bool along_ahead = to_path < kSame || to_path > 2 * kPi - kSame;
    const bool along_back = std::abs(to_path - to_back) < kSame;
    if (!along_ahead && !along_back) return to_path < to_back;
    const double bend = path.bend - (along_ahead ? way.ahead : way.back).bend;
    if (std::abs(bend) < kSameBend || (along_ahead && along_back)) return std::nullopt;
    return along_ahead ? bend > 0 : bend < 0;
  }

  const std::vector<Loop>& loops_;
  const EdgeIndex index_;
  const std::size_t most_;
  std::vector<Meeting> found_;
  long long pairs_ = 0;
};

}  // namespace

bool is_shallow(const std::vector<Loop>& loops, const Meeting& meeting, double depth) {
  const auto edge = [&](EdgeId id) -> const Edge& {
    return loops[static_cast<std::size_t>(id.loop)][static_cast<std::size_t>(id.edge)];
  };
  const Edge &a = edge(meeting.a), &b = edge(meeting.b);
  const auto stays_near = [&](const Edge& own, const Edge& other) {
    for (const Vec2 end : {own.from, own.to}) {
      const Vec2 middle = nearest(own, (end + meeting.at) / 2.0).point;
      if (distance(other, end) <= depth && distance(other, middle) <= depth) return true;
    }
    return false;
  };
  if (stays_near(a, b) || stays_near(b, a)) return true;
  // A shallow bow: the same two edges part again at their other crossing.
  for (const Vec2 place : intersections(a, b)) {
    const bool other = distance(place, meeting.at) > 2 * kRoundingMm;
    if (other && distance(b, nearest(a, (place + meeting.at) / 2.0).point) <= depth) return true;
  }
  return false;
}

std::vector<Meeting> meetings(const std::vector<Loop>& loops, std::size_t most, const std::string& where) {
  double edges = 0, total = 0;
  for (const Loop& loop : loops) {
    edges += static_cast<double>(loop.size());
    total += length(loop);
  }
  // Long inclined lines have large boxes with needless overlaps: smaller boxes are used until there are few pairs.
  double longest_box = std::numeric_limits<double>::infinity();
  for (double boxes = 1; boxes * edges <= kMostBoxes || boxes == 1; boxes *= 8) {
    const bool last = 8 * boxes * edges > kMostBoxes;
    const auto few = static_cast<long long>(kPairsPerBox * boxes * edges);
    const long long budget = last ? kMostPairs : std::max(few, kAlwaysPairs);
    if (auto found = Search(loops, most, longest_box).run(budget)) return *found;
    longest_box = total / (8 * boxes * edges);
  }
  throw InputError(where, "too many long lines lie across each other; simplify the drawing");
}

namespace {

/// mm. Places nearer to a vertex than this are the vertex.
constexpr double kAtVertex = 4e-9;

using Key = std::pair<double, double>;

/// `edge` divided at the places within it.
void append_divided(const Edge& edge, std::vector<Vec2> places, Loop& out) {
  std::vector<std::pair<double, Vec2>> cuts;
  for (const Vec2 place : places) {
    if (distance(place, edge.from) > kAtVertex && distance(place, edge.to) > kAtVertex) {
      cuts.emplace_back(nearest(edge, place).t, place);
    }
  }
  std::sort(cuts.begin(), cuts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  Edge rest = edge;
  for (const auto& [t, place] : cuts) {
    if (place == rest.from) continue;
    out.push_back({rest.from, place, edge.center, edge.turn});
    rest.from = place;
  }
  if (rest.from != rest.to) out.push_back(rest);
}

/// All vertices at one place get its exact coordinates.
void snap(Loop& loop, const std::vector<Meeting>& touches) {
  for (const Meeting& touch : touches) {
    for (const EdgeId id : {touch.a, touch.b}) {
      const auto i = static_cast<std::size_t>(id.edge);
      Edge& edge = loop[i];
      if (distance(edge.from, touch.at) <= kAtVertex) {
        edge.from = touch.at;
        loop[(i + loop.size() - 1) % loop.size()].to = touch.at;
      }
      if (distance(edge.to, touch.at) <= kAtVertex) {
        edge.to = touch.at;
        loop[(i + 1) % loop.size()].from = touch.at;
      }
    }
  }
}

}  // namespace

std::vector<Loop> split_at(const Loop& loop, const std::vector<Meeting>& touches) {
  Loop snapped = loop;
  snap(snapped, touches);
  std::map<int, std::vector<Vec2>> places_on;
  for (const Meeting& touch : touches) {
    places_on[touch.a.edge].push_back(touch.at);
    places_on[touch.b.edge].push_back(touch.at);
  }
  Loop divided;
  for (std::size_t i = 0; i < snapped.size(); ++i) {
    const auto found = places_on.find(static_cast<int>(i));
    append_divided(snapped[i], found == places_on.end() ? std::vector<Vec2>{} : found->second, divided);
  }
  // Walk along; whenever a place is met again, the part in between is a loop.
  std::vector<Loop> loops;
  Loop open;
  std::map<Key, std::size_t> starts;
  for (const Edge& edge : divided) {
    starts[{edge.from.x, edge.from.y}] = open.size();
    open.push_back(edge);
    const auto again = starts.find({edge.to.x, edge.to.y});
    if (again == starts.end() || again->second >= open.size() || open[again->second].from != edge.to) {
      continue;
    }
    const auto first = open.begin() + static_cast<std::ptrdiff_t>(again->second);
    if (open.end() - first >= 2) loops.emplace_back(first, open.end());
    open.erase(first, open.end());
  }
  return loops;
}

Vec2 inner_point(const Loop& loop) {
  const auto longest = std::max_element(loop.begin(), loop.end(),
                                        [](const Edge& a, const Edge& b) { return a.length() < b.length(); });
  const double side = signed_area(loop) > 0 ? 1 : -1;
  const Vec2 middle = longest->at(0.5);
  const Vec2 inward = left_of(longest->tangent_at(0.5)) * (side * longest->length());
  for (double step = 0.25; step > 1e-9; step /= 8) {
    const Vec2 p = middle + inward * step;
    if (contains(loop, p)) return p;
  }
  return middle;
}

std::vector<std::vector<int>> loops_about(const std::vector<Loop>& loops) {
  std::vector<double> areas;
  for (const Loop& loop : loops) areas.push_back(std::abs(signed_area(loop)));
  const auto area_of = [&](int i) { return areas[static_cast<std::size_t>(i)]; };
  const EdgeIndex index(loops);
  std::vector<std::vector<int>> about(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    // A loop within this one may also contain the point; it is smaller.
    for (const int other : index.loops_around(inner_point(loops[i]))) {
      if (area_of(other) > areas[i]) about[i].push_back(other);
    }
    std::stable_sort(about[i].begin(), about[i].end(), [&](int a, int b) { return area_of(a) > area_of(b); });
  }
  return about;
}

Regions nested(const std::vector<Loop>& loops) {
  const auto about = loops_about(loops);
  std::vector<std::vector<Loop>> islands(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (about[i].size() % 2 == 1) islands[static_cast<std::size_t>(about[i].back())].push_back(loops[i]);
  }
  Regions regions;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (about[i].size() % 2 == 0)
      regions.push_back(Region::from_valid_loops(loops[i], std::move(islands[i])));
  }
  return regions;
}

}  // namespace clearcut::read
