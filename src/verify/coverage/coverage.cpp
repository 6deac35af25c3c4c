#include "verify/coverage/coverage.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "base/elementary.h"
#include "base/tolerances.h"
#include "verify/coverage/swath_cover.h"
#include "verify/part/legal_centers.h"

namespace clearcut::verify {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Cells with more outline edges than this are divided instead of computing a convex hull.
constexpr int kHullEdges = 12;
/// Number of swaths tried on one cell, the nearest first.
constexpr int kSwathsTried = 12;
/// Number of undecided smallest cells after which the smallest size doubles, so that programs with much uncut
/// material take no longer.
constexpr int kLeavesPerSize = 4000;
/// Residuals thinner than the thickest found so far only add to the area: cells of R / kAreaCells suffice for them.
constexpr double kAreaCells = 64;
/// If something is left, its area is measured with residuals down to this fraction of the tolerance.
constexpr double kFineShare = 50;
/// mm. A point so much farther from the nearest legal centre than the cutter reaches is out of reach.
constexpr double kBeyondReach = 1e-6;
/// Greatest number of edges from which the winding number of one place is derived from that of another: the tree is faster than more.
constexpr int kMostCrossed = 32;
/// mm and the sine of an angle. Where an edge ends nearer to the way between both places, or meets it at less, the tree is asked, too.
constexpr double kBesideWay = 1e-6;
constexpr double kLeastAcross = 1e-4;
/// The area of unreachable corners is counted in cells of R / kCornerCells.
constexpr double kCornerCells = 48;

class CoverageProof {
 public:
  /// `fine`: counts residuals down to a fraction of the tolerance, to measure the uncut area.
  CoverageProof(const CoverageQuestion& question, const Tolerances& tol, bool fine)
      : question_(question),
        residual_(question),
        tol_(tol),
        widest_(fine ? tol.uncut / kFineShare
                     : std::max(widest_left(tol) - question.path_tolerance, widest_left(tol) / 2)),
        slack_(widest_ / 2),
        followed_(fine ? tol.uncut : widest_),
        target_(*question.target),
        known_(target_.box().grown(question.radius)),
        legal_(*question.part, question.z, question.radius + question.allowance, question.corner, known_,
               tol),
        deviation_(legal_.boundary().edges().size(), -1) {
    std::map<double, std::vector<Edge>> paths;
    for (const Swath& swath : question.swaths) paths[swath.radius].push_back(swath.path);
    for (auto& [radius, edges] : paths) trees_.emplace_back(radius, EdgeTree(std::move(edges)));
  }

  Coverage run() {
    result_.target_mm2 = area(*question_.target);
    if (target_.empty()) return result_;
    result_.reachable = any_within_reach();
    if (!result_.reachable) {
      result_.unreachable_mm2 = result_.target_mm2;
      return result_;
    }
    for (std::size_t i = 0; i < question_.swaths.size(); ++i) swaths_.push_back({0, static_cast<int>(i)});
    for (std::size_t i = 0; i < target_.edges().size(); ++i) outline_.push_back(static_cast<int>(i));
    for (std::size_t i = 0; i < deviation_.size(); ++i) legals_.push_back(static_cast<int>(i));
    const Box box = target_.box();
    const Cell root{box.center(), std::max(box.width(), box.height()) / 2 + 1e-3, true, Legality::kMixed};
    visit(root, {{0, end(swaths_)}, {0, end(outline_)}, {0, end(legals_)}});
    return result_;
  }

 private:
  /// Share of a cell's points that are legal centres.
  enum class Legality : unsigned char { kMixed, kNone, kAll };

  struct Cell {
    Vec2 center;
    double half = 0;
    bool on_outline = true;  ///< the target's outline may run through the cell
    Legality legality = Legality::kMixed;

