#include "geometry/contours/nesting.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <utility>

namespace clearcut::inline geometry {
namespace {

using ClipperLib::IntPoint;

Vec2 place_of(const IntPoint& p) {
  return {static_cast<double>(p.X), static_cast<double>(p.Y)};
}

Box box_of(const ClipperLib::Path& contour) {
  Box box;
  for (const IntPoint& p : contour) box.add(place_of(p));
  return box;
}

/// Whether `inner` is inside `outer`; the two must not cross.
bool lies_in(const ClipperLib::Path& inner, const ClipperLib::Path& outer) {
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const IntPoint &p = inner[i], &q = inner[(i + 1) % inner.size()];
    for (const IntPoint& at : {p, IntPoint((p.X + q.X) / 2, (p.Y + q.Y) / 2)}) {
      const int side = ClipperLib::PointInPolygon(at, outer);
      if (side >= 0) return side > 0;  // -1: on the contour
    }
  }
  return true;
}

/// Crossings of one contour with a ray from a point towards greater x.
class Ray {
 public:
  explicit Ray(Vec2 from) : from_(from) {}

  void meet(Vec2 a, Vec2 b) {
    const double turn = cross(a - from_, b - from_);
    const bool spans = std::min(a.y, b.y) <= from_.y && from_.y <= std::max(a.y, b.y) &&
                       std::min(a.x, b.x) <= from_.x && from_.x <= std::max(a.x, b.x);
    if (turn == 0 && spans) starts_on_it_ = true;
    // Ends at the height of the ray count as below it.
    if ((a.y > from_.y) != (b.y > from_.y) && (turn > 0) == (b.y > a.y)) crosses_ = !crosses_;
  }

  bool starts_on_it() const { return starts_on_it_; }
  bool starts_inside() const { return crosses_; }

 private:
  Vec2 from_;
  bool starts_on_it_ = false, crosses_ = false;
};

}  // namespace

ContourIndex::ContourIndex(const ClipperLib::Paths& contours) : contours_(contours) {
  std::size_t count = 0;
  for (const ClipperLib::Path& contour : contours) {
    areas_.push_back(ClipperLib::Area(contour));
    boxes_.push_back(box_of(contour));
    first_edge_.push_back(count);
    count += contour.size();
  }
  std::size_t contour = 0, edge = 0;
  edges_.build(static_cast<std::uint32_t>(count), [&](std::uint32_t) {
    while (edge == contours_[contour].size()) {
      ++contour;
      edge = 0;
    }
    const ClipperLib::Path& path = contours_[contour];
    Box box;
    box.add(place_of(path[edge]));
    box.add(place_of(path[(edge + 1) % path.size()]));
    ++edge;
    return box;
  });
}

std::size_t ContourIndex::contour_of(std::size_t edge) const {
  return static_cast<std::size_t>(std::upper_bound(first_edge_.begin(), first_edge_.end(), edge) -
                                  first_edge_.begin()) -
         1;
}

template <typename Visit>
void ContourIndex::visit_around(const IntPoint& p, Visit&& visit) const {
  const Vec2 from = place_of(p);
  std::optional<std::size_t> contour;
  Ray ray(from);
  const auto tell = [&] {
    if (contour && (ray.starts_on_it() || ray.starts_inside())) visit(*contour, ray.starts_on_it());
  };
  edges_.descend(
      [&](const Box& box) { return box.min.y <= from.y && from.y <= box.max.y && from.x <= box.max.x; },
      [&](std::uint32_t edge) {
        const std::size_t own = contour && edge < first_edge_[*contour] + contours_[*contour].size()
                                    ? *contour
                                    : contour_of(edge);
        if (contour != own) {
          tell();
          contour = own;
          ray = Ray(from);
        }
        const ClipperLib::Path& path = contours_[own];
        const std::size_t at = edge - first_edge_[own];
        ray.meet(place_of(path[at]), place_of(path[(at + 1) % path.size()]));
      });
  tell();
}

std::optional<std::size_t> ContourIndex::smallest_around(const ClipperLib::Path& inner,
                                                         std::size_t member) const {
  const double own = member < areas_.size() ? areas_[member] : ClipperLib::Area(inner);
  const Box own_box = box_of(inner);
  std::optional<std::size_t> smallest;
  const auto look_from = [&](const IntPoint& p) {
    visit_around(p, [&](std::size_t outer, bool starts_on_it) {
      const double area = std::abs(areas_[outer]);
      const bool turns_otherwise = (areas_[outer] > 0) != (own > 0);
      const bool may_contain = turns_otherwise && (member == areas_.size() || area > std::abs(own));
      // A point of a shared edge may be rounded into the contour beside it.
      const Box around = boxes_[outer].grown(kGridRounding);
      const bool holds_box = around.contains(own_box.min) && around.contains(own_box.max);
      if (!may_contain || !holds_box || (smallest && area >= std::abs(areas_[*smallest]))) return;
      if (!starts_on_it || lies_in(inner, contours_[outer])) smallest = outer;
    });
  };
  look_from(inner.front());
  // A hole always has a contour around it, but the points of a wall that both share may be rounded out of it.
  for (std::size_t i = 0; own < 0 && !smallest && i < inner.size(); ++i) {
    const IntPoint &a = inner[i], &b = inner[(i + 1) % inner.size()];
    look_from(IntPoint((a.X + b.X) / 2, (a.Y + b.Y) / 2));
    if (!smallest) look_from(b);
  }
  return smallest;
}

