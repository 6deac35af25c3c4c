#include "pipeline/stated_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/error.h"
#include "base/text.h"
#include "model/options/strategy_entry.h"

namespace clearcut::pipeline {
namespace {

/// Share by which a stated speed may exceed a limit of the machine: programs are rounded to whole rpm.
constexpr double kLimitRounding = 1e-3;

/// "--engagement", or the line of the job that states it.
std::string place_of_engagement(const PlanOptions& options) {
  const Source* source = options.sources.find("engagement");
  const bool is_job = source && source->origin == Origin::kJobFile;
  return is_job ? source->text + ": engagement" : "--engagement";
}

/// Why the step exceeds the limit of engagement, and what to do.
std::string why_over_engagement(const ResolvedPlan& plan, std::size_t index) {
  const Workingstep& step = plan.part.workplan[index];
  const Tool& tool = tool_of(plan.part, step);
  const std::string alone = "plan it in a program of its own, without the limit";
  if (tool.kind == ToolKind::kThreadMill) return ": a thread is milled to its full depth at once; " + alone;
  if (feature_of(plan.part, step).profile)
    return ": a cut along an outline has the full width of the cutter; " + alone;
  const StrategyEntry* strategy = plan.steps[index].strategy;
  if (strategy && !strategy->limits_engagement)
    return fmt::format(
        ": the strategy {} begins with cuts of full width; leave out --strategy, or use "
        "adaptive, which holds the limit",
        strategy->name);
  return fmt::format(": T{} ({} mm) has no room there to hold it; take a narrower cutter, or {}", tool.number,
                     trimmed(tool.diameter, 3), alone);
}

}  // namespace

bool exceeds_engagement(const FeatureFindings& step, const ResolvedPlan& plan) {
  return step.figures.engagement.max_deg > plan.engagement_deg.value_or(0) + kFreeEngagementDeg;
}

void refuse_beyond_machine(const ResolvedPlan& plan) {
  const Machine& machine = plan.machine;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const ResolvedStep& step = plan.steps[i];
    const Workingstep& working = plan.part.workplan[i];
    const Tool& tool = tool_of(plan.part, working);
    const auto refuse = [&](const char* what, double asked, const std::string& limit, double allowed) {
      throw InputError(feature_of(plan.part, working).name,
                       fmt::format("{} of {} with T{} where {} {}; state another or leave it out", what,
                                   trimmed(asked, 1), tool.number, limit, trimmed(allowed, 1)));
    };
    const double rpm = step.spindle_rpm;
    const auto is_above = [](double value, double most) { return value > most * (1 + kLimitRounding); };
    if (machine.max_spindle_rpm && is_above(rpm, *machine.max_spindle_rpm))
      refuse("a spindle speed", rpm, "the machine has no more than", *machine.max_spindle_rpm);
    if (tool.max_spindle_rpm && is_above(rpm, *tool.max_spindle_rpm))
      refuse("a spindle speed", rpm, "the tool may have no more than", *tool.max_spindle_rpm);
    if (machine.min_spindle_rpm && rpm > 0 && is_above(*machine.min_spindle_rpm, rpm))
      refuse("a spindle speed", rpm, "the machine turns no slower than", *machine.min_spindle_rpm);
  }
}

void refuse_exceeded_engagement(const PlanResult& result, const ResolvedPlan& plan,
                                const PlanOptions& options) {
  const auto exceeds = [&](const FeatureFindings& step) {
    const auto& faults = result.findings.faults;
    return exceeds_engagement(step, plan) &&
           std::any_of(faults.begin(), faults.end(), [&](const Fault& fault) {
             return fault.kind == FaultKind::kOverEngagement && fault.feature == step.name;
           });
  };
  for (const FeatureFindings& step : result.findings.features) {
    if (step.workingstep < 0 || !exceeds(step)) continue;
    const auto index = static_cast<std::size_t>(step.workingstep);
    const std::string what =
        fmt::format("{} would engage the cutter by {} degrees where {} are the limit", step.name,
                    trimmed(step.figures.engagement.max_deg, 1), trimmed(*plan.engagement_deg, 1));
    throw InputError(place_of_engagement(options), what + why_over_engagement(plan, index));
  }
}

}  // namespace clearcut::pipeline
