#include "verify/part/slivers.h"

#include <algorithm>
#include <limits>

#include "base/tolerances.h"

namespace clearcut::verify {
namespace {

/// Accuracy of the end of a thin sliver as a share of the wall's length; places nearer to each other are one.
constexpr double kEndOfSliver = 1e-6;
constexpr double kNoSliver = std::numeric_limits<double>::infinity();

class SliverFinder {
 public:
  SliverFinder(const std::vector<Wall>& walls, const EdgeTree& tree) : walls_(walls), tree_(tree) {}

  /// Adds the wall in pieces with a thin sliver behind them along their whole length, or nowhere.
  void divide(const Wall& wall, Slivers& parts) {
    find_near(wall);
    if (near_.empty()) return parts.walls.push_back(wall);
    std::vector<double> cuts{0};
    const std::vector<double> places = places_along(wall.edge);
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      if (has_sliver(wall, places[i]) != has_sliver(wall, places[i + 1]))
        cuts.push_back(change_between(wall, places[i], places[i + 1]));
    }
    cuts.push_back(1);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      Wall piece = wall;
      if (cuts.size() > 2) piece.edge = wall.edge.part(cuts[i], cuts[i + 1]);
      piece.flat_from = wall.flat_from && i == 0;
      piece.flat_to = wall.flat_to && i + 2 == cuts.size();
      add(piece, sliver_z(wall, (cuts[i] + cuts[i + 1]) / 2), parts);
    }
  }

 private:
  /// Adds a wall with a thin sliver behind it from sliver_z up.
  static void add(Wall piece, double sliver_z, Slivers& parts) {
    if (sliver_z < piece.z_high) {
      parts.slivers.push_back(piece);
      parts.slivers.back().z_low = sliver_z;
      piece.z_high = sliver_z;
    }
    if (piece.z_low < piece.z_high) parts.walls.push_back(piece);
  }

  void find_near(const Wall& wall) {
    near_.clear();
    if (wall.slope > 0) return;
    tree_.overlapping(wall.edge.box().grown(kThinSliver), [&](int i) {
      const Wall& other = walls_[static_cast<std::size_t>(i)];
      const bool may_leave_sliver =
          other.feature != wall.feature && other.slope <= 0 && !(other.edge == wall.edge);
      if (may_leave_sliver && distance(wall.edge, other.edge) <= kThinSliver) near_.push_back(&other);
    });
  }

  /// Ascending; between two of them the distance of the other walls is monotone, if all are straight.
  std::vector<double> places_along(const Edge& edge) const {
    std::vector<double> places{0, 1};
    for (const Wall* other : near_) {
      for (const Vec2 end : {other->edge.from, other->edge.to}) places.push_back(nearest(edge, end).t);
    }
    std::sort(places.begin(), places.end());
    const auto same = [](double a, double b) { return b - a < kEndOfSliver; };
    places.erase(std::unique(places.begin(), places.end() - 1, same), places.end() - 1);
    for (std::size_t i = places.size() - 1; i > 0; --i) places.push_back((places[i - 1] + places[i]) / 2);
    std::sort(places.begin(), places.end());
    return places;
  }

  double sliver_z(const Wall& wall, double t) const {
    const Vec2 p = wall.edge.at(t), heading = wall.edge.tangent_at(t);
    double lowest = kNoSliver;
    for (const Wall* other : near_) {
      const auto there = nearest(other->edge, p);
      const Vec2 back = other->edge.tangent_at(there.t);
      const bool is_behind =
          dot(left_of(back), p - other->edge.at(there.t)) <= kRoundingMm && dot(heading, back) < 0;
      if (is_behind && there.distance <= kThinSliver)
        lowest = std::min(lowest, std::max(wall.z_low, other->z_low));
    }
    return lowest;
  }
  bool has_sliver(const Wall& wall, double t) const { return sliver_z(wall, t) < kNoSliver; }

  double change_between(const Wall& wall, double low, double high) const {
    const bool first = has_sliver(wall, low);
    while (high - low > kEndOfSliver) {
      const double middle = (low + high) / 2;
      (has_sliver(wall, middle) == first ? low : high) = middle;
    }
    return (low + high) / 2;
  }

  const std::vector<Wall>& walls_;
  const EdgeTree& tree_;
  std::vector<const Wall*> near_;
};

}  // namespace

EdgeTree tree_of(const std::vector<Wall>& walls) {
  std::vector<Edge> edges;
  for (const Wall& wall : walls) edges.push_back(wall.edge);
  return EdgeTree(std::move(edges));
}

Slivers parted(const std::vector<Wall>& walls) {
  const EdgeTree tree = tree_of(walls);
  SliverFinder finder(walls, tree);
  Slivers parts;
  for (const Wall& wall : walls) finder.divide(wall, parts);
  return parts;
}

}  // namespace clearcut::verify
