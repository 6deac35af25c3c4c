#include <algorithm>
#include <cmath>
#include <map>

#include "base/tolerances.h"
#include "base/units.h"
#include "geometry/voronoi/axis.h"
#include "geometry/voronoi/diagram.h"

namespace clearcut::inline geometry::voronoi {
namespace {

constexpr double kTiny = 0.01;
/// mm of the axis per mm of clearance in the sharpest corner still distinguished from a slot: 8 degrees.
constexpr double kSteepest = 14.3;
/// Radians. Walls that meet at a smaller angle continue each other smoothly.
constexpr double kSmooth = 1e-3;
/// mm. Rounding of clearances.
constexpr double kRounding = 1e-7;
/// Halvings of an edge for the place of a level, those that a guess spares, and the intervals that they lead to.
constexpr int kHalvings = 40;
constexpr int kSpared = 32;
constexpr double kIntervals = 1LL << kSpared;
/// Steps of guessing at most; mm, the error of the clearance at which they end.
constexpr int kGuesses = 8;
constexpr double kGuessed = 1e-11;
/// mm. If all places where the cutter fits are within this distance of one place, that place becomes a point: moving
/// there would clear only half of the thickness that may be left.
constexpr double kPoint = 0.005;

/// The axis cut to a band of clearances, as a graph of its own.
class Band {
 public:
  Band(const Axis& axis, const Diagram& diagram, const FitBand& band)
      : axis_(axis), d_(diagram), low_(band.low), radius_(band.radius), high_(band.high) {
    for (std::size_t i = 0; i < axis.graph.edges.size(); ++i) add_edge(static_cast<int>(i));
  }

  std::vector<Path> run(double stub) {
    std::vector<Path> paths = take_points();
    prune_stubs(stub);
    // First from ends and forks; the remaining curves are rings.
    for (const bool rings : {false, true}) {
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        for (const bool forward : {true, false}) {
          if (!parts_[i].used && (rings || degree(start(i, forward)) != 2)) collect(i, forward, stub, paths);
        }
      }
    }
    return paths;
  }

 private:
  struct Place {
    Vec2 point;
    double clearance = 0;
    bool into_region = false;  ///< cut at the upper limit: a wider place follows
    std::vector<std::size_t> parts;
  };
  struct Part {
    int a, b;  ///< places
    Walls walls;
    bool used = false;
  };

  void add_edge(int edge) {
    AxisEdge e = axis_.graph.edges[index(edge)];
    if (point(e.a).clearance > point(e.b).clearance) std::swap(e.a, e.b);
    const double ca = point(e.a).clearance, cb = point(e.b).clearance;
    if (cb < low_ || ca >= high_) return;
    const Walls walls = axis_.walls[index(edge)];
    const int a = ca >= low_ ? place_at(e.a) : cut(e, walls, low_, false);
    const int b = cb < high_ ? place_at(e.b) : cut(e, walls, high_, true);
    if (places_[index(a)].point == places_[index(b)].point) return;
    places_[index(a)].parts.push_back(parts_.size());
    places_[index(b)].parts.push_back(parts_.size());
    parts_.push_back({a, b, walls, false});
  }

  const AxisPoint& point(int p) const { return axis_.graph.points[index(p)]; }

  int place_at(int p) {
    const auto [found, added] = place_of_.try_emplace(p, static_cast<int>(places_.size()));
    if (added) places_.push_back({point(p).point, point(p).clearance, false, {}});
    return found->second;
  }

  /// Adds the place on an edge rising from a to b at which the clearance is `level`, by bisection on the curved
  /// bisector. A few steps of the method of false position find the interval in which most of the halvings end.
  int cut(const AxisEdge& e, Walls walls, double level, bool into_region) {
    const Element &a = d_.element(walls.a), &b = d_.element(walls.b);
    const auto place = [&](double t) { return on_bisector(a, b, point(e.a).point, point(e.b).point, t); };
    const auto rise = [&](double t) { return distance(a, place(t)) - level; };
    double below = 0, above = 1;
    int halvings = kHalvings;
    const double guess = false_position(rise, point(e.a).clearance - level, point(e.b).clearance - level);
    const double first = std::floor(guess * kIntervals) / kIntervals, last = first + 1 / kIntervals;
    if (first > 0 && last < 1 && rise(first) < 0 && rise(last) >= 0) {
      below = first;
      above = last;
      halvings -= kSpared;
    }
    for (int step = 0; step < halvings; ++step) {
      const double middle = (below + above) / 2;
      (rise(middle) < 0 ? below : above) = middle;
    }
    places_.push_back({place(below), level, into_region, {}});
    return static_cast<int>(places_.size()) - 1;
  }

