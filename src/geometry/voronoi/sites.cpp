#include "geometry/voronoi/sites.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"
#include "base/work_budget.h"
#include "geometry/spatial/cell_grid.h"

namespace clearcut::inline geometry::voronoi {
namespace {

/// Coordinates stay under 2^29 units, so that exact predicates fit 64 bits; 0.1 um up to 100 m.
constexpr double kFinestUnit = 1e-4;
constexpr double kLargestExtent = 1e9;
/// Crossings caused by rounding are split at rounded points, and the parts can cross again: a few rounds suffice.
constexpr int kMostRounds = 20;

Grid grid_for(const Region& region) {
  const Box box = region.box();
  const Vec2 c = box.center();
  // Whole mm, so that coordinates on a 0.1 um raster stay exact.
  return {{std::round(c.x), std::round(c.y)},
          std::max(kFinestUnit, (std::max(box.width(), box.height()) + 2) / kLargestExtent)};
}

/// Directions from an anchor whose line passes within `slack` of all points seen so far.
class Cone {
 public:
  Cone(Vec2 anchor, double slack) : anchor_(anchor), slack_(slack) {}
  bool accepts(Vec2 p) const {
    const Vec2 w = p - anchor_;
    if (norm_squared(w) < farthest_squared_) return false;
    return !limited_ || (cross(low_, w) >= 0 && cross(w, high_) >= 0 && dot(low_, w) > 0);
  }
  void add(Vec2 p) {
    const Vec2 w = p - anchor_;
    const double m = std::sqrt(norm_squared(w));
    farthest_squared_ = std::max(farthest_squared_, m * m);
    if (m <= slack_) return;
    const Vec2 u = w / m, side = left_of(u) * (slack_ / m);
    const double c = std::sqrt(1 - slack_ * slack_ / (m * m));
    const Vec2 low = u * c - side, high = u * c + side;
    if (!limited_ || cross(low_, low) > 0) low_ = low;
    if (!limited_ || cross(high_, high) < 0) high_ = high;
    limited_ = true;
  }

 private:
  Vec2 anchor_;
  double slack_;
  bool limited_ = false;
  Vec2 low_, high_;
  double farthest_squared_ = 0;
};

/// Runs of lines within `slack` of one line become that line, by one pass of a narrowing cone. O(edges).
Loop simplified(const Loop& loop, double slack) {
  if (slack <= 0) return loop;
  Loop out;
  out.reserve(loop.size());
  std::size_t i = 0;
  while (i < loop.size()) {
    Edge edge = loop[i++];
    if (!edge.is_arc()) {
      Cone cone(edge.from, slack);
      cone.add(edge.to);
      while (i < loop.size() && !loop[i].is_arc() && cone.accepts(loop[i].to)) {
        edge.to = loop[i++].to;
        cone.add(edge.to);
      }
    }
    out.push_back(edge);
  }
  return out;
}

/// The edge between slightly moved ends; an arc's centre moves along the chord until both ends are equally
/// far.
Edge with_ends(const Edge& edge, Vec2 from, Vec2 to) {
  Edge moved{from, to, edge.center, edge.turn};
  if (!edge.is_arc() || (edge.from == from && edge.to == to)) return moved;
  const double chord_squared = norm_squared(to - from);
  if (chord_squared == 0) return moved;
  const double excess = norm_squared(from - edge.center) - norm_squared(to - edge.center);
  const Vec2 shift = (to - from) * (-excess / (2 * chord_squared));
  if (norm(shift) < 0.01) moved.center = edge.center + shift;
  return moved;
}

/// Points, with the last one, of the polygon circumscribed about the arc's circle that touches the arc at both ends.
/// Unlike chords, the polygon has exact directions at the ends, so a vertex has its true turn, and the polygon's
/// bisectors of a concave arc and its smooth neighbours all meet in the arc's centre.
void append_tangents(const Edge& edge, double error, std::vector<Vec2>& out) {
  if (edge.is_arc()) {
    const double sweep = edge.sweep(), r = edge.radius();
    const double widest = std::min(base::acos(1 / (1 + error / r)), kPi / 6);
    const int count = static_cast<int>(std::ceil(std::abs(sweep) / (2 * widest)));
    const double half = sweep / (2 * count), reach = 1 / base::cos(half);
    const Vec2 u = (edge.from - edge.center) * reach;
    for (int i = 0; i < count; ++i) out.push_back(edge.center + rotated(u, (2 * i + 1) * half));
  }
  out.push_back(edge.to);
}

class Builder {
 public:
  Builder(const Region& region, const SiteErrors& errors, double simplify) : errors_(errors) {
    sites_.grid = grid_for(region);
    sites_.error = errors.usual;
    std::vector<Loop> loops{simplified(region.outer(), simplify)};
    for (const Loop& island : region.islands()) loops.push_back(simplified(island, simplify));
    collect_corners(loops);
    std::size_t edges = 0;
    for (const Loop& loop : loops) edges += loop.size();
    sites_.elements.reserve(sites_.elements.size() + edges);
    sites_.segments.reserve(edges);
    for (const Loop& loop : loops) add_loop(loop);
  }

