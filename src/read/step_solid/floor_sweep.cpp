#include "read/step_solid/floor_sweep.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/error.h"
#include "geometry/contours/boolean.h"
#include "geometry/region.h"
#include "read/repair/repair.h"

namespace clearcut::read {
namespace {

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

}  // namespace

std::vector<std::size_t> unpaired(const std::vector<const Path*>& curves) {
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
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (!gone[i]) left.push_back(i);
  return left;
}

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

// The area of material above z is the union of the upward faces above z. Faces of a solid that can be milled from
// above do not overlap in plan view, so that the union's boundary consists of the faces' own edges: edges shared by
// two faces cancel in pairs. If this does not give the faces' total area (undercuts, partly shared edges) the faces
// are united by polyclipping: neighbours first, because its time grows with the square of the input given at once.

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