  /// A place in [0, 1] at which a function that rises from `low` < 0 to `high` >= 0 is about zero (the Illinois method).
  template <typename Rise>
  static double false_position(const Rise& rise, double low, double high) {
    double below = 0, above = 1, at = 0.5;
    int side = 0;  // on which the last guess was: the other end counts half if it stays twice
    for (int step = 0; step < kGuesses; ++step) {
      at = high > low ? below - low * (above - below) / (high - low) : (below + above) / 2;
      const double value = rise(at);
      if (std::abs(value) < kGuessed) break;
      if (value < 0) {
        below = at;
        low = value;
        if (side < 0) high /= 2;
        side = -1;
      } else {
        above = at;
        high = value;
        if (side > 0) low /= 2;
        side = 1;
      }
    }
    return at;
  }

  int start(std::size_t part, bool forward) const { return forward ? parts_[part].a : parts_[part].b; }
  int end(std::size_t part, bool forward) const { return start(part, !forward); }

  /// All places connected with one, itself included.
  std::vector<int> group_of(int first, std::vector<char>& seen) const {
    std::vector<int> group{first};
    seen[index(first)] = 1;
    for (std::size_t next = 0; next < group.size(); ++next) {
      for (const std::size_t part : places_[index(group[next])].parts) {
        for (const int place : {parts_[part].a, parts_[part].b}) {
          if (seen[index(place)] != 0) continue;
          seen[index(place)] = 1;
          group.push_back(place);
        }
      }
    }
    return group;
  }

  /// Groups no larger than a point are replaced by one point at the place of largest clearance; so are the centres of
  /// round pockets.
  std::vector<Path> take_points() {
    std::vector<Path> points;
    const auto add = [&points](Vec2 p) { points.push_back({Edge::line(p, p)}); };
    for (std::size_t i = 0; i < axis_.graph.points.size(); ++i) {
      const AxisPoint& p = axis_.graph.points[i];
      if (axis_.incident[i].empty() && p.clearance >= low_ && p.clearance < high_) add(p.point);
    }
    std::vector<char> seen(places_.size(), 0);
    for (std::size_t first = 0; first < places_.size(); ++first) {
      if (seen[first] != 0) continue;
      const std::vector<int> group = group_of(static_cast<int>(first), seen);
      const Place& best = places_[index(*std::max_element(group.begin(), group.end(), [this](int a, int b) {
        return places_[index(a)].clearance < places_[index(b)].clearance;
      }))];
      const bool point = std::all_of(group.begin(), group.end(), [&](int i) {
        const Place& place = places_[index(i)];
        return !place.into_region && norm(place.point - best.point) <= kPoint;
      });
      if (!point) continue;
      add(best.point);
      for (const int place : group) {
        for (const std::size_t part : places_[index(place)].parts) parts_[part].used = true;
      }
    }
    return points;
  }

  std::size_t degree(int place) const {
    const auto& parts = places_[index(place)].parts;
    return static_cast<std::size_t>(
        std::count_if(parts.begin(), parts.end(), [this](std::size_t i) { return !parts_[i].used; }));
  }

  struct Chain {
    std::vector<std::pair<std::size_t, bool>> parts;  ///< with their direction
    int first = 0, last = 0;
    double length = 0;
    double roomy = 0;  ///< length of the parts with clearance of at least the radius
  };

  /// Whether a dead end is only the end in a corner or the mouth of a wider place: a short stretch with slightly less
  /// room than the cutter needs.
  bool is_foot(const Chain& chain, double stub) const {
    return chain.length < stub && chain.roomy <= std::max(kPoint, kSteepest * (high_ - radius_));
  }

  /// Share of a part that is as wide as the cutter, its clearance taken to be linear.
  double roomy_share(const Part& part) const {
    const auto [low, high] = std::minmax(places_[index(part.a)].clearance, places_[index(part.b)].clearance);
    const double least = radius_ - kRounding;
    if (low >= least) return 1;
    return high <= least ? 0 : (high - least) / (high - low);
  }

  /// Parts from one end, fork or start of a ring to the next.
  Chain chain_from(std::size_t part, bool forward) const {
    Chain chain;
    chain.first = start(part, forward);
    for (;;) {
      chain.parts.emplace_back(part, forward);
      chain.last = end(part, forward);
      const double length = norm(places_[index(parts_[part].a)].point - places_[index(parts_[part].b)].point);
      chain.length += length;
      chain.roomy += length * roomy_share(parts_[part]);
      if (chain.last == chain.first || degree(chain.last) != 2) return chain;
      const auto& parts = places_[index(chain.last)].parts;
      const auto next = std::find_if(parts.begin(), parts.end(),
                                     [&](std::size_t i) { return i != part && !parts_[i].used; });
      if (next == parts.end()) return chain;
      part = *next;
      forward = parts_[part].a == chain.last;
    }
  }