    double reach() const { return half * 1.41421356237309515; }
    Box box() const { return {{center.x - half, center.y - half}, {center.x + half, center.y + half}}; }
    Cell quarter(int i) const {
      const double h = half / 2;
      return {{center.x + (i & 1 ? h : -h), center.y + (i & 2 ? h : -h)}, h, on_outline, legality};
    }
  };
  struct Range {
    int begin = 0, end = 0;
    bool empty() const { return begin == end; }
  };
  /// Items near a cell, as ranges of the stacks below.
  struct Near {
    Range swaths, outline, legals;
  };
  /// The outline's winding number at one place of a cell, which those at others follow from.
  struct WindingNearby {
    Range outline;                   ///< the edges that come near the cell
    WindingNearby* above = nullptr;  ///< of the cell that this one is a quarter of
    std::optional<Vec2> known_at{};
    int number = 0;
  };
  struct NearSwath {
    double excess;  ///< mm; distance of the cell's centre outside the swath
    int index;
  };

  template <typename T>
  static int end(const std::vector<T>& stack) {
    return static_cast<int>(stack.size());
  }

  void visit(Cell cell, const Near& parents, WindingNearby* above = nullptr) {
    const int marks[] = {end(swaths_), end(outline_), end(legals_)};
    Near near;
    WindingNearby nearby{parents.outline, above};
    if (!settle(cell, parents, near, nearby)) {
      nearby.outline = near.outline;
      for (int i = 0; i < 4; ++i) visit(cell.quarter(i), near, &nearby);
    }
    swaths_.resize(marks[0]);
    outline_.resize(marks[1]);
    legals_.resize(marks[2]);
  }

  /// Whether some part of the target is within reach of a legal centre. If the boundary of the legal area is not near
  /// a region of the target, the region is either wholly legal or not at all: other features may have removed all
  /// material around it. Places too narrow for the cutter only by rounding count as reachable for programs that cut
  /// there.
  bool any_within_reach() const {
    const std::vector<Edge>& legal = legal_.boundary().edges();
    const bool owed = legal_.within_fit() || !question_.swaths.empty();
    return (owed &&
            std::any_of(legal.begin(), legal.end(), [this](const Edge& curve) { return reaches(curve); })) ||
           std::any_of(question_.target->begin(), question_.target->end(), [this](const Region& region) {
             return legal_.contains(region.outer().front().at(0.5));
           });
  }

  bool reaches(const Edge& curve) const {
    if (target_.winding(curve.from) != 0 || target_.nearest(curve.from, question_.flat).edge >= 0)
      return true;
    if (curve.from == curve.to) return false;
    bool found = false;
    target_.overlapping(curve.box().grown(question_.flat), [&](int i) {
      found = found || distance(target_.edges()[i], curve) <= question_.flat;
    });
    return found;
  }

  /// Decides a cell if possible; else fills `near` for its quarters.
  bool settle(Cell& cell, const Near& parents, Near& near, WindingNearby& nearby) {
    if (covered_by_one(cell, parents.swaths, near.swaths)) return true;
    if (leaves_outline(cell, parents.outline, near.outline) && winding_at(cell.center, nearby) == 0)
      return true;
    ConvexPolygon part = part_in_target(cell, near.outline, nearby);
    if (part.empty()) return true;
    if (residual_.may_be() && residual_.holds_on_one_wall(part, cell.center, cell.reach())) return true;
    if (cell.half <= question_.flat && take_covered(part, near.swaths)) return true;
    const bool within_reach = list_legals(cell, part, parents.legals, near.legals);
    if (cell.legality == Legality::kNone) {
      if (near.legals.empty()) return count_unreachable(cell, near, nearby);
      if (program_follows(near.legals)) return count_corner(cell, near, &nearby);
    }
    return cell.half <= question_.flat / 4 && settle_uncut(cell, part, near, within_reach);
  }

