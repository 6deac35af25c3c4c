#include "geometry/contours/mitred_inset.h"

#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>

#include "base/error.h"
#include "geometry/contours/boolean.h"

namespace clearcut::inline geometry {
namespace {

constexpr double kNmPerMm = 1e6;
/// Greatest distance of a mitred corner from its source corner, as a multiple of the inset distance.
constexpr double kMiterLimit = 1200;
/// nm. Corners of a result nearer to each other than this are one corner.
constexpr double kOnePlace = 2;

ClipperLib::Path path_of(const Loop& loop) {
  ClipperLib::Path path;
  for (const Edge& edge : loop) {
    path.emplace_back(static_cast<ClipperLib::cInt>(std::llround(edge.from.x * kNmPerMm)),
                      static_cast<ClipperLib::cInt>(std::llround(edge.from.y * kNmPerMm)));
  }
  return path;
}

Loop loop_of_path(const ClipperLib::Path& path) {
  Loop loop;
  const auto point = [&](std::size_t i) {
    const ClipperLib::IntPoint& p = path[i % path.size()];
    return Vec2{static_cast<double>(p.X) / kNmPerMm, static_cast<double>(p.Y) / kNmPerMm};
  };
  for (std::size_t i = 0; i < path.size(); ++i) loop.push_back(Edge::line(point(i), point(i + 1)));
  return loop;
}

}  // namespace

bool has_arcs(const Region& region) {
  const auto edges = region.edges();
  return std::any_of(edges.begin(), edges.end(), [](const Edge& edge) { return edge.is_arc(); });
}

bool has_reflex_corner(const Region& region) {
  constexpr double kTurn = 1e-6;  // sine of the angle
  const auto turns_right = [&](const Loop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Edge& before = i == 0 ? loop.back() : loop[i - 1];
      if (cross(before.tangent_at(1), loop[i].tangent_at(0)) < -kTurn) return true;
    }
    return false;
  };
  return turns_right(region.outer()) ||
         std::any_of(region.islands().begin(), region.islands().end(), turns_right);
}

Regions mitred_inset(const Region& region, double distance, const Tolerances& tol) {
  CLEARCUT_ASSERT(distance > 0 && !has_arcs(region));
  ClipperLib::ClipperOffset offset(kMiterLimit);
  offset.AddPath(path_of(region.outer()), ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
  for (const Loop& island : region.islands())
    offset.AddPath(path_of(island), ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
  ClipperLib::Paths moved;
  offset.Execute(moved, -distance * kNmPerMm);
  ClipperLib::CleanPolygons(moved, kOnePlace);
  std::vector<Loop> loops;
  for (const ClipperLib::Path& path : moved)
    if (path.size() >= 3) loops.push_back(loop_of_path(path));
  return loops.empty() ? Regions{} : resolve_even_odd(loops, tol);
}

}  // namespace clearcut::inline geometry
