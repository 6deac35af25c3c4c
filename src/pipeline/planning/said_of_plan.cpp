#include "pipeline/planning/said_of_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "base/error.h"
#include "base/text/format.h"
#include "features/fitting.h"
#include "features/round_hole.h"
#include "model/results/not_machined.h"
#include "pipeline/steps/certify.h"
#include "pipeline/steps/work_share.h"
#include "plan/contour/entries.h"
#include "plan/contour/step_rule.h"
#include "post/post.h"

namespace clearcut::pipeline {
namespace {

/// A number as text, in thousands.
std::string thousands(std::uint64_t steps) {
  return fmt::format("{} thousand steps of work", steps / 1000);
}

/// A cone has no size that fits beside any edge: its width at the top of the chamfer decides.
std::string no_room_beside_edge(const Feature& feature, const Tool& tool) {
  const double width = radius_at(tool, feature.chamfer->depth);
  return fmt::format(
      "the cone of T{} has no room beside the edge of {}: it needs {} mm there, free up to the top; make the "
      "chamfer less "
      "deep, take a narrower cone, or mill more away beside the edge first",
      tool.number, feature.name, trimmed(width, 3));
}

std::string does_not_fit(const Part& part, const Workingstep& step, const Tolerances& tol) {
  if (feature_of(part, step).chamfer) return no_room_beside_edge(feature_of(part, step), tool_of(part, step));
  if (makes_holes(tool_of(part, step)) && !features::round_hole_of(feature_of(part, step), tol)) {
    return fmt::format("tool T{} ({} {} mm) only makes round holes; {} needs a mill",
                       tool_of(part, step).number, name_of(tool_of(part, step).kind),
                       trimmed(tool_of(part, step).diameter, 4), feature_of(part, step).name);
  }
  if (features::is_too_narrow_for_hole(part, step, tol))
    return fmt::format(
        "tool T{0} ({1} {2} mm) makes no hole of {3} mm; give one that does, for example --tool drill:{3}",
        tool_of(part, step).number, name_of(tool_of(part, step).kind),
        trimmed(tool_of(part, step).diameter, 4),
        trimmed(2 * features::round_hole_of(feature_of(part, step), tol)->radius, 4));
  return fmt::format("tool T{} ({} mm) does not fit {}; the largest that does has {} mm",
                     tool_of(part, step).number, trimmed(tool_of(part, step).diameter, 4),
                     feature_of(part, step).name,
                     trimmed(features::largest_fitting_diameter(feature_of(part, step), tol), 3));
}

/// Why there are no passes for a workingstep.
std::string no_passes(std::size_t i, const Selection& selection, const std::vector<StepWork>& works,
                      const ResolvedPlan& plan) {
  const Part& part = plan.part;
  const auto& step = part.workplan[i];
  const std::string& name = feature_of(part, step).name;
  if (!selection.left_out(i).empty()) {
    return fmt::format(
        "planning {} by {} took more than {}; use another --strategy (zigzag takes the least) or a larger "
        "cutter",
        name, fmt::join(selection.left_out(i), " and "), thousands(work_shares(works, plan)[i]));
  }
  const bool fits =
      tool_of(part, step).diameter <= features::largest_fitting_diameter(feature_of(part, step), plan.tol);
  if (!fits || makes_holes(tool_of(part, step))) return does_not_fit(part, step, plan.tol);
  return fmt::format("{} found no passes for {}; {}", selection.candidate(i).strategy->name, name,
                     plan.steps[i].published_grid
                         ? "no point of the published grid lies where the cutter's centre may be; use a "
                           "smaller --stepover, or leave --grid out"
                         : "use another --strategy, for example contour");
}

/// A request of a step unsupported by its strategy; "" if all are supported.
std::string unused_choice(const ResolvedStep& step) {
  const std::string name = step.strategy ? step.strategy->name : "auto";
  const bool has_contours = name == "contour" || plan::contour::contour_rule(name, {});
  if (step.bisector_passages && !has_contours)
    return fmt::format("--passage is for contour strategies, '{}' is planned", name);
  if ((step.published_grid || step.solver.is_published) && name != "tour")
    return fmt::format("--grid and --solver published are for the strategy tour, '{}' is planned", name);
  return "";
}

}  // namespace

void warn_of_both_ways(const ResolvedPlan& plan, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const ResolvedStep& step = plan.steps[i];
    if (!step.is_direction_asked || !step.strategy || step.strategy->keeps_direction) continue;
    diagnostics.warn(
        plan.part.workplan[i].name,
        fmt::format("'{}' cuts both ways; only its passes along walls are {}. contour, spiral and "
                    "adaptive keep the direction",
                    step.strategy->name, step.direction == CutDirection::kClimb ? "climb" : "conventional"));
  }
}

