#include "pipeline/planning.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "base/work_budget.h"
#include "features/round_hole.h"
#include "features/tool_choice.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "kinematics/planner.h"
#include "link/sections/load_feeds.h"
#include "model/results/findings.h"
#include "model/results/nothing_to_machine.h"
#include "model/section_names.h"
#include "pipeline/selection/selection.h"
#include "pipeline/steps/certify.h"
#include "pipeline/steps/out_of_reach.h"
#include "pipeline/steps/section_order.h"
#include "pipeline/steps/step_work.h"
#include "pipeline/steps/worn_feeds.h"
#include "plan/common/air_cuts.h"
#include "plan/common/clearing_area.h"
#include "plan/common/cover.h"
#include "plan/common/layers.h"
#include "plan/common/machine_clock.h"
#include "plan/common/profile.h"
#include "plan/contour/contour.h"
#include "plan/contour/step_rule.h"
#include "post/post.h"
#include "stock/material.h"

namespace clearcut::pipeline {
namespace {

/// mm. Areas cleared by other steps may contain residuals up to this thickness: unsuitable for rapids.
constexpr double kResidualOfOthers = 0.01;

/// Least area reached beyond the rim, as a share of its length times the radius: less is reached at corners than at
/// straight walls.
constexpr double kBeyondRim = 0.9;

/// Sizes that bound the length of any strategy, layer by layer.
class Sizes {
 public:
  explicit Sizes(const Tolerances& tol) : tol_(tol) {}

  void add(StepPlan& plan, const Layer& layer, const LayerPasses& passes) {
    const bool pocket = plan::closed_all_round(layer);
    plan.pocket = plan.pocket && pocket;
    if (plan.hole) return;  // no other strategy is tried
    double rim = 0;
    for (const auto& region : passes.legal) {
      for (const auto& edge : region.edges()) rim += edge.length();
    }
    plan.size.reached_mm2 += pocket ? area(passes.legal) + kBeyondRim * layer.tool_radius * rim
                                    : reached_of_open(layer, passes.legal);
    plan.size.legal_rim_mm += rim;
    plan.size.edges = std::max(plan.size.edges, edge_count(passes.legal));
  }

 private:
  /// Layers usually differ from the previous one only in height.
  double reached_of_open(const Layer& layer, const Regions& legal) {
    if (legal.empty()) return 0;
    if (!plan::same_outline(legal, legal_) || !plan::same_outline(layer.target, target_)) {
      legal_ = legal;
      target_ = layer.target;
      reached_mm2_ = area(intersect(layer.target, dilate(legal, layer.tool_radius, tol_), tol_));
    }
    return reached_mm2_;
  }

