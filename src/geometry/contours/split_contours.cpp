#include "geometry/contours/split_contours.h"

#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "geometry/contours/contour_index.h"

namespace clearcut::inline geometry {
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