void tell_program_number(const ResolvedPlan& plan, Diagnostics& diagnostics) {
  const PostOptions post = post_options_of(plan);
  const std::string& name = post.program_name.empty() ? plan.part.name : post.program_name;
  const auto number = post::program_number_of(post.dialect, name);
  if (!number || post.program_number || *number != 1) return;
  diagnostics.note("post",
                   fmt::format("the program is number O{}, as nobody states one: --program-number, or "
                               "program_number in the machine file",
                               *number + post.programs_before));
}

void refuse_what_means_nothing(const ResolvedPlan& plan, Diagnostics& diagnostics) {
  std::size_t unused = 0;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const std::string text = unused_choice(plan.steps[i]);
    if (text.empty()) continue;
    if (++unused == plan.steps.size()) throw InputError("plan", text + "; add --strategy");
    diagnostics.warn(plan.part.workplan[i].name, text);
  }
}

void report_notes(const Selection& selection, const std::vector<StepWork>& works, const ResolvedPlan& plan,
                  Part& part) {
  const auto shares = work_shares(works, plan);
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    if (works[i].done_before) {
      part.diagnostics.note(
          feature_of(part, part.workplan[i]).name,
          "nothing is cut: the earlier program has left no more than residuals under 0.007 mm "
          "where the cutter can reach");
    }
    for (const auto& name : selection.left_out(i)) {
      part.diagnostics.note(feature_of(part, part.workplan[i]).name,
                            fmt::format("{} is left out: planning it took more than its share of {}", name,
                                        thousands(shares[i])));
    }
    for (const auto& name : selection.beyond_memory(i)) {
      part.diagnostics.note(feature_of(part, part.workplan[i]).name,
                            fmt::format("{} is left out: planning it took more memory than there is", name));
    }
    const Section& section = selection.section(i);
    for (const auto& text : section.notes) part.diagnostics.note(section.label, text);
  }
}

void report_what_does_not_fit(Part& part, const Selection& selection, const std::vector<StepWork>& works,
                              const ResolvedPlan& plan) {
  bool nothing = true;
  for (std::size_t i = 0; i < part.workplan.size(); ++i)
    nothing = nothing && selection.section(i).moves.empty();
  const bool done_before =
      std::any_of(works.begin(), works.end(), [](const StepWork& work) { return work.done_before; });
  if (nothing && !done_before) {
    throw InputError(part.source_file, "nothing can be cut: " + no_passes(0, selection, works, plan));
  }
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    const auto& step = part.workplan[i];
    if (!selection.section(i).moves.empty() || works[i].done_before || path_of(step)) continue;
    const bool fits =
        tool_of(part, step).diameter <= features::largest_fitting_diameter(feature_of(part, step), plan.tol);
    if (fits && works[i].layers.empty()) continue;
    const std::string& name = feature_of(part, step).name;
    if (fits && plan.steps[i].published_grid) {
      say_not_machined(part.diagnostics, "", name, no_passes(i, selection, works, plan));
    } else {
      part.diagnostics.skip(name, no_passes(i, selection, works, plan));
    }
  }
}

}  // namespace clearcut::pipeline
