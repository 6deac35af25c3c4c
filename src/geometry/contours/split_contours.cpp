#include "geometry/contours/split_contours.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

namespace clearcut::inline geometry {
namespace {

using ClipperLib::cInt;
using ClipperLib::IntPoint;
using ClipperLib::Path;

struct GridBox {
  IntPoint min, max;
};

GridBox box_of(const Path& path) {
  GridBox box{path.front(), path.front()};
  for (const IntPoint& p : path) {
    box.min = {std::min(box.min.X, p.X), std::min(box.min.Y, p.Y)};
    box.max = {std::max(box.max.X, p.X), std::max(box.max.Y, p.Y)};
  }
  return box;
}

bool contains(const GridBox& outer, const GridBox& inner) {
  return outer.min.X <= inner.min.X && outer.min.Y <= inner.min.Y && inner.max.X <= outer.max.X &&
         inner.max.Y <= outer.max.Y;
}

/// Whether `inner`, which does not cross `outer`, lies in it.
bool lies_in(const Path& inner, const Path& outer) {
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const IntPoint &p = inner[i], &q = inner[(i + 1) % inner.size()];
    for (const IntPoint& at : {p, IntPoint((p.X + q.X) / 2, (p.Y + q.Y) / 2)}) {
      const int side = ClipperLib::PointInPolygon(at, outer);
      if (side >= 0) return side > 0;  // -1: on the contour
    }
  }
  return true;
}

/// Cuts off a loop whenever the walk along the contour comes back to a point.
void append_loops(const Path& contour, ClipperLib::Paths& loops) {
  std::map<std::pair<cInt, cInt>, std::size_t> places;
  Path walked;
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

}  // namespace

std::vector<SplitContour> split_contours(const ClipperLib::PolyTree& tree) {
  ClipperLib::Paths loops;
  for (const auto* node = tree.GetFirst(); node; node = node->GetNext()) append_loops(node->Contour, loops);
  std::vector<SplitContour> out;
  std::vector<GridBox> boxes;
  std::vector<double> areas;
  for (Path& loop : loops) {
    if (ClipperLib::Area(loop) <= 0) continue;
    boxes.push_back(box_of(loop));
    areas.push_back(ClipperLib::Area(loop));
    out.push_back({std::move(loop), {}});
  }
  for (Path& loop : loops) {
    if (loop.empty() || ClipperLib::Area(loop) >= 0) continue;
    const GridBox box = box_of(loop);
    std::size_t around = out.size();
    for (std::size_t i = 0; i < out.size(); ++i) {
      const bool smaller = around == out.size() || areas[i] < areas[around];
      if (smaller && contains(boxes[i], box) && lies_in(loop, out[i].contour)) around = i;
    }
    if (around < out.size()) out[around].holes.push_back(std::move(loop));
  }
  return out;
}

}  // namespace clearcut::inline geometry