  const Tolerances& tol_;
  Regions legal_, target_;
  double reached_mm2_ = 0;
};

/// The passes of a workingstep layer by layer; the cleared size, and whether material is left, are stored in `plan`.
std::vector<LayerPasses> passes_of(const StepWork& work, const Feature& feature,
                                   const StrategyCandidate& candidate, const ResolvedPlan& job,
                                   StepPlan& plan) {
  const auto strategy = strategy_for(candidate, job.steps[static_cast<std::size_t>(work.workingstep)], job);
  std::vector<LayerPasses> passes;
  Sizes sizes(job.tol);
  for (const auto& layer : work.layers) {
    throw_if_cancelled(job.cancel);
    passes.push_back(feature.profile    ? plan::plan_profile(layer.layer, *feature.profile, job.tol)
                     : layer.walls_only ? plan::plan_walls(layer.layer, job.tol)
                                        : strategy(layer.layer));
    passes.back().wall_top = work.wall_top;
    passes.back().cleared_beyond = layer.layer.cleared_beyond;
    passes.back().cleared_to = layer.layer.cleared_to;
    if (work.meets_others && plan.leaves_nothing && candidate.as_rival)
      plan.leaves_nothing = plan::leaves_nothing(passes.back(), layer.layer.tool_radius);
    if (layer.rest) passes.back().residual = std::max(passes.back().residual, kResidualOfOthers);
    sizes.add(plan, layer.layer, passes.back());
    plan.rest = plan.rest || layer.rest;
  }
  return passes;
}

/// s; time by the planner of the program's control.
double time_on_machine(const Section& section, const ResolvedPlan& job) {
  return kinematics::planned_time(section.moves, post::path_control_of(post_options_of(job)), job.machine,
                                  planner_of_control(job))
      .seconds();
}

/// Whether two layers differ in height alone.
bool same_passes(const LayerPasses& a, const LayerPasses& b) {
  return plan::same_outline(a.target, b.target) &&
         std::equal(a.passes.begin(), a.passes.end(), b.passes.begin(), b.passes.end(),
                    [](const Pass& one, const Pass& other) { return one.path == other.path; });
}

/// The passes without what cuts nothing; nothing where no pass of any layer gets shorter.
std::optional<std::vector<LayerPasses>> without_air_cuts(const std::vector<LayerPasses>& passes,
                                                         const StepWork& work, bool takes_overlaps,
                                                         double most_left, const ResolvedPlan& job) {
  const ResolvedStep& step = job.steps[static_cast<std::size_t>(work.workingstep)];
  std::vector<LayerPasses> all;
  bool is_shorter = false;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    throw_if_cancelled(job.cancel);
    if (i > 0 && same_passes(passes[i], passes[i - 1])) {
      all.push_back(passes[i]);
      all.back().passes = all[i - 1].passes;
      continue;
    }
    const Layer& layer = work.layers[i].layer;
    const plan::RetractLink retract(job.machine, step.feed, plan::retract_heights(layer));
    auto trimmed = plan::without_air_cuts(passes[i], {layer.tool_radius, step.feed, &retract,
                                                      step.is_direction_asked, takes_overlaps, most_left});
    is_shorter = is_shorter || trimmed;
    all.push_back(trimmed ? *std::move(trimmed) : passes[i]);
  }
  if (!is_shorter) return std::nullopt;
  return all;
}

/// Share of the time that a change of the passes must gain. Where less is to be expected, the search for it ends.
constexpr double kWorthwhile = 0.05;

/// Replaces the section of `plan` by one without air cuts if that is faster on the machine than the plan, and than `to_beat` seconds. The
/// search has as many steps of work as the plan itself; if it needs more the section stays.
void leave_out_air_cuts(const std::vector<LayerPasses>& passes, const StepWork& work, EntryKind entry,
                        const StrategyCandidate& candidate, const ResolvedPlan& job, std::uint64_t most_work,
                        double to_beat, StepPlan& plan) try {
  const WorkBudget budget(most_work);
  const double most_left = std::min(1 - kWorthwhile, to_beat / plan.time_s);
  const auto shorter = without_air_cuts(passes, work, !candidate.stepover.is_given(), most_left, job);
  if (!shorter) return;
  Section section = link_step(*shorter, work.workingstep, entry, job);
  const double time = time_on_machine(section, job);
  if (time >= plan.time_s * (1 - kWorthwhile)) return;
  plan.section = std::move(section);
  plan.time_s = time;
  plan.is_shortened = true;
} catch (const OutOfWork&) {
  return;
}

/// A stated start, and leads, need their passes as they are.
bool may_lose_air_cuts(const StepWork& work, const StepPlan& plan, const ResolvedPlan& job) {
  const ResolvedStep& step = job.steps[static_cast<std::size_t>(work.workingstep)];
  return work.stands_alone && !plan.pocket && !job.start && step.lead == 0;
}

/// Number of edges of an outline above which rivals are not tried: the waiting time would be noticeable.
constexpr std::size_t kMostEdgesForRivals = 400;

/// Plans a step by one strategy; air cuts are left out where it may then take less than `to_beat` seconds.
StepPlan plan_step_to_beat(double to_beat, const StepWork& work, const StrategyCandidate& candidate,
                           const ResolvedPlan& job, std::uint64_t most_work) {
  const ResolvedStep& step = job.steps[static_cast<std::size_t>(work.workingstep)];
  const WorkBudget budget(most_work);
  StepPlan plan;
  const auto& feature = feature_of(job.part, job.part.workplan[static_cast<std::size_t>(work.workingstep)]);
  if (work.hole) {
    plan.section = *work.hole;
    plan.hole = true;
  } else {
    plan.hole = feature.profile.has_value();
    const auto passes = passes_of(work, feature, candidate, job, plan);
    const EntryKind entry =
        !feature.profile && candidate.strategy->limits_engagement ? step.entry_at_limit : step.entry;
    plan.section = link_step(passes, work.workingstep, entry, job);
    plan.time_s = time_on_machine(plan.section, job);
    if (candidate.strategy->loses_air_cuts && may_lose_air_cuts(work, plan, job))
      leave_out_air_cuts(passes, work, entry, candidate, job, most_work, to_beat, plan);
    return plan;
  }
  plan.time_s = time_on_machine(plan.section, job);
  return plan;
}

}  // namespace

