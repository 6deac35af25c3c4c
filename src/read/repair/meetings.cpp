#include "read/repair/meetings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/units.h"

namespace clearcut {
namespace {

/// mm. As in geometry: edges nearer than this meet.
constexpr double kTouch = 1e-9;
/// mm. Neighbours that part by less than this beyond their joint are taken for tangent, not for meeting
/// again.
constexpr double kTangentGap = 1e-7;
/// mm. Shared stretches shorter than this are points.
constexpr double kShortestOverlap = 1e-6;
/// Pairs of edges looked at before the search gives up: about ten seconds.
constexpr long long kMostPairs = 100'000'000;

/// The two directions in which a loop leaves a point of it.
struct Passage {
  Vec2 back, ahead;
};

class Search {
 public:
  Search(const std::vector<Loop>& loops, std::size_t most, const std::string& where)
      : loops_(loops), index_(loops), most_(most), where_(where) {}

  std::vector<Meeting> run() {
    for (std::size_t l = 0; l < loops_.size(); ++l) {
      for (std::size_t e = 0; e < loops_[l].size() && found_.size() < most_; ++e) {
        look_about({static_cast<int>(l), static_cast<int>(e)});
      }
    }
    return std::move(found_);
  }

 private:
  void look_about(EdgeId id) {
    std::vector<EdgeId> later;
    index_.visit(index_.edge(id).box().grown(kTouch), [&](EdgeId other) {
      if (id < other) later.push_back(other);
      ++pairs_;
      return true;
    });
    if (pairs_ > kMostPairs) {
      throw InputError(where_, "too many long lines lie across each other; simplify the drawing");
    }
    std::sort(later.begin(), later.end());
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
    return distance(p, q) > kShortestOverlap && distance(b, nearest(a, (p + q) / 2.0).point) <= 2 * kTouch;
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
    return distance(a_shorter ? b : a, (a_shorter ? a : b).at(0.5)) <= kTouch;
  }

  /// The place is the joint of the neighbours, or so near to it that they lie on each other in between.
  bool is_joint(EdgeId first, EdgeId second, Vec2 place) const {
    const Edge& a = index_.edge(first);
    const Edge& b = index_.edge(second);
    if (distance(place, b.from) <= kTangentGap) return true;
    return distance(b, nearest(a, (place + b.from) / 2.0).point) <= kTangentGap;
  }

  Passage passage(EdgeId id, Vec2 place) const {
    const Edge& edge = index_.edge(id);
    if (distance(place, edge.from) <= 2 * kTouch) {
      return {-index_.edge(previous(id)).tangent_at(1), edge.tangent_at(0)};
    }
    if (distance(place, edge.to) <= 2 * kTouch)
      return {-edge.tangent_at(1), index_.edge(next(id)).tangent_at(0)};
    const Vec2 along = edge.tangent_at(nearest(edge, place).t);
    return {-along, along};
  }

  MeetingKind kind_at(EdgeId a, EdgeId b, Vec2 place) const {
    const Passage one = passage(a, place), other = passage(b, place);
    const auto back = is_left(one, other.back), ahead = is_left(one, other.ahead);
    return back && ahead && *back != *ahead ? MeetingKind::kCrossing : MeetingKind::kTouch;
  }

  /// Whether a direction points to the left of a passage; nothing when it runs along it.
  static std::optional<bool> is_left(const Passage& way, Vec2 direction) {
    constexpr double kSame = 1e-7;
    const auto turn = [](Vec2 from, Vec2 to) {
      const double angle = std::atan2(cross(from, to), dot(from, to));
      return angle < 0 ? angle + 2 * kPi : angle;
    };
    const double to_back = turn(way.ahead, way.back), to_direction = turn(way.ahead, direction);
    if (to_direction < kSame || to_direction > 2 * kPi - kSame) return std::nullopt;
    if (std::abs(to_direction - to_back) < kSame) return std::nullopt;
    return to_direction < to_back;
  }

  const std::vector<Loop>& loops_;
  const EdgeIndex index_;
  const std::size_t most_;
  const std::string& where_;
  std::vector<Meeting> found_;
  long long pairs_ = 0;
};

}  // namespace

std::vector<Meeting> meetings(const std::vector<Loop>& loops, std::size_t most, const std::string& where) {
  return Search(loops, most, where).run();
}

}  // namespace clearcut