  Sites run() {
    CLEARCUT_ASSERT(!sites_.segments.empty());
    for (int splits = 0;;) {
      WorkBudget::spend(sites_.segments.size());
      const Contacts contacts = find_contacts(sites_.segments);
      if (contacts.mixed) name_points();
      if (contacts.doubled) merge_doubled();
      if (contacts.places.empty()) break;
      // Places name segments by their numbers, and merging has changed the numbers: the places are searched again.
      if (contacts.doubled) continue;
      CLEARCUT_ASSERT(splits++ < kMostRounds);
      split(contacts.places);
    }
    return std::move(sites_);
  }

 private:
  struct Corner {
    LatticePoint at;
    Vec2 exact;
  };

  /// One point element for each grid point with vertices, at the first vertex found there.
  void collect_corners(const std::vector<Loop>& loops) {
    for (const Loop& loop : loops) {
      for (const Edge& edge : loop) corners_.push_back({sites_.grid.to_grid(edge.from), edge.from});
    }
    std::stable_sort(corners_.begin(), corners_.end(),
                     [](const Corner& a, const Corner& b) { return a.at < b.at; });
    const auto same = [](const Corner& a, const Corner& b) { return a.at == b.at; };
    corners_.erase(std::unique(corners_.begin(), corners_.end(), same), corners_.end());
    for (const Corner& corner : corners_) sites_.elements.push_back(Element::of_point(corner.exact));
  }

  /// Index of the corner at p, also the index of its element; -1 if there is none.
  int corner_at(LatticePoint p) const {
    const auto found = std::lower_bound(corners_.begin(), corners_.end(), p,
                                        [](const Corner& c, LatticePoint q) { return c.at < q; });
    return found != corners_.end() && found->at == p ? static_cast<int>(found - corners_.begin()) : -1;
  }

  int add_element(const Element& element) {
    sites_.elements.push_back(element);
    return static_cast<int>(sites_.elements.size()) - 1;
  }

  void add_loop(const Loop& loop) {
    const std::size_t before = sites_.segments.size();
    for (const Edge& edge : loop) add_edge(edge);
    if (sites_.segments.size() == before) add_speck(sites_.grid.to_grid(loop.front().from));
  }

  void add_edge(const Edge& edge) {
    const int from = corner_at(sites_.grid.to_grid(edge.from)), to = corner_at(sites_.grid.to_grid(edge.to));
    if (from == to && edge.length() < 100 * sites_.grid.unit) return;
    const Edge moved = with_ends(edge, corners_[index(from)].exact, corners_[index(to)].exact);
    const int element = add_element(Element::of_edge(moved));
    sites_.elements.back().end_vertex = to;
    points_.clear();
    append_tangents(moved, errors_.of(element), points_);
    Segment next{corners_[index(from)].at, {}, element, from, element, -1};
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const bool last = i + 1 == points_.size();
      next.to = last ? corners_[index(to)].at : sites_.grid.to_grid(points_[i]);
      next.to_element = last ? to : element;
      if (next.to == next.from) continue;
      sites_.segments.push_back(next);
      next.from = next.to;
      next.from_element = element;
    }
    // The last points of a tiny arc may have been rounded to its end: the end is the vertex nevertheless.
    if (!sites_.segments.empty() && sites_.segments.back().element == element) {
      sites_.segments.back().to_element = to;
    }
  }