StepPlan plan_step(const StepWork& work, const StrategyCandidate& candidate, const ResolvedPlan& job,
                   std::uint64_t most_work) {
  return plan_step_to_beat(std::numeric_limits<double>::infinity(), work, candidate, job, most_work);
}

namespace {

/// Whether the feature is cut along its outline, whatever the strategy.
bool follows_outline(const Feature& feature) {
  return feature.profile || feature.carving || feature.chamfer || feature.t_slot;
}

}  // namespace

std::vector<SelectionStep> selection_steps(const ResolvedPlan& plan, const StrategyTable& strategies) {
  std::vector<SelectionStep> steps;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const auto& step = plan.part.workplan[i];
    ResolvedStep resolved = plan.steps[i];
    if (resolved.strategy && follows_outline(feature_of(plan.part, step))) {
      const StrategyEntry* contour = strategies.find("contour");
      if (contour) resolved.strategy = contour;
    }
    steps.push_back({feature_of(plan.part, step).name, static_cast<int>(i), tool_of(plan.part, step).radius(),
                     plan.steps[i].feed, candidates_for(resolved, plan, strategies)});
  }
  return steps;
}

namespace {

/// Replaces `best` by another strategy's plan if that is faster and leaves nothing; its sizes stay.
void plan_rival(const StepWork& work, const StrategyEntry& rival, const ResolvedPlan& job,
                std::uint64_t most_work, StepPlan& best) {
  try {
    StepPlan plan = plan_step_to_beat(best.time_s, work, {&rival, {}, false, false, true}, job, most_work);
    if (plan.section.moves.empty() || plan.time_s >= best.time_s || !plan.leaves_nothing) return;
    best.section = std::move(plan.section);
    best.time_s = plan.time_s;
    best.is_shortened = plan.is_shortened;
  } catch (const OutOfWork&) {
    return;  // the candidate itself is kept
  }
}

}  // namespace

StepPlan fastest_plan(const StepWork& work, const StrategyCandidate& candidate, const ResolvedPlan& job,
                      const StrategyTable& strategies, std::uint64_t most_work) {
  const Part& part = job.part;
  StepPlan best = plan_step(work, candidate, job, most_work);
  const auto& feature = feature_of(part, part.workplan[static_cast<std::size_t>(work.workingstep)]);
  const bool alone =
      !candidate.beside_rivals || best.hole || edge_count(feature.allowed) > kMostEdgesForRivals;
  if (alone || best.section.moves.empty()) return best;
  if (candidate.strategy->form_for_open && may_lose_air_cuts(work, best, job)) {
    const double time = best.time_s;
    plan_rival(work, *candidate.strategy->form_for_open, job, most_work, best);
    best.is_shortened = best.is_shortened || best.time_s < time;
  }
  for (const auto& name : candidate.strategy->rivals)
    if (const StrategyEntry* rival = strategies.find(name)) plan_rival(work, *rival, job, most_work, best);
  return best;
}

namespace {

/// Whether links at depth are faster than cuts. (Within one stroke the planner knows the cut material.)
bool has_fast_links(const ResolvedStep& step, const ResolvedPlan& plan) {
  return plan.link_feed && step.feed < *plan.link_feed;
}

/// Slows down steps with a slot feed in full-width cuts, and fast links in any material, taking all earlier moves
/// into account.
void slow_down_slots(Toolpath& toolpath, const ResolvedPlan& plan) {
  const Part& part = plan.part;
  const auto step_of = [&](const Section& section) -> const ResolvedStep& {
    return plan.steps[static_cast<std::size_t>(section.workingstep)];
  };
  const bool wanted =
      std::any_of(toolpath.sections.begin(), toolpath.sections.end(), [&](const Section& section) {
        return step_of(section).slot_feed != step_of(section).feed || has_fast_links(step_of(section), plan);
      });
  if (!wanted) return;
  std::vector<double> radii;
  for (const auto& tool : part.tools) radii.push_back(tool.radius());
  stock::Material material(part.stock ? std::optional(part.stock->plan) : std::nullopt, part.top_z(), radii);
  for (auto& section : toolpath.sections) {
    const ResolvedStep& step = step_of(section);
    const Workingstep& work = part.workplan[static_cast<std::size_t>(section.workingstep)];
    Section slowed = section;
    link::slow_down_slots(slowed, tool_of(part, work), {plan.slot_angle, step.slot_feed, step.feed},
                          material);
    if (path_of(work) == nullptr) section = std::move(slowed);
  }
}

}  // namespace

