#include "plan/cover/places_left.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/units.h"
#include "geometry/spatial/cell_grid.h"
#include "plan/common/cover.h"
#include "plan/cover/witnesses.h"

namespace clearcut::plan::cover {
namespace {

/// A place counts as left if its distance from the path exceeds the radius by this share.
constexpr double kRounding = 1e-9;
/// Number of places told of an uncleared stretch of the boundary.
constexpr int kPlacesOfStretch = 6;
/// Corners of one hole's rim are within this many radii; number of places along each side of the raster over them.
constexpr double kGroup = 0.4;
constexpr int kPlacesOfHole = 8;
/// Side of the cells for finding moves near an edge, in radii.
constexpr double kCellOfMoves = 4;

/// First and last place, mm along an edge.
using Stretch = std::pair<double, double>;

class PlacesLeft {
 public:
  PlacesLeft(const CoveredArea& area, const Path& path, double radius)
      : area_(area),
        path_(path),
        radius_(radius),
        reach_(radius * (1 + kRounding)),
        cover_(path, reach_),
        moves_(kCellOfMoves * radius) {
    for (std::uint32_t i = 0; i < path.size(); ++i) moves_.add(path[i].box().grown(reach_), i);
  }

  std::vector<Vec2> find() {
    left_ = cover_.holes([&](Vec2 p) { return area_.inside.contains(p); });
    add_inner_places();
    // If the rim of the cleared area leaves the area to be covered, the rim's own corners are outside.
    for (const Edge& edge : area_.edges)
      if (edge.length() > 0) add_left_on(edge);
    return std::move(left_);
  }

 private:
  bool is_left(Vec2 p) const { return cover_.distance_to(p) > reach_; }

  /// Adds, to the corners of rims, places inside the holes: those of a raster over each group of corners that are not
  /// cleared.
  void add_inner_places() {
    std::vector<Box> groups;
    const double near = kGroup * radius_;
    BoxIndex index(near);
    for (const Vec2 p : left_) {
      const auto candidates = index.near(p);
      const auto group = std::find_if(candidates.begin(), candidates.end(), [&](std::uint32_t i) {
        return distance(groups[i].center(), p) < near;
      });
      if (group == candidates.end()) {
        index.add(p, static_cast<std::uint32_t>(groups.size()));
        groups.emplace_back();
        groups.back().add(p);
      } else {
        groups[*group].add(p);
      }
    }
    for (const Box& group : groups) {
      const Box box = group.grown(1e-3 * near);
      for (int i = 0; i <= kPlacesOfHole; ++i) {
        for (int k = 0; k <= kPlacesOfHole; ++k) {
          const Vec2 p{box.min.x + box.width() * i / kPlacesOfHole,
                       box.min.y + box.height() * k / kPlacesOfHole};
          if (is_left(p) && area_.inside.contains(p)) left_.push_back(p);
        }
      }
    }
  }

  /// Adds places of each uncleared stretch of the boundary.
  void add_left_on(const Edge& edge) {
    const double length = edge.length();
    std::vector<Stretch> cleared{{length, length}};
    for (const std::uint32_t i : moves_.near(edge.box())) {
      if (edge.is_arc())
        add_cleared_on_arc(edge, path_[i], cleared);
      else
        add_cleared_on_line(edge, path_[i], cleared);
    }
    std::sort(cleared.begin(), cleared.end());
    double up_to = 0;
    for (const auto& [first, last] : cleared) {
      // Rounding of an intersection at which the two curves touch may leave a stretch that is cleared.
      if (first > up_to + kRounding * radius_ && is_left(edge.at(0.5 * (up_to + first) / length)))
        add_stretch(edge, up_to, first);
      up_to = std::max(up_to, last);
    }
  }

  void add_cleared_on_line(const Edge& edge, const Edge& move, std::vector<Stretch>& cleared) const {
    const Vec2 along = unit(edge.to - edge.from);
    const auto turned = [&](Vec2 p) { return Vec2{dot(p - edge.from, along), cross(along, p - edge.from)}; };
    const ClearedBand::Run run = ClearedBand(turned(move.from), turned(move.to), reach_).at(0);
    if (run.first <= run.last && run.last >= 0 && run.first <= edge.length())
      cleared.emplace_back(run.first, run.last);
  }

  /// Between two intersections of the arc with the lines and circles at `reach_` from the move either all is cleared by the
  /// move, or nothing.
  void add_cleared_on_arc(const Edge& edge, const Edge& move, std::vector<Stretch>& cleared) const {
    const double length = edge.length();
    std::vector<double> cuts{0, length};
    const double r = edge.radius();
    const auto add = [&](Vec2 p) {
      const Vec2 from = edge.from - edge.center, to = p - edge.center;
      double turn = base::atan2(cross(from, to), dot(from, to));
      if (edge.turn == Turn::kClockwise) turn = -turn;
      if (turn < 0) turn += 2 * kPi;
      if (const double along = turn * r; along < length) cuts.push_back(along);
    };
    for (const Vec2 end : {move.from, move.to}) {
      const Vec2 between = end - edge.center;
      const double away = norm(between);
      if (away == 0) continue;
      const double x = 0.5 * (away + (r - reach_) * (r + reach_) / away), rest = r * r - x * x;
      if (rest < 0) continue;
      const Vec2 foot = edge.center + between * (x / away), side = left_of(between / away) * std::sqrt(rest);
      add(foot + side);
      add(foot - side);
    }
    if (move.from != move.to) {
      const Vec2 along = unit(move.to - move.from);
      for (const Vec2 aside : {left_of(along) * reach_, left_of(along) * -reach_}) {
        const Vec2 on = move.from + aside;
        const Vec2 foot = on + along * dot(edge.center - on, along);
        const double rest = r * r - norm_squared(foot - edge.center);
        if (rest < 0) continue;
        add(foot + along * std::sqrt(rest));
        add(foot - along * std::sqrt(rest));
      }
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const double middle = 0.5 * (cuts[i - 1] + cuts[i]);
      if (distance(move, edge.at(middle / length)) <= reach_) cleared.emplace_back(cuts[i - 1], cuts[i]);
    }
  }

  void add_stretch(const Edge& edge, double first, double last) {
    const double length = edge.length();
    for (int k = -1; k <= kPlacesOfStretch + 1; ++k) {
      const double at = first + (last - first) * k / kPlacesOfStretch;
      if (at >= 0 && at <= length) left_.push_back(edge.at(at / length));
    }
  }

  const CoveredArea& area_;
  const Path& path_;
  double radius_, reach_;
  Cover cover_;
  BoxIndex moves_;
  std::vector<Vec2> left_;
};

}  // namespace

std::vector<Vec2> places_left(const CoveredArea& area, const Path& path, double radius) {
  return PlacesLeft(area, path, radius).find();
}

}  // namespace clearcut::plan::cover
