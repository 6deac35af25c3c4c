#include "plan/cover/plan_cover.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>

#include "base/error.h"
#include "geometry/edge.h"
#include "plan/common/clearing_area.h"
#include "plan/common/layers.h"
#include "plan/common/residual.h"

namespace clearcut::plan::cover {
namespace {

/// Room around an area, in radii, never left by a path of its cover.
constexpr double kRoomOfPath = 4;

/// Path through the points; for a single place one edge without length.
Path pass_through(const std::vector<Vec2>& points) {
  Path path = line_path(points);
  if (path.empty() && !points.empty()) path.push_back(Edge::line(points.front(), points.front()));
  return path;
}

void complete(Path& path, const LegalArea& legal, const ClearingComponent& component, double radius) {
  std::vector<Path> paths{path};
  const LegalArea inside(component.rest);
  MendJob job;
  job.radius = radius;
  job.residual = 0;
  job.matters = [&](Vec2 p) { return inside.contains(p); };
  job.legal = [&](Vec2 a, Vec2 b) { return legal.holds_line(a, b); };
  if (!mend(paths, job))
    throw InputError("cover", "found no path that clears the whole area; use another --strategy");
  path = std::move(paths.front());
}

CoverEffort share_of(CoverEffort effort, double share) {
  effort.steps = static_cast<std::uint64_t>(static_cast<double>(effort.steps) * share);
  effort.seconds = share > 0 ? effort.seconds * share : 0;
  return effort;
}

}  // namespace

LayerPasses plan_cover(const Layer& layer, double corner_price, const CoverEffort& effort,
                       const Tolerances& tol) {
  ClearingArea area = clearing_area(layer, tol);
  LayerPasses result = std::move(area.walls);
  result.strategy = "cover";
  const double radius = layer.tool_radius;
  double whole = 0;
  for (const ClearingComponent& component : area.components) whole += geometry::area(component.rest);
  for (std::size_t i = 0; i < area.components.size(); ++i) {
    const ClearingComponent& component = area.components[i];
    if (component.rest.empty()) continue;
    const double mm2 = geometry::area(component.rest), squares = mm2 / (4 * radius * radius);
    if (squares > kMostSquares)
      throw InputError(
          "cover", fmt::format("an area of {:.0f} square diameters is more than the {:.0f} that it searches; "
                               "use a wider cutter or another --strategy",
                               squares, kMostSquares));
    const LegalPaths legal({component.legal});
    CoverTask task;
    task.area = component.rest;
    task.radius = radius;
    task.corner_price = corner_price;
    if (!legal.area().surely_holds(box(component.rest).grown(kRoomOfPath * radius))) task.legal = &legal;
    const CoverResult found = shortest_cover(task, mm2 < whole ? share_of(effort, mm2 / whole) : effort);
    if (found.points.empty())
      throw InputError("cover", "found no path that clears the whole area; use another --strategy");
    Pass pass;
    pass.path = pass_through(found.points);
    if (!found.proven) complete(pass.path, legal.area(), component, radius);
    pass.parent = component.outer_wall;
    pass.component = static_cast<int>(i);
    pass.start_priority = 2 * radius + layer.wall_stock;  // farther from walls than their passes
    result.passes.push_back(std::move(pass));
  }
  return result;
}

namespace {

/// Steps of the search for all different outlines of a workingstep: without a requested duration, and for each requested
/// second. Steps are counted, so that a plan repeats to the byte; a second of the clock has
/// hardly fewer.
constexpr std::uint64_t kUsualSteps = 12'000'000;
constexpr double kStepsPerSecond = 2'500'000;

/// Steps of brief searches: for an outline, and for each of its square diameters.
constexpr double kBriefSteps = 1e6, kBriefStepsPerSquare = 50'000, kMostBriefSteps = 10e6;
CoverEffort briefly(CoverEffort effort, double mm2, double radius) {
  effort.steps = static_cast<std::uint64_t>(
      std::min(kMostBriefSteps, kBriefSteps + kBriefStepsPerSquare * mm2 / (4 * radius * radius)));
  return effort;
}

/// Least share of an outline in the effort of its workingstep, if no duration is requested.
constexpr double kLeastShare = 0.25;

/// Square diameters, of all different outlines of a workingstep, up to which "auto" tries the strategy: planning then takes
/// some 15 seconds of one core at most.
constexpr std::uint64_t kMostBriefSquares = 1000;

/// Refuses layers for which "auto" does not try the strategy. `squares`: square diameters of the layers so far.
void check_brief(const Layer& layer, std::atomic<std::uint64_t>& squares) {
  if (closed_all_round(layer))
    throw InputError("cover", "is tried by auto only where the cutter may leave the area");
  const double square = 4 * layer.tool_radius * layer.tool_radius;
  const auto more = static_cast<std::uint64_t>(geometry::area(layer.target) / square) + 1;
  if (squares.fetch_add(more) + more > kMostBriefSquares)
    throw InputError("cover", "is tried by auto only for smaller areas");
}

/// Cost of a usual corner as a share of stopping and starting again: most corners are blunt.
constexpr double kShareOfStop = 0.25;

/// mm of path run in the time lost by the machine in a corner.
double corner_price(const Machine& machine, MmPerMin feed) {
  const double speed = feed.mm_per_s();
  return kShareOfStop * speed * speed / machine.acceleration;
}

/// Whether the objective is length and not time. Throws InputError for any other objective.
bool is_length(const Objective& objective) {
  const ObjectiveKind kind = objective.terms.front().kind;
  if (objective.weighted || (kind != ObjectiveKind::kLength && kind != ObjectiveKind::kTime))
    throw InputError("--objective", "of the strategy cover is length or time");
  return kind == ObjectiveKind::kLength;
}

/// mm2; the area of all different outlines of a workingstep: with upright walls there is one.
double outlines_mm2(const StrategyRequest& request) {
  const ResolvedPlan& plan = request.plan;
  for (std::size_t i = 0; i < plan.steps.size() && i < plan.part.workplan.size(); ++i) {
    if (&plan.steps[i] != &request.step) continue;
    const Workingstep& step = plan.part.workplan[i];
    const Feature& feature = feature_of(plan.part, step);
    if (feature.wall_slope.radians() == 0) return geometry::area(feature.target);
    double sum = 0;
    for (const Layer& layer : layers_of(feature, step.operation, tool_of(plan.part, step).radius(), plan.tol))
      sum += geometry::area(layer.target);
    return sum;
  }
  return 0;
}

/// The effort of a workingstep, which its outlines share by their size. Layers beside what stands over them have outlines
/// not known before: each has at least `least` of the effort.
class SharedEffort {
 public:
  SharedEffort(CoverEffort effort, double whole_mm2, double least)
      : effort_(std::move(effort)), whole_(whole_mm2), least_(least) {}