  /// Decides an uncut cell, or one of the smallest; `part` contains its possibly uncut part.
  bool settle_uncut(const Cell& cell, const ConvexPolygon& part, const Near& near, bool within_reach) {
    const bool smallest = 2 * cell.half <= smallest_cell();
    const double excess = excess_at(cell.center), thickness = excess + cell.reach();
    const double width = width_of(cell, thickness);
    if (width <= widest_) return count_width(width);
    // If something wider is left elsewhere, only the area of this cell matters.
    const bool minor = width <= worst_width_ && cell.half <= question_.flat / kAreaCells;
    const bool all_left = near.swaths.empty() && within_reach && cell.reach() <= 0.05 * excess;
    if (!smallest && !minor && !all_left) return false;
    return count_uncut(cell, part, width);
  }

  /// mm; upper bound of the widest disc of material centred in the cell, if no point of the cell is farther than
  /// `thickness` from the cut area: the disc extends neither into the cut area, nor over the edge of the target, nor
  /// into the unreachable area.
  double width_of(const Cell& cell, double thickness) const {
    const double beside = target_.nearest(cell.center, thickness + cell.reach()).distance + cell.reach();
    const double beyond =
        cell.legality == Legality::kAll ? kInfinite : to_unreachable(cell.center) + cell.reach();
    return 2 * std::min({thickness, beside, beyond});
  }

  /// mm; upper bound of the distance from p to the nearest unreachable point. This point is sought in the direction
  /// straight away from the nearest legal centre, at its reach. Infinite if the point is reached from another centre,
  /// or if p itself is legal.
  double to_unreachable(Vec2 p) const {
    const double reach = question_.flat + kBeyondReach;
    const EdgeTree::Hit hit = legal_.boundary().nearest(p);
    if (hit.edge < 0 || hit.distance < kBeyondReach || legal_.contains(p)) return kInfinite;
    if (hit.distance >= reach) return 0;
    const Vec2 from = nearest_point(legal_.boundary().edges()[hit.edge], p);
    const Vec2 out = from + unit(p - from) * reach;
    const double least = legal_.boundary().nearest(out).distance;
    return least > question_.flat && !legal_.contains(out) ? distance(p, out) : kInfinite;
  }

  bool covered_by_one(const Cell& cell, Range from, Range& out) {
    out.begin = end(swaths_);
    for (int k = from.begin; k < from.end; ++k) {
      const int index = swaths_[k].index;
      const Swath& swath = question_.swaths[index];
      const double excess = distance(swath.path, cell.center) - swath.radius;
      if (excess + cell.reach() <= slack_) return count_covered(excess + cell.reach());
      if (excess <= cell.reach()) swaths_.push_back({excess, index});
    }
    out.end = end(swaths_);
    return false;
  }

  /// Lists the outline's edges near the cell. True if there is none, other than in the cell that it is a quarter of.
  bool leaves_outline(Cell& cell, const Range from, Range& out) {
    if (!cell.on_outline) return false;
    out.begin = end(outline_);
    for (int k = from.begin; k < from.end; ++k) {
      if (distance(target_.edges()[outline_[k]], cell.center) <= cell.reach())
        outline_.push_back(outline_[k]);
    }
    out.end = end(outline_);
    cell.on_outline = !out.empty();
    return !cell.on_outline;
  }

  int winding_at(Vec2 p, WindingNearby& nearby) const {
    for (const WindingNearby* cell = &nearby; cell != nullptr; cell = cell->above) {
      if (!cell->known_at) continue;
      const auto number = winding_beyond(*cell, p);
      if (!number) break;
      nearby.known_at = p;
      nearby.number = *number;
      return *number;
    }
    const int number = target_.winding(p);
    for (WindingNearby* cell = &nearby; cell != nullptr && !cell->known_at; cell = cell->above) {
      cell->known_at = p;
      cell->number = number;
    }
    return number;
  }

  static bool passes_beside(const Edge& line, const Box& box) {
    const auto [left, right] = std::minmax(line.from.x, line.to.x);
    const auto [low, high] = std::minmax(line.from.y, line.to.y);
    return right < box.min.x || left > box.max.x || high < box.min.y || low > box.max.y;
  }