std::optional<std::size_t> ContourIndex::smallest_around(std::size_t member) const {
  return smallest_around(contours_[member], member);
}

std::optional<std::size_t> ContourIndex::smallest_around(const ClipperLib::Path& inner) const {
  return smallest_around(inner, areas_.size());
}

std::vector<std::optional<std::size_t>> contours_around(const ClipperLib::Paths& contours) {
  std::vector<std::optional<std::size_t>> around(contours.size());
  if (contours.size() < 2) return around;
  const ContourIndex index(contours);
  for (std::size_t i = 0; i < contours.size(); ++i) around[i] = index.smallest_around(i);
  return around;
}

namespace {

using ClipperLib::cInt;
using ClipperLib::IntPoint;

/// Cuts off a loop whenever the walk along the contour returns to a point.
void append_loops(const ClipperLib::Path& contour, ClipperLib::Paths& loops) {
  std::map<std::pair<cInt, cInt>, std::size_t> places;
  ClipperLib::Path walked;
  for (const IntPoint& p : contour) {
    const auto [place, is_new] = places.try_emplace({p.X, p.Y}, walked.size());
    if (is_new) {
      walked.push_back(p);
      continue;
    }
    const auto first = walked.begin() + static_cast<std::ptrdiff_t>(place->second);
    if (walked.end() - first > 2) loops.emplace_back(first, walked.end());
    for (auto after = first + 1; after != walked.end(); ++after) places.erase({after->X, after->Y});
    walked.erase(first + 1, walked.end());
  }
  if (walked.size() > 2) loops.push_back(std::move(walked));
}

/// Contours sorted by the contour around them.
class Nesting {
 public:
  explicit Nesting(const ClipperLib::Paths& contours) : inside_(contours.size()) {
    const auto around = contours_around(contours);
    for (std::size_t i = 0; i < contours.size(); ++i)
      (around[i] ? inside_[*around[i]] : outermost_).push_back(i);
  }

  const std::vector<std::size_t>& outermost() const { return outermost_; }
  /// The contours directly inside a contour.
  const std::vector<std::size_t>& inside(std::size_t contour) const { return inside_[contour]; }

 private:
  std::vector<std::size_t> outermost_;
  std::vector<std::vector<std::size_t>> inside_;
};

/// Every contour before the contours inside it.
ClipperLib::Paths from_outside_in(const ClipperLib::Paths& contours) {
  const Nesting nesting(contours);
  ClipperLib::Paths sorted;
  const std::function<void(std::size_t)> append = [&](std::size_t i) {
    sorted.push_back(contours[i]);
    for (const std::size_t inner : nesting.inside(i)) append(inner);
  };
  for (const std::size_t i : nesting.outermost()) append(i);
  return sorted;
}

}  // namespace

std::vector<NestedContour> nested_contours(const ClipperLib::Paths& contours) {
  const Nesting nesting(contours);
  std::vector<NestedContour> out;
  const std::function<void(std::size_t)> append = [&](std::size_t outer) {
    NestedContour nested{contours[outer], {}};
    for (const std::size_t hole : nesting.inside(outer)) {
      nested.holes.push_back(contours[hole]);
      for (const std::size_t inner : nesting.inside(hole)) append(inner);
    }
    out.push_back(std::move(nested));
  };
  for (const std::size_t outer : nesting.outermost()) append(outer);
  return out;
}

std::vector<NestedContour> split_contours(const ClipperLib::Paths& contours) {
  ClipperLib::Paths loops, outers, holes;
  for (const ClipperLib::Path& contour : from_outside_in(contours)) append_loops(contour, loops);
  for (ClipperLib::Path& loop : loops) {
    const double area = ClipperLib::Area(loop);
    if (area != 0) (area > 0 ? outers : holes).push_back(std::move(loop));
  }
  std::vector<NestedContour> out;
  for (const ClipperLib::Path& outer : outers) out.push_back({outer, {}});
  const ContourIndex index(outers);
  for (ClipperLib::Path& hole : holes)
    if (const auto around = index.smallest_around(hole)) out[*around].holes.push_back(std::move(hole));
  return out;
}

}  // namespace clearcut::inline geometry
