// Every upward face as an area in plan view.
#include "read/step_solid/height_map.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "geometry/contours/boolean.h"
#include "geometry/region.h"
#include "geometry/spatial/cell_grid.h"
#include "model/part.h"
#include "read/repair/repair.h"
#include "read/step_solid/floor_sweep.h"

namespace clearcut::read {
namespace {

/// mm. Shadows with a smaller mean thickness belong to faces that are vertical except for rounding.
constexpr double kThinnestShadow = 0.004;

/// One common point for all points within kSamePlace.
class Places {
 public:
  Vec2 of(Vec2 p) {
    for (const std::uint32_t i : index_.near(p)) {
      if (distance(points_[i], p) < kSamePlace) return points_[i];
    }
    index_.add(p, static_cast<std::uint32_t>(points_.size()));
    points_.push_back(p);
    return p;
  }

 private:
  BoxIndex index_{kSamePlace};
  std::vector<Vec2> points_;
};

/// Points beside the middles of a few edges, well inside.
std::vector<Vec2> points_inside(const Regions& regions) {
  constexpr std::size_t kEnough = 8;
  std::vector<Vec2> points;
  for (const double away : {0.5, 0.05, 0.005}) {
    for (const Region& region : regions) {
      for (const Edge& edge : region.edges()) {
        if (points.size() == kEnough) return points;
        const Vec2 p = edge.at(0.5) + left_of(edge.tangent_at(0.5)) * away;
        if (region.contains(p) && region.boundary_distance(p) > away / 2) points.push_back(p);
      }
    }
    if (!points.empty()) break;
  }
  return points;
}

bool is_disc(const Regions& regions) {
  if (regions.size() != 1 || !regions[0].islands().empty()) return false;
  const Loop& loop = regions[0].outer();
  return std::all_of(loop.begin(), loop.end(), [&](const Edge& edge) {
    return edge.is_arc() && distance(edge.center, loop[0].center) < kSamePlace;
  });
}

std::vector<Path> snapped(const std::vector<Path>& outline, Places& places) {
  std::vector<Path> curves;
  for (const Path& path : outline) {
    Path out;
    for (Edge edge : path) {
      edge.from = places.of(edge.from);
      edge.to = places.of(edge.to);
      if (edge.from != edge.to) out.push_back(edge);
    }
    if (!out.empty()) curves.push_back(std::move(out));
  }
  return curves;
}

std::vector<const Path*> pointers(const std::vector<Path>& paths) {
  std::vector<const Path*> out;
  for (const Path& path : paths) out.push_back(&path);
  return out;
}

/// The kernel's boxes of curved faces may be wider than the solid, and there is no material outside the solid.
Box within(const Box& box, const Box& solid) {
  return {{std::max(box.min.x, solid.min.x), std::max(box.min.y, solid.min.y)},
          {std::min(box.max.x, solid.max.x), std::min(box.max.y, solid.max.y)}};
}

bool is_sliver(const Region& region) {
  return 2 * region.area() < kThinnestShadow * length(region.outer());
}

/// Whether higher floors cover the whole shadow, as the top of a plate covers the bores through its sides.
bool is_covered(const Cell& shadow, const std::vector<Cell>& cells, const Tolerances& tol) {
  Regions rest = shadow.area;
  for (const Cell& cell : cells) {
    if (cell.floor && cell.z >= shadow.z && !rest.empty() && box(cell.area).overlaps(box(rest)))
      rest = subtract(rest, cell.area, tol);
  }
  return std::all_of(rest.begin(), rest.end(), is_sliver);
}

/// The area covered by a partly upward face; its box if the kernel gave no shadow. Slivers of vertical parts are
/// rounding.
void cover_mixed(Cell& cell, const SolidFace& face, const Box& solid, const Tolerances& tol) {
  if (face.outline.empty()) {
    cell.area = {rectangular_region(within(face.plan, solid))};
  } else {
    cell.area = unite_loops(face.outline, tol);
    std::erase_if(cell.area, is_sliver);
  }
  for (const Loop& loop : loops_of(cell.area)) cell.curves.push_back(loop);
}

/// Wholly upward faces are bounded by their edges in plan view.
Cell cell_of(const SolidFace& face, const Box& solid, Places& places, const RepairOptions& how,
             Diagnostics& mends) {
  Cell cell;
  cell.face = face.number - 1;
  cell.z = face.z_high;
  if (face.facing == Facing::kMixed) {
    cover_mixed(cell, face, solid, how.tol);
    cell.inside = points_inside(cell.area);
    return cell;
  }
  // A seam is present in both directions.
  const std::vector<Path> all = snapped(face.outline, places);
  for (const std::size_t i : unpaired(pointers(all))) cell.curves.push_back(all[i]);
  if (!cell.curves.empty()) cell.area = repair(chained(cell.curves, how.where), how, mends);
  cell.inside = points_inside(cell.area);
  const bool ends_hole = face.surface == "cone" && is_disc(cell.area);
  cell.floor = !cell.area.empty() && (face.level || ends_hole);
  return cell;
}

}  // namespace

HeightMap::HeightMap(const SolidModel& solid, const std::string& file_name, const Tolerances& tol)
    : reach_(solid.plan.grown(kOpenReach)) {
  Places places;
  RepairOptions how;
  how.tol = tol;
  how.may_be_empty = true;
  for (const SolidFace& face : solid.faces) {
    if (face.facing != Facing::kUp && face.facing != Facing::kMixed) continue;
    how.where = file_name + ": face " + std::to_string(face.number);
    Cell cell = cell_of(face, solid.plan, places, how, mends_);
    if (!cell.curves.empty()) cells_.push_back(std::move(cell));
  }
  const auto is_hidden = [&](const Cell& cell) {
    return solid.faces[static_cast<std::size_t>(cell.face)].facing == Facing::kMixed &&
           is_covered(cell, cells_, tol);
  };
  std::vector<Cell> seen;
  std::copy_if(cells_.begin(), cells_.end(), std::back_inserter(seen), std::not_fn(is_hidden));
  cells_ = std::move(seen);
}

}  // namespace clearcut::read