  CoverEffort take(double mm2) {
    const double share = std::max(least_, whole_ > 0 ? std::min(left_, mm2 / whole_) : left_);
    left_ = std::max(0.0, left_ - share);
    return share < 1 ? share_of(effort_, share) : effort_;
  }

 private:
  CoverEffort effort_;
  double whole_, least_, left_ = 1;
};

Strategy make_cover(const StrategyRequest& request) {
  if (request.stepover.is_given())
    throw InputError("--stepover", "has no meaning for the strategy cover, whose paths have no step");
  const bool shortest = is_length(request.objective());
  CoverEffort effort;
  effort.steps = kUsualSteps;
  if (request.plan.search_s) {
    const double seconds = *request.plan.search_s / static_cast<double>(request.plan.steps.size());
    effort.steps = static_cast<std::uint64_t>(seconds * kStepsPerSecond);
    effort.seconds = seconds;
  }
  effort.brief = request.briefly;
  effort.seed = request.plan.seed;
  effort.cancel = request.plan.cancel;
  return once_per_outline(
      [effort, is_timed = request.plan.search_s.has_value(),
       shared = SharedEffort(effort, outlines_mm2(request), request.plan.search_s ? 0 : kLeastShare),
       price = shortest ? 0.0 : corner_price(request.plan.machine, request.step.feed), tol = request.plan.tol,
       squares = std::make_shared<std::atomic<std::uint64_t>>(0)](const Layer& layer) mutable {
        if (effort.brief) check_brief(layer, *squares);
        const double mm2 = geometry::area(layer.target);
        const CoverEffort own =
            effort.brief && !is_timed ? briefly(effort, mm2, layer.tool_radius) : shared.take(mm2);
        return plan_cover(layer, price, own, tol);
      });
}

}  // namespace

StrategyEntry entry() {
  StrategyEntry entry;
  entry.name = "cover";
  entry.description = "the shortest path found that clears all, for faces and open blocks";
  entry.make = make_cover;
  entry.keeps_direction = false;
  entry.loses_air_cuts = true;
  entry.takes_stepover = false;
  entry.in_auto = AutoUse::kBriefly;
  entry.tried_when_open = true;
  entry.orders = {ObjectiveKind::kTime, ObjectiveKind::kLength};
  return entry;
}

}  // namespace clearcut::plan::cover