  /// Adds what the edges on the way from the place that is known to p change; nothing where the way meets one of them at its end or
  /// at so small an angle that rounding may decide.
  std::optional<int> winding_beyond(const WindingNearby& nearby, Vec2 p) const {
    if (nearby.outline.end - nearby.outline.begin > kMostCrossed) return std::nullopt;
    const Vec2 from = *nearby.known_at;
    if (from == p) return nearby.number;
    const Edge way = Edge::line(from, p);
    const Vec2 along = unit(p - from);
    const Box box = way.box().grown(kBesideWay);
    int number = nearby.number;
    for (int k = nearby.outline.begin; k < nearby.outline.end; ++k) {
      const Edge& edge = target_.edges()[outline_[k]];
      if (!edge.is_arc() && passes_beside(edge, box)) continue;
      for (const Vec2 at : {edge.from, edge.to})
        if (distance(way, at) < kBesideWay) return std::nullopt;
      for (const Vec2 at : intersections(way, edge)) {
        const double across = cross(edge.tangent_at(nearest(edge, at).t), along);
        if (std::abs(across) < kLeastAcross || distance(at, from) < kBesideWay ||
            distance(at, p) < kBesideWay)
          return std::nullopt;
        number += across > 0 ? 1 : -1;  // what an edge encloses lies on its left
      }
    }
    return number;
  }

  /// A convex polygon that contains the cell's part of the target.
  ConvexPolygon part_in_target(const Cell& cell, Range outline, WindingNearby& nearby) {
    const ConvexPolygon square = ConvexPolygon::square(cell.center, cell.half);
    if (!cell.on_outline || outline.end - outline.begin > kHullEdges) return square;
    extremes_.clear();
    const Box box = cell.box();
    for (int k = outline.begin; k < outline.end; ++k)
      append_extremes(target_.edges()[outline_[k]], box, extremes_);
    for (const Vec2 corner : square.points()) {
      if (winding_at(corner, nearby) != 0) extremes_.push_back(corner);
    }
    if (extremes_.empty()) return winding_at(cell.center, nearby) != 0 ? square : ConvexPolygon();
    return ConvexPolygon::hull(extremes_);
  }

  /// Removes swath after swath from the polygon; true if the rest is in one swath.
  bool take_covered(ConvexPolygon& rest, Range near) {
    if (near.end - near.begin > 8 * kSwathsTried) return false;
    std::sort(swaths_.begin() + near.begin, swaths_.begin() + near.end,
              [](const NearSwath& a, const NearSwath& b) {
                return a.excess < b.excess || (a.excess == b.excess && a.index < b.index);
              });
    const int last = std::min(near.end, near.begin + kSwathsTried);
    for (int round = 0; round < 2; ++round) {
      for (int k = near.begin; k < last; ++k) {
        const Swath& swath = question_.swaths[swaths_[k].index];
        const double excess = excess_over(rest, swath);
        if (excess <= slack_) return count_covered(excess);
        if (round == 0) rest = rest_after(rest, swath);
        if (rest.empty()) return true;
      }
    }
    return false;
  }

  /// The box about the circle about the cell.
  static Box around(const Cell& cell) { return cell.box().grown(cell.reach() - cell.half); }

  /// Lists the boundary of the legal area within the cutter's reach of the cell. True if all of `part` is
  /// within reach.
  bool list_legals(Cell& cell, const ConvexPolygon& part, Range from, Range& out) {
    out.begin = end(legals_);
    double least = kInfinite;
    int nearest = -1;
    for (int k = from.begin; k < from.end; ++k) {
      const double d = distance(legal_.boundary().edges()[legals_[k]], cell.center);
      if (d < least) least = d, nearest = legals_[k];
      if (d <= question_.flat + cell.reach()) legals_.push_back(legals_[k]);
    }
    out.end = end(legals_);
    if (cell.legality == Legality::kMixed && least > cell.reach() && known_.contains(around(cell).min) &&
        known_.contains(around(cell).max)) {
      cell.legality = legal_.contains(cell.center) ? Legality::kAll : Legality::kNone;
    }
    if (cell.legality == Legality::kAll || least + cell.reach() <= question_.flat) return true;
    return nearest >= 0 &&
           excess_over(part, {legal_.boundary().edges()[nearest], question_.flat}) <= kRoundingMm;
  }