  /// A loop within one square of the grid is a point: a wall of one unit, and the whole wall is one element.
  void add_speck(LatticePoint p) {
    const int element = corner_at(p);
    sites_.segments.push_back({p, {p.x + 1, p.y}, element, element, element, element});
  }

  void split(const std::vector<Contact>& places) {
    std::vector<Segment> whole = std::move(sites_.segments);
    sites_.segments.clear();
    auto place = places.begin();
    for (std::size_t i = 0; i < whole.size(); ++i) {
      Segment part = whole[i];
      for (; place != places.end() && index(place->segment) == i; ++place) {
        sites_.met.push_back(part.element);
        if (place->element >= 0) sites_.met.push_back(place->element);
        part.to = place->at;
        part.to_element = place->element >= 0 ? place->element : point_element(place->at);
        sites_.segments.push_back(part);
        part.from = part.to;
        part.from_element = part.to_element;
      }
      part.to = whole[i].to;
      part.to_element = whole[i].to_element;
      sites_.segments.push_back(part);
    }
  }

  int point_element(LatticePoint p) {
    if (const int corner = corner_at(p); corner >= 0) return corner;
    const auto [place, added] = crossings_.try_emplace(p, 0);
    if (added) place->second = add_element(Element::of_point(sites_.grid.to_mm(p)));
    return place->second;
  }

  /// Ends at one grid point represent one element: the vertex there, or else the first named.
  void name_points() {
    std::map<LatticePoint, int> names;
    const auto name = [&](LatticePoint p, int element) {
      const auto [place, added] = names.try_emplace(p, element);
      if (!added && sites_.elements[index(element)].is_point()) place->second = element;
    };
    for (const Segment& s : sites_.segments) {
      name(s.from, s.from_element);
      name(s.to, s.to_element);
    }
    for (Segment& s : sites_.segments) {
      s.from_element = names[s.from];
      s.to_element = names[s.to];
    }
  }

  /// Segments with the same ends become one. If equally many run in both directions, the segment is a wall of no
  /// thickness and keeps both elements; else it keeps the prevailing direction.
  void merge_doubled() {
    std::map<std::pair<LatticePoint, LatticePoint>, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < sites_.segments.size(); ++i) {
      const Segment& s = sites_.segments[i];
      groups[std::minmax(s.from, s.to)].push_back(i);
    }
    std::vector<char> keep(sites_.segments.size(), 1);
    for (const auto& [ends, members] : groups) {
      if (members.size() > 1) merge(members, ends.first, keep);
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < keep.size(); ++i) {
      if (keep[i] != 0) sites_.segments[kept++] = sites_.segments[i];
    }
    sites_.segments.resize(kept);
  }

  void merge(const std::vector<std::size_t>& members, LatticePoint start, std::vector<char>& keep) {
    int balance = 0;
    int forward = -1, backward = -1;
    for (const std::size_t i : members) {
      const Segment& s = sites_.segments[i];
      const bool is_forward = s.from == start;
      sites_.met.push_back(s.element);
      balance += is_forward ? 1 : -1;
      (is_forward ? forward : backward) = static_cast<int>(i);
      if (s.back_element >= 0) balance -= is_forward ? 1 : -1;
      keep[i] = 0;
    }
    const int winner = balance > 0 ? forward : balance < 0 ? backward : static_cast<int>(members.front());
    Segment& s = sites_.segments[index(winner)];
    keep[index(winner)] = 1;
    if (balance != 0) {
      s.back_element = -1;
    } else if (s.back_element < 0) {
      s.back_element = sites_.segments[index(s.from == start ? backward : forward)].element;
    }
  }

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  Sites sites_;
  const SiteErrors& errors_;
  std::vector<Corner> corners_;
  std::map<LatticePoint, int> crossings_;
  std::vector<Vec2> points_;
};

}  // namespace