Toolpath toolpath_of(const Selection& selection, const ResolvedPlan& plan, bool over_rests) {
  const Part& part = plan.part;
  Toolpath toolpath;
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    if (!selection.section(i).moves.empty()) toolpath.sections.push_back(selection.section(i));
  }
  if (part.order_free)
    toolpath.sections =
        in_short_order(std::move(toolpath.sections), part, post::repeats_cycles(plan.post.dialect));
  if (over_rests) keep_rapids_high(toolpath, plan);
  slow_down_slots(toolpath, plan);
  follow_load(toolpath, plan);
  const SectionNames names(part);
  for (Section& section : toolpath.sections) section.label = names.of(section.workingstep);
  keep_load_when_worn(toolpath, plan);
  return toolpath;
}

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

/// mm; the widest mill that leaves the stock which the step has to leave on walls.
double widest_mill(const Part& part, const Workingstep& step, const Tolerances& tol) {
  return features::largest_fitting_diameter(feature_of(part, step), tol) - 2 * step.operation.allowance_side;
}

std::string no_room(const Part& part, const Workingstep& step, const Tolerances& tol) {
  const Tool& tool = tool_of(part, step);
  const double left = step.operation.allowance_side, widest = widest_mill(part, step, tol);
  const std::string stock = left > 0 ? fmt::format(" beside {} mm of stock to leave", trimmed(left, 4)) : "";
  // Rounded down: a cutter of the size that is named has to fit.
  const std::string largest =
      widest > 0 ? "the largest that does has " + trimmed(std::floor(widest * 1000) / 1000, 3) + " mm"
                 : "leave less";
  return fmt::format("tool T{} ({} mm) does not fit {}{}; {}", tool.number, trimmed(tool.diameter, 4),
                     feature_of(part, step).name, stock, largest);
}

std::string does_not_fit(const Part& part, const Workingstep& step, const Tolerances& tol) {
  const Tool& tool = tool_of(part, step);
  const Feature& feature = feature_of(part, step);
  if (feature.chamfer) return no_room_beside_edge(feature, tool);
  const auto hole = features::round_hole_of(feature, tol);
  if (makes_holes(tool) && !hole)
    return fmt::format("tool T{} ({} {} mm) only makes round holes; {} needs a mill", tool.number,
                       name_of(tool.kind), trimmed(tool.diameter, 4), feature.name);
  if (features::leaves_hole_undone(part, step, tol)) {
    if (features::is_shallower_than_point(feature, tool, tol))
      return "tool " + point_longer_than_hole(feature, tool);
    return fmt::format(
        "tool T{0} ({1} {2} mm) makes no hole of {3} mm; give one that does, for example --tool drill:{3}",
        tool.number, name_of(tool.kind), trimmed(tool.diameter, 4), trimmed(2 * hole->radius, 4));
  }
  return no_room(part, step, tol);
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
  const bool fits = tool_of(part, step).diameter <= widest_mill(part, step, plan.tol);
  if (!fits || makes_holes(tool_of(part, step))) return does_not_fit(part, step, plan.tol);
  const std::string_view strategy = selection.candidate(i).strategy->name;
  return fmt::format("{} found no passes for {}; {}", strategy, name,
                     plan.steps[i].published_grid
                         ? "no point of the published grid lies where the cutter's centre may be; use a "
                           "smaller --stepover, or leave --grid out"
                     : strategy == "contour" ? "use a smaller cutter"
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
    for (const Remark& remark : section.remarks)
      part.diagnostics.note(feature_of(part, part.workplan[i]).name, remark.text);
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
    Diagnostics said = part.diagnostics;
    for (std::size_t i = 0; i < part.workplan.size(); ++i)
      say_not_machined(said, part.source_file, feature_of(part, part.workplan[i]).name,
                       part.workplan[i].name + ": " + no_passes(i, selection, works, plan));
    throw NothingToMachine(part.source_file, "nothing can be cut: " + no_passes(0, selection, works, plan),
                           std::move(said));
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