  bool is_dead_end(int place) const { return degree(place) == 1 && !places_[index(place)].into_region; }

  /// Removes short dead ends, except the two longest of a star made of dead ends only.
  void prune_stubs(double stub) {
    std::map<int, std::vector<Chain>> at_fork;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      for (const bool forward : {true, false}) {
        if (!is_dead_end(start(i, forward))) continue;
        Chain chain = chain_from(i, forward);
        if (degree(chain.last) > 2 && is_foot(chain, stub)) at_fork[chain.last].push_back(std::move(chain));
      }
    }
    for (auto& [fork, stubs] : at_fork) {
      std::stable_sort(stubs.begin(), stubs.end(),
                       [](const Chain& a, const Chain& b) { return a.length < b.length; });
      if (stubs.size() == degree(fork)) stubs.resize(stubs.size() - 2);
      for (const Chain& chain : stubs) {
        for (const auto& [part, forward] : chain.parts) parts_[part].used = true;
      }
    }
  }

  void collect(std::size_t part, bool forward, double stub, std::vector<Path>& paths) {
    const Chain chain = chain_from(part, forward);
    const bool from_region = places_[index(chain.first)].into_region,
               to_region = places_[index(chain.last)].into_region;
    const bool dead_first = is_dead_end(chain.first), dead_last = is_dead_end(chain.last);
    for (const auto& [i, along] : chain.parts) parts_[i].used = true;
    const bool mouth = (from_region && dead_last) || (to_region && dead_first);
    if (mouth && is_foot(chain, stub)) return;
    Path path;
    for (const auto& [i, along] : chain.parts) {
      append(path, curve(places_[index(start(i, along))].point, places_[index(end(i, along))].point,
                         parts_[i].walls));
    }
    paths.push_back(path);
  }

  /// The bisector of two walls between two of its places: a line, or the arc through its middle.
  Edge curve(Vec2 from, Vec2 to, Walls walls) const {
    const Element &a = d_.element(walls.a), &b = d_.element(walls.b);
    // Between nodes this near, the curve's deviation from a line is below the nodes' own error.
    if ((!a.is_round() && !b.is_round()) || norm(to - from) < kTiny) return Edge::line(from, to);
    if (a.is_round() && b.is_round() && norm(a.edge.center - b.edge.center) < kSamePlaceMm) {
      const bool ccw = cross(from - a.edge.center, to - a.edge.center) > 0;
      return Edge::arc(from, to, a.edge.center, ccw ? Turn::kCounterClockwise : Turn::kClockwise);
    }
    const Vec2 chord = to - from, middle = lerp(from, to, 0.5);
    const double sagitta =
        dot(on_bisector(a, b, from, to, 0.5) - middle, left_of(chord)) / norm_squared(chord);
    // A bow to the left of the chord runs clockwise.
    return std::abs(sagitta) * norm(chord) < kSamePlaceMm ? Edge::line(from, to)
                                                          : Edge::from_bulge(from, to, -2 * sagitta);
  }

  /// The place of the bisector nearest to the middle (t = 0.5) or another place of a chord between two of its
  /// places.
  static Vec2 on_bisector(const Element& a, const Element& b, Vec2 from, Vec2 to, double t) {
    const Vec2 start = lerp(from, to, t);
    Vec2 p = start;
    for (int step = 0; step < 4; ++step) {
      const Vec2 g = away_from(a, p) - away_from(b, p);
      const double f = distance(a, p) - distance(b, p);
      // Walls continuing each other smoothly hardly determine the bisector: the straight guess is kept, and f is
      // nearly zero.
      if (norm_squared(g) < kSmooth * kSmooth) break;
      p = p - g * (f / norm_squared(g));
    }
    return norm_squared(p - start) <= norm_squared(to - from) ? p : start;
  }

  static void append(Path& path, const Edge& edge) {
    if (!path.empty() && try_merge(path.back(), edge)) return;
    path.push_back(edge);
  }

  static bool try_merge(Edge& last, const Edge& next) {
    if (last.turn != next.turn || last.from == next.to) return false;
    if (last.is_arc()) {
      if (norm(last.center - next.center) > kSamePlaceMm || std::abs(last.sweep() + next.sweep()) > kPi)
        return false;
    } else if (distance(Edge::line(last.from, next.to), last.to) > kSamePlaceMm) {
      return false;
    }
    last.to = next.to;
    return true;
  }

  const Axis& axis_;
  const Diagram& d_;
  double low_, radius_, high_;
  std::vector<Place> places_;
  std::vector<Part> parts_;
  std::map<int, int> place_of_;
};

}  // namespace

std::vector<Path> fit_lines(const Axis& axis, const Diagram& diagram, const FitBand& band, double stub) {
  return Band(axis, diagram, band).run(stub);
}

}  // namespace clearcut::inline geometry::voronoi