Sites make_sites(const Region& region, const SiteErrors& errors, double simplify) {
  return Builder(region, errors, simplify).run();
}

namespace {

using std::int64_t;

/// > 0 when p is on the left of a -> b. Coordinates stay under 2^30, so that nothing overflows.
int64_t side(LatticePoint a, LatticePoint b, LatticePoint p) {
  const int64_t dx = int64_t{b.x} - a.x, dy = int64_t{b.y} - a.y;
  return dx * (int64_t{p.y} - a.y) - dy * (int64_t{p.x} - a.x);
}

bool boxes_apart(const Segment& s, const Segment& t) {
  return std::max(s.from.x, s.to.x) < std::min(t.from.x, t.to.x) ||
         std::max(t.from.x, t.to.x) < std::min(s.from.x, s.to.x) ||
         std::max(s.from.y, s.to.y) < std::min(t.from.y, t.to.y) ||
         std::max(t.from.y, t.to.y) < std::min(s.from.y, s.to.y);
}

/// Whether p, on the line of s, is strictly between its ends.
bool inside(const Segment& s, LatticePoint p) {
  if (p == s.from || p == s.to) return false;
  return std::min(s.from.x, s.to.x) <= p.x && p.x <= std::max(s.from.x, s.to.x) &&
         std::min(s.from.y, s.to.y) <= p.y && p.y <= std::max(s.from.y, s.to.y);
}

LatticePoint crossing(const Segment& s, int64_t side_from, int64_t side_to) {
  const double t =
      static_cast<double>(side_from) / (static_cast<double>(side_from) - static_cast<double>(side_to));
  const double x = s.from.x + t * (static_cast<double>(s.to.x) - s.from.x);
  const double y = s.from.y + t * (static_cast<double>(s.to.y) - s.from.y);
  return {static_cast<std::int32_t>(std::lround(x)), static_cast<std::int32_t>(std::lround(y))};
}

class Finder {
 public:
  explicit Finder(std::span<const Segment> segments) : segments_(segments) {}

