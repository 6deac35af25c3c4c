// The area of material above z is the union of the upward faces above z. Faces of a solid that can be milled from
// above do not overlap in plan view, so that the union's boundary consists of the faces' own edges: edges shared by
// two faces cancel in pairs. If this does not give the faces' total area (undercuts, partly shared edges) the faces
// are united by polyclipping: neighbours first, because its time grows with the square of the input given at once.
#include "read/step_solid/floor_sweep.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "geometry/contours/boolean.h"
#include "geometry/rectangle.h"
#include "geometry/unite_all.h"
#include "read/repair/repair.h"
#include "read/step_solid/face_curves.h"

namespace clearcut::read {
namespace {

/// mm2. Faces overlap by more than rounding.
constexpr double kOverlap = 0.1;

Regions united(Regions a, const Regions& b, const Tolerances& tol) {
  const bool apart = a.empty() || b.empty() || !box(a).grown(tol.chord).overlaps(box(b));
  a.insert(a.end(), b.begin(), b.end());
  return apart ? a : unite_all(a, tol);
}

/// All cells of the span, halved along their greatest extent.
Regions united_cells(const std::vector<Cell>& cells, std::vector<int>::iterator first,
                     std::vector<int>::iterator last, const Tolerances& tol) {
  if (first == last) return {};
  const auto cell = [&](int i) -> const Cell& { return cells[static_cast<std::size_t>(i)]; };
  if (last - first == 1) return cell(*first).area;
  Box centers;
  for (auto at = first; at != last; ++at) centers.add(box(cell(*at).area).center());
  const bool along_x = centers.width() > centers.height();
  const auto middle = first + (last - first) / 2;
  std::nth_element(first, middle, last, [&](int a, int b) {
    const Vec2 p = box(cell(a).area).center(), q = box(cell(b).area).center();
    const double u = along_x ? p.x : p.y, v = along_x ? q.x : q.y;
    return u != v ? u < v : a < b;
  });
  Regions low = united_cells(cells, first, middle, tol);
  return united(std::move(low), united_cells(cells, middle, last, tol), tol);
}

}  // namespace

FloorSweep::FloorSweep(const HeightMap& map, const Tolerances& tol)
    : map_(map), tol_(tol), highest_first_(map.cells().size()) {
  std::iota(highest_first_.begin(), highest_first_.end(), 0);
  const auto z = [&](int i) { return map_.cells()[static_cast<std::size_t>(i)].z; };
  std::stable_sort(highest_first_.begin(), highest_first_.end(), [&](int a, int b) { return z(a) > z(b); });
  std::size_t curves = 0;
  for (const Cell& cell : map_.cells()) {
    first_curve_.push_back(curves);
    curves += cell.curves.size();
  }
}

/// Cells above z not above the last level.
std::vector<int> FloorSweep::take_above(double z) {
  std::vector<int> fresh;
  while (taken_ < highest_first_.size()) {
    const int index = highest_first_[taken_];
    const Cell& cell = map_.cells()[static_cast<std::size_t>(index)];
    if (cell.z <= z + kSameHeight) break;
    sum_of_areas_ += area(cell.area);
    fresh.push_back(index);
    ++taken_;
  }
  return fresh;
}

void FloorSweep::add_curves(const std::vector<int>& cells) {
  for (const int index : cells) {
    const auto cell = static_cast<std::size_t>(index);
    const auto& curves = map_.cells()[cell].curves;
    for (std::size_t i = 0; i < curves.size(); ++i) boundary_.push_back({first_curve_[cell] + i, &curves[i]});
  }
  std::sort(boundary_.begin(), boundary_.end(),
            [](const Curve& a, const Curve& b) { return a.order < b.order; });
  std::vector<const Path*> paths;
  for (const Curve& curve : boundary_) paths.push_back(curve.path);
  std::vector<Curve> left;
  for (const std::size_t i : unpaired(paths)) left.push_back(boundary_[i]);
  boundary_ = std::move(left);
}

Regions FloorSweep::exact_free(double z) const {
  std::vector<Path> paths;
  for (const Curve& curve : boundary_) paths.push_back(*curve.path);
  std::vector<RawCurve> loops = chained(paths, "the solid");
  loops.push_back({rectangle(map_.reach()), true, "the surroundings"});
  RepairOptions how;
  how.tol = tol_;
  how.where = "the solid at z " + std::to_string(z);
  Diagnostics unused;
  return repair(std::move(loops), how, unused);
}

/// mm2; excess of the faces' areas over the material's area.
double FloorSweep::excess(const Regions& free) const {
  return sum_of_areas_ - (map_.reach().width() * map_.reach().height() - area(free));
}

/// Unites the cells taken since the last call; the area around them is free.
Regions FloorSweep::overlaid_free() {
  std::vector<int> fresh;
  std::copy_if(highest_first_.begin() + static_cast<std::ptrdiff_t>(united_),
               highest_first_.begin() + static_cast<std::ptrdiff_t>(taken_), std::back_inserter(fresh),
               [&](int i) { return !map_.cells()[static_cast<std::size_t>(i)].area.empty(); });
  united_ = taken_;
  if (!fresh.empty())
    standing_ =
        united(std::move(standing_), united_cells(map_.cells(), fresh.begin(), fresh.end(), tol_), tol_);
  const Regions around{rectangular_region(map_.reach())};
  return standing_.empty() ? around : subtract(around, standing_, tol_);
}

Regions FloorSweep::free_at(double z) {
  const std::vector<int> fresh = take_above(z);
  if (overlaps_) return overlaid_free();
  add_curves(fresh);
  const double slack = 1e-3 + 1e-9 * map_.reach().width() * map_.reach().height();
  try {
    Regions free = exact_free(z);
    if (std::abs(excess(free)) < slack) return free;
  } catch (const InputError&) {
    // Its edges do not close by themselves: overlaid instead.
  }
  Regions free = overlaid_free();
  // Overlapping faces also overlap at every lower level; unclosed edges may still find their counterpart.
  overlaps_ = excess(free) > kOverlap + slack;
  return free;
}

}  // namespace clearcut::read
