#include "plan/common/profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"
#include "features/derived_outlines.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "plan/common/rings.h"

namespace clearcut::plan {
namespace {

/// mm. An edge whose distance from the outline is right to within this belongs to the profile.
constexpr double kOnContour = 1e-3;
/// Share of the cutter's radius, and mm: distance from its contour at which the centre may descend or approach.
/// Slightly more than the play of the kerf.
constexpr double kBesideContour = 0.02;
constexpr double kBesideSpare = 0.02;
/// Leads begin as far beside the contour as there is room, and half as far from the edge of their area.
constexpr double kRoomOfLeads = 1.5;
/// mm. Passes along a line end this much before the cutter touches a square tab.
constexpr double kBesideTab = 0.002;
/// mm2. Greatest area of specks left by a boolean of areas that only touch.
constexpr double kProfileSpeck = 0.01;

double distance_to(const Path& line, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Edge& edge : line) least = std::min(least, distance(edge, p));
  return least;
}

bool runs_at(const Edge& edge, const Path& line, double reach) {
  const auto is_there = [&](double t) {
    return std::abs(distance_to(line, edge.at(t)) - reach) < kOnContour;
  };
  return is_there(0.5) && is_there(0.1) && is_there(0.9);
}

void add(Path path, bool closed, double offset, LayerPasses& result) {
  Pass pass;
  pass.path = std::move(path);
  pass.closed = closed;
  pass.offset = pass.start_priority = offset;
  // Along a wall the direction is fixed: the direction decides the side of the material.
  pass.reversible = false;
  pass.may_cut_to_start = false;
  pass.component = static_cast<int>(result.legal.size());
  result.passes.push_back(std::move(pass));
}

/// Adds the parts of a loop of the legal area running beside the outline.
void add_runs(const Loop& loop, const Path& line, double reach, LayerPasses& result) {
  std::vector<char> own;
  for (const Edge& edge : loop) own.push_back(runs_at(edge, line, reach) ? 1 : 0);
  const auto first_gap = std::find(own.begin(), own.end(), 0);
  if (first_gap == own.end()) return add(loop, true, reach, result);
  const auto offset = static_cast<std::size_t>(first_gap - own.begin());
  Path run;
  for (std::size_t k = 1; k <= loop.size(); ++k) {
    const std::size_t i = (offset + k) % loop.size();
    if (own[i]) {
      run.push_back(loop[i]);
    } else if (!run.empty()) {
      add(std::move(run), false, reach, result);
      run.clear();
    }
  }
}

/// Legal area of the centre on its links to the passes: in acute corners, in which the kerfs of two sides merge,
/// there is room beside the contour, but only material in one of the kerfs is cut there. `room`: mm, that earlier steps have cut
/// beside the contour.
Regions along_contour(const Region& inside, const ProfileCut& cut, double reach, double radius, double room,
                      const Tolerances& tol) {
  const double spare = kBesideContour * radius + kBesideSpare;
  const Regions beside = features::kerf_of(cut, reach + kRoomOfLeads * room + spare, tol);
  if (area(subtract({inside}, beside, tol)) < kProfileSpeck) return {inside};
  return intersect({inside}, beside, tol);
}

/// A stretch of one edge, as parameters, on which a tab blocks the cutter's centre.
struct Gap {
  std::size_t edge = 0;
  double from = 0;
  double to = 0;
};

/// Stretches on which the centre, on the line, is nearer to one of the square tabs than the cutter's radius, in the
/// line's order.
std::vector<Gap> gaps_at_tabs(const ProfileCut& cut, double radius) {
  std::vector<Gap> gaps;
  for (const Tab& tab : cut.tabs) {
    if (tab.shape != TabShape::kSquare) continue;
    std::size_t on = 0;
    for (std::size_t i = 1; i < cut.line.size(); ++i)
      if (distance(cut.line[i], tab.center) < distance(cut.line[on], tab.center)) on = i;
    const Edge& edge = cut.line[on];
    // The sides of tabs on arcs run to the arc's centre.
    const double half =
        edge.is_arc() ? edge.radius() * (std::abs(tab.foot.sweep()) / 2 + base::asin(radius / edge.radius()))
                      : tab.foot.length() / 2 + radius;
    const double middle = nearest(edge, tab.center).t, away = (half + kBesideTab) / edge.length();
    gaps.push_back({on, middle - away, middle + away});
  }
  std::sort(gaps.begin(), gaps.end(),
            [](const Gap& a, const Gap& b) { return a.edge != b.edge ? a.edge < b.edge : a.from < b.from; });
  return gaps;
}

/// The parts of the line between the gaps (at least one gap). On a closed line the first part begins after the first
/// gap.
std::vector<Path> runs_between(const std::vector<Gap>& gaps, const ProfileCut& cut) {
  std::vector<Path> runs{{}};
  auto gap = gaps.begin();
  for (std::size_t i = 0; i < cut.line.size(); ++i) {
    double from = 0;
    for (; gap != gaps.end() && gap->edge == i; ++gap) {
      runs.back().push_back(cut.line[i].part(from, gap->from));
      runs.emplace_back();
      from = gap->to;
    }
    runs.back().push_back(from == 0 ? cut.line[i] : cut.line[i].part(from, 1));
  }
  if (cut.closed) {
    runs.back().insert(runs.back().end(), runs.front().begin(), runs.front().end());
    runs.erase(runs.begin());
  }
  return runs;
}

/// Along the line itself, between square tabs if there are any.
void add_line(const ProfileCut& cut, double radius, LayerPasses& result) {
  const std::vector<Gap> gaps = gaps_at_tabs(cut, radius);
  const std::vector<Path> runs = gaps.empty() ? std::vector<Path>{cut.line} : runs_between(gaps, cut);
  for (const Path& run : runs) {
    result.fit_lines.push_back(run);
    add(run, gaps.empty() && cut.closed, 0, result);
  }
}

}  // namespace

LayerPasses plan_profile(const Layer& layer, const ProfileCut& cut, const Tolerances& tol) {
  LayerPasses result;
  result.z_top = layer.z_top;
  result.z = layer.z;
  result.target = layer.target;
  result.strategy = "profile";
  if (cut.side == ProfileSide::kOn) {
    add_line(cut, layer.tool_radius, result);
    return result;
  }
  const double reach = layer.tool_radius + layer.wall_stock;
  for (const Region& region : layer.allowed) {
    const Clearance clearance(region, tol);
    for (const Region& inside : safe_inset(clearance, region, reach, tol)) {
      add_runs(inside.outer(), cut.line, reach, result);
      for (const Loop& island : inside.islands()) add_runs(island, cut.line, reach, result);
      for (Region& room : along_contour(inside, cut, reach, layer.tool_radius, layer.room_beside, tol))
        result.legal.push_back(std::move(room));
    }
    for (const Path& line : clearance.fit_lines(reach, layer.reserve)) {
      result.fit_lines.push_back(line);
      add(line, false, reach, result);
    }
  }
  return result;
}

}  // namespace clearcut::plan