  Contacts run() {
    size_cells();
    fill_cells();
    for (std::size_t cell = 0; cell < grid_.count(); ++cell) {
      const auto members = members_.at(cell);
      for (std::size_t i = 0; i < members.size(); ++i) {
        for (std::size_t j = i + 1; j < members.size(); ++j)
          test(static_cast<int>(members[i]), static_cast<int>(members[j]));
      }
    }
    sort_found();
    return std::move(found_contacts_);
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  void size_cells() {
    LatticePoint low = segments_[0].from, high = low;
    double total = 0;
    for (const Segment& s : segments_) {
      low = {std::min(low.x, s.from.x), std::min(low.y, s.from.y)};
      high = {std::max(high.x, s.from.x), std::max(high.y, s.from.y)};
      total += base::hypot(double{1} * s.to.x - s.from.x, double{1} * s.to.y - s.from.y);
    }
    const double width = double{1} * high.x - low.x, height = double{1} * high.y - low.y;
    const double n = static_cast<double>(segments_.size());
    const double size = std::max({1.0, std::sqrt(width * height / n), total / n / 2});
    const Vec2 corner{double{1} * low.x, double{1} * low.y};
    grid_ = CellGrid({corner, corner + Vec2{width, height}}, size);
  }

  /// Calls visit(cell) for all cells within one grid unit of the segment.
  template <class Visit>
  void visit_cells(const Segment& s, Visit visit) const {
    const LatticePoint a = std::min(s.from, s.to), b = std::max(s.from, s.to);
    const double y_low = std::min(a.y, b.y) - 1.0, y_high = std::max(a.y, b.y) + 1.0;
    const std::size_t last_row = grid_.row(y_high);
    for (std::size_t r = grid_.row(y_low); r <= last_row; ++r) {
      double x0 = a.x, x1 = b.x;
      if (a.y != b.y) {
        const double slope = (double{1} * b.x - a.x) / (double{1} * b.y - a.y);
        const double at_bottom = a.x + slope * (grid_.box.min.y + static_cast<double>(r) * grid_.cell - a.y);
        const double at_top = at_bottom + slope * grid_.cell;
        x0 = std::max(x0, std::min(at_bottom, at_top));
        x1 = std::min(x1, std::max(at_bottom, at_top));
      }
      const double pad = 2.0;
      const std::size_t last = grid_.column(std::max(x0, x1) + pad);
      for (std::size_t c = grid_.column(std::min(x0, x1) - pad); c <= last; ++c) visit(r * grid_.columns + c);
    }
  }

  void fill_cells() {
    for (std::size_t i = 0; i < segments_.size(); ++i)
      visit_cells(segments_[i], [&](std::size_t cell) { members_.add(cell, static_cast<std::uint32_t>(i)); });
    members_.build(grid_.count());
  }

  void compare_ends(const Segment& s, const Segment& t) {
    const auto mixed = [](LatticePoint p, int e, LatticePoint q, int f) { return p == q && e != f; };
    if (mixed(s.from, s.from_element, t.from, t.from_element) ||
        mixed(s.from, s.from_element, t.to, t.to_element) ||
        mixed(s.to, s.to_element, t.from, t.from_element) || mixed(s.to, s.to_element, t.to, t.to_element)) {
      found_contacts_.mixed = true;
    }
    if ((s.from == t.from && s.to == t.to) || (s.from == t.to && s.to == t.from))
      found_contacts_.doubled = true;
  }

  void touch(int segment, LatticePoint p, int64_t side_of_p, int element) {
    if (side_of_p == 0 && inside(segments_[at(segment)], p)) found_.push_back({segment, p, element});
  }

  void test(int i, int j) {
    const Segment &s = segments_[at(i)], &t = segments_[at(j)];
    if (boxes_apart(s, t)) return;
    compare_ends(s, t);
    const int64_t t0 = side(s.from, s.to, t.from), t1 = side(s.from, s.to, t.to);
    if ((t0 > 0 && t1 > 0) || (t0 < 0 && t1 < 0)) return;
    const int64_t s0 = side(t.from, t.to, s.from), s1 = side(t.from, t.to, s.to);
    touch(i, t.from, t0, t.from_element);
    touch(i, t.to, t1, t.to_element);
    touch(j, s.from, s0, s.from_element);
    touch(j, s.to, s1, s.to_element);
    if ((t0 > 0) == (t1 > 0) || t0 == 0 || t1 == 0 || (s0 > 0) == (s1 > 0) || s0 == 0 || s1 == 0) return;
    const LatticePoint p = crossing(s, s0, s1);
    if (p != s.from && p != s.to) found_.push_back({i, p, -1});
    if (p != t.from && p != t.to) found_.push_back({j, p, -1});
  }

  void sort_found() {
    const auto key = [this](const Contact& c) {
      const Segment& s = segments_[at(c.segment)];
      const int64_t along = (int64_t{c.at.x} - s.from.x) * (int64_t{s.to.x} - s.from.x) +
                            (int64_t{c.at.y} - s.from.y) * (int64_t{s.to.y} - s.from.y);
      return std::tuple(c.segment, along, c.at, -c.element);
    };
    std::sort(found_.begin(), found_.end(),
              [&](const Contact& a, const Contact& b) { return key(a) < key(b); });
    const auto same = [](const Contact& a, const Contact& b) {
      return a.segment == b.segment && a.at == b.at;
    };
    found_.erase(std::unique(found_.begin(), found_.end(), same), found_.end());
  }

  std::span<const Segment> segments_;
  Contacts found_contacts_;
  std::vector<Contact>& found_ = found_contacts_.places;
  CellGrid grid_;
  CellLists members_;
};

}  // namespace

Contacts find_contacts(std::span<const Segment> segments) {
  if (segments.size() < 2) return {};
  return Finder(segments).run();
}

}  // namespace clearcut::inline geometry::voronoi
