// The area that stands above z is the union of the faces that look up from above z. Faces of a solid that
// can be milled from above do not overlap in plan view, so that the union's boundary is made of the faces'
// own edges: those shared by two of them vanish in pairs. Where that does not give the faces' total area
// (undercuts, edges shared in part) the faces are united by polyclipping.
#include "read/step_solid/height_map.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "geometry/boolean.h"
#include "model/part.h"
#include "read/repair/near_grid.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

/// mm. Ends of edges of different faces nearer than this are one point.
constexpr double kSamePlace = 1e-4;

/// One point for all that lie within kSamePlace of it.
class Places {
 public:
  Vec2 of(Vec2 p) {
    int found = -1;
    grid_.for_near(p, [&](int i) {
      if (found < 0 && distance(points_[static_cast<std::size_t>(i)], p) < kSamePlace) found = i;
    });
    if (found >= 0) return points_[static_cast<std::size_t>(found)];
    grid_.add(p, static_cast<int>(points_.size()));
    points_.push_back(p);
    return p;
  }

 private:
  NearGrid grid_{kSamePlace};
  std::vector<Vec2> points_;
};

struct ByPlace {
  bool operator()(Vec2 a, Vec2 b) const { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};

Vec2 middle_of(const Path& path) {
  const Edge& edge = path[path.size() / 2];
  return path.size() % 2 ? edge.at(0.5) : edge.from;
}

bool is_reverse(const Path& a, const Path& b) {
  return a.front().from == b.back().to && a.back().to == b.front().from &&
         distance(middle_of(a), middle_of(b)) < 10 * kSamePlace;
}

/// The curves without those that are there both ways.
std::vector<Path> without_pairs(const std::vector<const Path*>& curves) {
  std::map<Vec2, std::vector<std::size_t>, ByPlace> starting;
  std::vector<bool> gone(curves.size(), false);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    auto& candidates = starting[curves[i]->back().to];
    const auto mate = std::find_if(candidates.begin(), candidates.end(), [&](std::size_t j) {
      return !gone[j] && is_reverse(*curves[i], *curves[j]);
    });
    if (mate == candidates.end()) {
      starting[curves[i]->front().from].push_back(i);
    } else {
      gone[i] = gone[*mate] = true;
    }
  }
  std::vector<Path> left;
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (!gone[i]) left.push_back(*curves[i]);
  return left;
}

/// Joins curves end to start into closed ones as far as they go; the repair sees to the rest.
std::vector<RawCurve> chained(const std::vector<Path>& curves, const std::string& source) {
  std::map<Vec2, std::vector<std::size_t>, ByPlace> starting;
  for (std::size_t i = curves.size(); i-- > 0;) starting[curves[i].front().from].push_back(i);
  std::vector<bool> used(curves.size(), false);
  std::vector<RawCurve> loops;
  for (std::size_t first = 0; first < curves.size(); ++first) {
    if (used[first]) continue;
    RawCurve loop;
    loop.source = source;
    for (std::size_t at = first;;) {
      used[at] = true;
      loop.edges.insert(loop.edges.end(), curves[at].begin(), curves[at].end());
      if (loop.edges.back().to == loop.edges.front().from) break;
      auto& next = starting[loop.edges.back().to];
      while (!next.empty() && used[next.back()]) next.pop_back();
      if (next.empty()) break;
      at = next.back();
    }
    loop.closed = loop.edges.back().to == loop.edges.front().from;
    loops.push_back(std::move(loop));
  }
  return loops;
}

Loop box_loop(const Box& box) {
  const Vec2 corners[] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  return loop_from_points(corners);
}

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

/// Only faces that look up all over are bounded by their edges in plan view; others get their box.
Cell cell_of(const SolidFace& face, Places& places, const RepairOptions& how, Diagnostics& mends) {
  Cell cell;
  cell.face = face.number - 1;
  cell.z = face.z_high;
  if (face.facing == Facing::kMixed) {
    cell.curves = {box_loop(face.plan)};
  } else {
    // A seam is there both ways.
    const std::vector<Path> all = snapped(face.outline, places);
    cell.curves = without_pairs(pointers(all));
  }
  if (!cell.curves.empty()) cell.area = repair(chained(cell.curves, how.where), how, mends);
  cell.inside = points_inside(cell.area);
  cell.floor = face.level || (face.surface == "cone" && is_disc(cell.area));
  return cell;
}

}  // namespace

HeightMap::HeightMap(const SolidModel& solid, const std::string& file_name, const Tolerances& tol)
    : tol_(tol), reach_(solid.plan.grown(kOpenReach)) {
  Places places;
  RepairOptions how;
  how.tol = tol;
  for (const SolidFace& face : solid.faces) {
    if (face.facing != Facing::kUp && face.facing != Facing::kMixed) continue;
    how.where = file_name + ": face " + std::to_string(face.number);
    Cell cell = cell_of(face, places, how, mends_);
    if (!cell.area.empty()) cells_.push_back(std::move(cell));
  }
}

double HeightMap::standing_area(double z) const {
  double sum = 0;
  for (const Cell& cell : cells_)
    if (cell.z > z + kSameHeight) sum += area(cell.area);
  return sum;
}

Regions HeightMap::exact_free_at(double z) const {
  std::vector<const Path*> curves;
  for (const Cell& cell : cells_) {
    if (cell.z <= z + kSameHeight) continue;
    for (const Path& path : cell.curves) curves.push_back(&path);
  }
  std::vector<RawCurve> loops = chained(without_pairs(curves), "the solid");
  loops.push_back({box_loop(reach_), true, "the surroundings"});
  RepairOptions how;
  how.tol = tol_;
  how.where = "the solid at z " + std::to_string(z);
  Diagnostics unused;
  return repair(std::move(loops), how, unused);
}

Regions HeightMap::overlaid_free_at(double z) const {
  std::vector<Loop> loops;
  for (const Cell& cell : cells_) {
    if (cell.z <= z + kSameHeight) continue;
    for (const Region& region : cell.area) {
      loops.push_back(region.outer());
      loops.insert(loops.end(), region.islands().begin(), region.islands().end());
    }
  }
  const Regions around{Region::from_valid_loops(box_loop(reach_), {})};
  return loops.empty() ? around : subtract(around, resolve_nonzero(loops, tol_), tol_);
}

Regions HeightMap::free_at(double z) const {
  const double whole = reach_.width() * reach_.height();
  const double expected = whole - standing_area(z);
  try {
    Regions free = exact_free_at(z);
    if (std::abs(area(free) - expected) < 1e-3 + 1e-9 * whole) return free;
  } catch (const InputError&) {
    // Its edges do not close by themselves: overlaid instead.
  }
  return overlaid_free_at(z);
}

}  // namespace clearcut::read