  bool program_follows(Range legals) {
    double most = 0;
    for (int k = legals.begin; k < legals.end && most <= followed_; ++k) {
      double& deviation = deviation_[legals_[k]];
      if (deviation < 0) deviation = deviation_of_program(legal_.boundary().edges()[legals_[k]]);
      most = std::max(most, deviation);
    }
    if (most > followed_) return false;
    result_.thickness_mm = std::max(result_.thickness_mm, most);
    return true;
  }

  /// mm; upper bound of the distance of the curve's points from the nearest path; greater for smaller cutters.
  double deviation_of_program(const Edge& curve) const {
    const bool point = curve.from == curve.to;
    const Vec2 middle = point ? curve.from : curve.at(0.5);
    double bound = kInfinite, at_middle = kInfinite;
    for (const auto& [radius, tree] : trees_) {
      const double smaller = std::max(0.0, question_.flat - radius);
      for (const Vec2 p : {middle, curve.from, curve.to}) {
        const EdgeTree::Hit hit = tree.nearest(p, tol_.uncut * 2 + curve.length());
        if (hit.edge < 0) continue;
        if (p == middle) at_middle = std::min(at_middle, hit.distance + smaller);
        bound = std::min(bound, deviation_of(curve, tree.edges()[hit.edge]) + smaller);
      }
    }
    const double good = slack_ / 5;
    if (at_middle > tol_.uncut) return kInfinite;
    if (bound <= 1.1 * at_middle + good || point || curve.length() < good) return bound;
    const double first = deviation_of_program(curve.part(0, 0.5));
    return first > tol_.uncut ? first : std::max(first, deviation_of_program(curve.part(0.5, 1)));
  }

  /// mm; distance of p outside the swept area; negative inside.
  double excess_at(Vec2 p) const {
    double least = kInfinite;
    for (const auto& [radius, tree] : trees_) least = std::min(least, tree.distance_to(p) - radius);
    const Box box = target_.box();
    return std::min(least, base::hypot(box.width(), box.height()));
  }

  /// mm; size of a cell small enough to distinguish reachable from nearly reachable places.
  double smallest_cell() const {
    const auto doublings = leaves_ / kLeavesPerSize;
    return std::min(question_.flat / 4, tol_.uncut / 8 * base::exp2(static_cast<double>(doublings)));
  }

  /// Records that material at most `excess` mm outside a swath is at most twice as wide.
  bool count_covered(double excess) { return count_width(2 * excess); }

  bool count_width(double width) {
    result_.thickness_mm = std::max(result_.thickness_mm, width);
    return true;
  }

  bool count_uncut(const Cell& cell, const ConvexPolygon& part, double width) {
    ++leaves_;
    result_.uncut_mm2 += part.area();
    if (width > worst_width_) {
      result_.worst = cell.center;
      worst_width_ = width;
    }
    return count_width(width);
  }

  bool count_unreachable(const Cell& cell, const Near& near, WindingNearby& nearby) {
    if (cell.on_outline || residual_.may_be()) return count_corner(cell, near, &nearby);
    result_.unreachable_mm2 += 4 * cell.half * cell.half;
    return true;
  }

  /// Adds the part of a cell that no centre reaches; the program is known to have cut the rest as far as
  /// possible.
  bool count_corner(Cell cell, Near near, WindingNearby* above = nullptr) {
    const int marks[] = {end(outline_), end(legals_)};
    WindingNearby nearby{near.outline, above};
    if (!settle_corner(cell, near, nearby)) {
      nearby.outline = near.outline;
      for (int i = 0; i < 4; ++i) count_corner(cell.quarter(i), near, &nearby);
    }
    outline_.resize(marks[0]);
    legals_.resize(marks[1]);
    return true;
  }

