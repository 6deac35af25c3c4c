#include "plan/cover/entry.h"

#include "base/error.h"
#include "plan/common/layers.h"
#include "plan/cover/plan_cover.h"

namespace clearcut::plan::cover {
namespace {

/// Steps of the search: where nobody says how long, as one of several strategies, and for each second that is asked for. They
/// are counted, so that a plan repeats to the byte; a second of the clock has about twice as many.
constexpr std::uint64_t kUsualSteps = 8'000'000;
constexpr std::uint64_t kBriefSteps = 1'000'000;
constexpr double kStepsPerSecond = 5'000'000;

Strategy make_cover(const StrategyRequest& request) {
  if (request.stepover.is_given())
    throw InputError("--stepover", "has no meaning for the strategy cover, whose paths have no step");
  CoverEffort effort;
  effort.steps = request.briefly ? kBriefSteps : kUsualSteps;
  if (request.plan.search_s) {
    effort.steps = static_cast<std::uint64_t>(*request.plan.search_s * kStepsPerSecond);
    effort.seconds = *request.plan.search_s;
  }
  effort.seed = request.plan.seed;
  effort.cancel = request.plan.cancel;
  return once_per_outline(
      [effort, tol = request.plan.tol](const Layer& layer) { return plan_cover(layer, effort, tol); });
}

}  // namespace

StrategyEntry entry() {
  StrategyEntry entry;
  entry.name = "cover";
  entry.description = "the shortest path found that clears all, for faces and open blocks";
  entry.make = make_cover;
  entry.keeps_direction = false;
  entry.takes_stepover = false;
  entry.in_auto = AutoUse::kNever;
  return entry;
}

}  // namespace clearcut::plan::cover
