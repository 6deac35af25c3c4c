#include "geometry/voronoi/contacts.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/elementary.h"
#include "geometry/spatial/cell_grid.h"

namespace clearcut::inline geometry::voronoi {
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