  bool settle_corner(Cell& cell, Near& near, WindingNearby& nearby) {
    if (leaves_outline(cell, near.outline, near.outline) && winding_at(cell.center, nearby) == 0) return true;
    const double least = keep_nearest_legals(cell, near.legals);
    if (least + cell.reach() <= question_.flat) return true;
    const bool near_residual = residual_.may_hold(cell.center, cell.reach());
    if (near_residual &&
        residual_.holds_on_one_wall(ConvexPolygon::square(cell.center, cell.half), cell.center, cell.reach()))
      return true;
    const double area = 4 * cell.half * cell.half;
    const bool beyond = least > question_.flat;
    if (2 * cell.half <= question_.flat / kCornerCells) {
      if (beyond && (!cell.on_outline || winding_at(cell.center, nearby) != 0) &&
          !residual_.holds(cell.center)) {
        result_.unreachable_mm2 += area;
      }
      return true;
    }
    if (cell.on_outline || least - cell.reach() <= question_.flat || near_residual) return false;
    result_.unreachable_mm2 += area;
    return true;
  }

  /// Keeps the edges of the list that may be nearest to some point of the cell; returns the distance of the cell's
  /// centre.
  double keep_nearest_legals(const Cell& cell, Range& legals) {
    double least = kInfinite;
    const Range from = legals;
    apart_.clear();
    for (int k = from.begin; k < from.end; ++k) {
      apart_.push_back(distance(legal_.boundary().edges()[legals_[k]], cell.center));
      least = std::min(least, apart_.back());
    }
    if (from.end - from.begin == 1) return least;
    legals.begin = end(legals_);
    for (int k = from.begin; k < from.end; ++k) {
      if (apart_[k - from.begin] <= least + 2 * cell.reach()) legals_.push_back(legals_[k]);
    }
    legals.end = end(legals_);
    return least;
  }

  const CoverageQuestion& question_;
  const WallResidual residual_;
  const Tolerances& tol_;
  const double widest_;  ///< mm; residuals up to this width are no fault
  const double slack_;   ///< mm; residuals at most this far outside a swath are not too wide
  /// mm; a program within this distance of the legal area's boundary leaves no thicker residual in corners.
  const double followed_;
  EdgeTree target_;
  /// The box in which the boundary of the legal area is known. Outside, at a pocket beside the target, a cell without
  /// a known boundary nearby may still be legal only in part.
  const Box known_;
  LegalCenters legal_;
  /// mm; distance of the program from each edge of the legal boundary; -1: not computed yet.
  std::vector<double> deviation_;
  std::vector<std::pair<double, EdgeTree>> trees_;  ///< for each tool radius: the paths cut with this radius
  // Stacks of items near the cells from the whole target down to the current one.
  std::vector<NearSwath> swaths_;
  std::vector<int> outline_, legals_;
  std::vector<double> apart_;  ///< mm; of the legal edges near a cell from its centre
  std::vector<Vec2> extremes_;
  int leaves_ = 0;
  double worst_width_ = 0;
  Coverage result_;
};

}  // namespace

Coverage nothing_in_reach(const Regions& target) {
  Coverage nothing;
  nothing.target_mm2 = nothing.unreachable_mm2 = area(target);
  return nothing;
}

Coverage coverage_of(const CoverageQuestion& question, const Tolerances& tol) {
  if (question.flat > tol.uncut) {
    Coverage coverage = CoverageProof(question, tol, false).run();
    const bool left =
        coverage.thickness_mm + question.path_tolerance > widest_left(tol) && coverage.uncut_mm2 > 0;
    if (left)
      coverage.uncut_mm2 = std::max(coverage.uncut_mm2, CoverageProof(question, tol, true).run().uncut_mm2);
    coverage.path_tolerance_mm = question.path_tolerance;
    if (coverage.reachable)
      coverage.thickness_mm = std::max(coverage.thickness_mm + question.path_tolerance, question.above);
    return coverage;
  }
  return nothing_in_reach(*question.target);
}

}  // namespace clearcut::verify
