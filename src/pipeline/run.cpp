#include "pipeline/run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/error.h"
#include "base/progress_meter.h"
#include "base/text/format.h"
#include "base/work_budget.h"
#include "features/fitting.h"
#include "features/round_hole.h"
#include "geometry/boolean.h"
#include "geometry/clearance.h"
#include "kinematics/planner.h"
#include "link/sections/slot_feed.h"
#include "model/results/not_machined.h"
#include "model/section_names.h"
#include "pipeline/certify.h"
#include "pipeline/contour_results.h"
#include "pipeline/idle_options.h"
#include "pipeline/margin.h"
#include "pipeline/selection/rapids_over_rests.h"
#include "pipeline/selection/selection.h"
#include "pipeline/selection/strategies.h"
#include "pipeline/steps/load_feeds.h"
#include "pipeline/steps/out_of_reach.h"
#include "pipeline/steps/rounded_places.h"
#include "pipeline/steps/section_order.h"
#include "pipeline/steps/step_work.h"
#include "pipeline/steps/work_share.h"
#include "plan/common/clearing_area.h"
#include "plan/common/layers.h"
#include "plan/common/leaves_nothing.h"
#include "plan/common/walls.h"
#include "plan/contour/entries.h"
#include "plan/contour/step_rule.h"
#include "plan/profile/profile.h"
#include "post/post.h"
#include "read/gcode/gcode.h"
#include "resolve/prepare.h"
#include "resolve/refusals.h"
#include "resolve/resolve.h"

namespace clearcut::pipeline {
namespace {

/// mm. What others cleared may hold residuals up to this thick: no place for rapids.
constexpr double kResidualOfOthers = 0.01;

/// Share of the rim's length times the radius that is reached beyond it, at least: corners reach less than straight
/// walls.
constexpr double kBeyondRim = 0.9;

/// What bounds the length of any strategy, layer by layer.
class Sizes {
 public:
  explicit Sizes(const Tolerances& tol) : tol_(tol) {}

  void add(StepPlan& plan, const Layer& layer, const LayerPasses& passes) {
    double rim = 0;
    for (const auto& region : passes.legal) {
      for (const auto& edge : region.edges()) rim += edge.length();
    }
    const bool pocket = plan::closed_all_round(layer);
    plan.size.reached_mm2 += pocket ? area(passes.legal) + kBeyondRim * layer.tool_radius * rim
                                    : reached_of_open(layer, passes.legal);
    plan.size.legal_rim_mm += rim;
    plan.size.edges = std::max(plan.size.edges, edge_count(passes.legal));
    plan.pocket = plan.pocket && pocket;
  }

 private:
  /// Layers mostly differ from the one before in height alone.
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

/// The passes of a workingstep layer by layer; what they clear and whether they leave anything goes into `plan`.
std::vector<LayerPasses> passes_of(const StepWork& work, const Feature& feature,
                                   const StrategyCandidate& candidate, const ResolvedPlan& job,
                                   StepPlan& plan) {
  const auto strategy = strategy_for(candidate, job.steps[static_cast<std::size_t>(work.workingstep)], job);
  std::vector<LayerPasses> passes;
  Sizes sizes(job.tol);
  for (const auto& layer : work.layers) {
    throw_if_cancelled(job.cancel);
    passes.push_back(feature.profile    ? plan::profile::plan_profile(layer.layer, *feature.profile, job.tol)
                     : layer.walls_only ? plan::plan_walls(layer.layer, job.tol)
                                        : strategy(layer.layer));
    passes.back().wall_top = work.wall_top;
    if (work.meets_others && plan.leaves_nothing && candidate.as_rival)
      plan.leaves_nothing = plan::leaves_nothing(passes.back(), layer.layer.tool_radius);
    if (layer.rest) passes.back().residual = std::max(passes.back().residual, kResidualOfOthers);
    sizes.add(plan, layer.layer, passes.back());
    plan.rest = plan.rest || layer.rest;
  }
  return passes;
}

/// s, as the planner of the control needs that the program is for.
double time_on_machine(const Section& section, const ResolvedPlan& job) {
  return kinematics::planned_time(section.moves, post::path_control_of(post_options_of(job)), job.machine,
                                  planner_of_control(job))
      .seconds();
}

/// What a strategy makes of one workingstep in so many steps of work. Throws OutOfWork where that is too much.
StepPlan plan_step(const StepWork& work, const StrategyCandidate& candidate, const ResolvedPlan& job,
                   std::uint64_t most_work) {
  const ResolvedStep& step = job.steps[static_cast<std::size_t>(work.workingstep)];
  const WorkBudget budget(most_work);
  StepPlan plan;
  const auto& feature = feature_of(job.part, job.part.workplan[static_cast<std::size_t>(work.workingstep)]);
  if (work.hole) {
    plan.section = *work.hole;
    plan.hole = true;
  } else {
    const auto passes = passes_of(work, feature, candidate, job, plan);
    const EntryKind entry =
        !feature.profile && candidate.strategy->limits_engagement ? step.entry_at_limit : step.entry;
    plan.hole = feature.profile.has_value();
    plan.section = link_step(passes, work.workingstep, entry, job);
  }
  plan.time_s = time_on_machine(plan.section, job);
  return plan;
}

std::vector<SelectionStep> selection_steps(const ResolvedPlan& plan, const StrategyTable& strategies) {
  std::vector<SelectionStep> steps;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const auto& step = plan.part.workplan[i];
    steps.push_back({feature_of(plan.part, step).name, static_cast<int>(i), tool_of(plan.part, step).radius(),
                     plan.steps[i].feed, candidates_for(plan.steps[i], plan, strategies)});
  }
  return steps;
}

/// A cone has no size that fits beside any edge: how wide it is at the top of the chamfer decides.
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
  if (features::only_plunges(tool_of(part, step)) && !features::round_hole_of(feature_of(part, step), tol)) {
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

/// Edges of an outline beyond which rivals are not tried: their time would be felt.
constexpr std::size_t kMostEdgesForRivals = 400;

/// The plan of a candidate, or of a rival that is faster.
StepPlan fastest_plan(const StepWork& work, const StrategyCandidate& candidate, const ResolvedPlan& job,
                      const StrategyTable& strategies, std::uint64_t most_work) {
  const Part& part = job.part;
  StepPlan best = plan_step(work, candidate, job, most_work);
  const auto& feature = feature_of(part, part.workplan[static_cast<std::size_t>(work.workingstep)]);
  const bool alone =
      !candidate.beside_rivals || best.hole || edge_count(feature.allowed) > kMostEdgesForRivals;
  if (alone || best.section.moves.empty()) return best;
  for (const auto& name : candidate.strategy->rivals) {
    const StrategyEntry* rival = strategies.find(name);
    if (!rival) continue;
    try {
      StepPlan plan = plan_step(work, {rival, {}, false, false, true}, job, most_work);
      if (plan.section.moves.empty() || plan.time_s >= best.time_s || !plan.leaves_nothing) continue;
      best.section = std::move(plan.section);
      best.time_s = plan.time_s;
    } catch (const OutOfWork&) {
      continue;  // the candidate itself stands
    }
  }
  return best;
}

/// Whether passes are joined at depth faster than they are cut. (Within one stroke the planner knows what is cut.)
bool has_fast_links(const ResolvedStep& step, const ResolvedPlan& plan) {
  return plan.link_feed && step.feed < *plan.link_feed;
}

/// Slows down wherever a step with a slot feed is in the material all round, and a fast link in any, given all that runs
/// before.
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

/// `over_rests`: rapids stay above all that the passes leave.
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
  return toolpath;
}

/// As text, in thousands.
std::string thousands(std::uint64_t steps) {
  return fmt::format("{} thousand steps of work", steps / 1000);
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
  if (!fits || features::only_plunges(tool_of(part, step))) return does_not_fit(part, step, plan.tol);
  return fmt::format("{} found no passes for {}; {}", selection.candidate(i).strategy->name, name,
                     plan.steps[i].published_grid
                         ? "no point of the published grid lies where the cutter's centre may be; use a "
                           "smaller --stepover, or leave --grid out"
                         : "use another --strategy, for example contour");
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

/// Degrees. So much more than the limit in a figure is no fault.
constexpr double kFaultlessExcess = 2;

/// Whether another plan of a workingstep may do without the fault. The workingsteps of one feature share its name, and where
/// its walls are finished beyond the limit of engagement the clearing before them is none the worse.
bool may_be_avoided(const Fault& fault, const FeatureFindings& step, const ResolvedPlan& plan) {
  if (fault.feature != step.name || !row_of(fault.kind).by_strategy) return false;
  return fault.kind != FaultKind::kOverEngagement ||
         step.figures.engagement.max_deg > plan.engagement_deg.value_or(0) + kFaultlessExcess;
}

/// Takes the next best plan of every workingstep that was not certified clean. False when there was nothing to do.
bool retry_unclean(Selection& selection, const ResolvedPlan& plan, PlanResult& result) {
  bool retried = false;
  for (const auto& feature : result.findings.features) {
    if (feature.figures.clean || feature.workingstep < 0) continue;
    const auto& faults = result.findings.faults;
    if (std::none_of(faults.begin(), faults.end(),
                     [&](const Fault& fault) { return may_be_avoided(fault, feature, plan); }))
      continue;
    const auto i = static_cast<std::size_t>(feature.workingstep);
    const Tool& tool = tool_of(result.part, result.part.workplan[i]);
    if (tool.corner_radius >= tool.radius()) continue;  // no passes leave a floor flat
    if (!selection.next(i)) continue;
    const StrategyCandidate& next = selection.candidate(i);
    result.part.diagnostics.note(
        feature.name, "was not certified clean at first and is planned again: " + next.strategy->name +
                          (next.stepover.is_given() ? ", stepover " + next.stepover.text : ""));
    retried = true;
  }
  return retried;
}

/// Whether rapids meet what passes leave by design, so that the program is linked again with rapids over that; said in the
/// diagnostics. False when they are over it already.
bool begin_to_go_over_rests(bool& over_rests, const Selection& selection, const ResolvedPlan& plan,
                            PlanResult& result) {
  const int met = result.findings.all.rapid_in_material;
  if (over_rests || met == 0 || !may_leave_material(selection, plan)) return false;
  over_rests = true;
  result.part.diagnostics.note(
      "plan", fmt::format("{} would meet what the passes before leave: rapids end above it, the rest is fed",
                          met == 1 ? "1 rapid" : fmt::format("{} rapids", met)));
  return true;
}

/// What a step asks for that its strategy has not: "" where all is used.
std::string unused_choice(const ResolvedStep& step) {
  const std::string name = step.strategy ? step.strategy->name : "auto";
  const bool has_contours = name == "contour" || plan::contour::contour_rule(name, {});
  if (step.bisector_passages && !has_contours)
    return fmt::format("--passage is for contour strategies, '{}' is planned", name);
  if ((step.published_grid || step.solver.is_published) && name != "tour")
    return fmt::format("--grid and --solver published are for the strategy tour, '{}' is planned", name);
  return "";
}

/// Says where the named strategy cuts both ways though a direction is asked for: only its passes along walls keep it.
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

/// Says which O word is written where nobody chose one: a control may hold another program by that number.
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

/// Options of one kind of strategy, asked for with another, are refused where no step can use them, and else said.
void refuse_what_means_nothing(const ResolvedPlan& plan, Diagnostics& diagnostics) {
  std::size_t unused = 0;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const std::string text = unused_choice(plan.steps[i]);
    if (text.empty()) continue;
    if (++unused == plan.steps.size()) throw InputError("plan", text + "; add --strategy");
    diagnostics.warn(plan.part.workplan[i].name, text);
  }
}

/// How many candidates the selection may plan before any fallback.
std::size_t candidates_in(const std::vector<SelectionStep>& steps) {
  std::size_t count = 0;
  for (const SelectionStep& step : steps) count += step.candidates.competing.size();
  return count;
}

}  // namespace

PlanResult plan_part(const Part& part, const resolve::PlanOptions& options) {
  const StrategyTable& strategies = strategies_of(options);
  ResolvedPlan whole = resolve::resolve(part, options, strategies);
  if (const auto rest = resolve::without_impossible_steps(part, whole.part, options.tol))
    whole = resolve::resolve(*rest, options, strategies);
  const ResolvedPlan plan = std::move(whole);
  PlanResult result;
  result.part = plan.part;
  result.values = plan.values;
  result.earlier = plan.earlier;
  resolve::refuse_what_cannot_be(result.part, options);
  resolve::tell_of_shallow(result.part, options.tol);
  refuse_what_means_nothing(plan, result.part.diagnostics);
  warn_of_both_ways(plan, result.part.diagnostics);
  tell_program_number(plan, result.part.diagnostics);
  ProgressMeter meter(options.progress, options.cancel);
  const auto works = step_works(plan);
  const auto shares = work_shares(works, plan);
  const auto planner = [&](int step, const StrategyCandidate& candidate) {
    const auto i = static_cast<std::size_t>(step);
    StepPlan planned = fastest_plan(works[i], candidate, plan, strategies, shares[i]);
    meter.add();
    return planned;
  };
  const auto steps = selection_steps(plan, strategies);
  meter.begin(Stage::kPlanning, candidates_in(steps));
  Selection selection(steps, planner, plan.threads);
  report_what_does_not_fit(result.part, selection, works, plan);
  Toolpath toolpath;
  bool over_rests = false;
  do {
    throw_if_cancelled(plan.cancel);
    toolpath = toolpath_of(selection, plan, over_rests);
    certify(result, toolpath, plan);
  } while (retry_unclean(selection, plan, result) ||
           begin_to_go_over_rests(over_rests, selection, plan, result));
  add_conditions_of_part(result.part, plan, result.findings);
  add_not_machined(result.part.diagnostics, result.findings);
  explain_rounded_places(result, plan);
  result.margin = margin_asked({result.part, result.toolpath, result.control}, plan, result.findings);
  sign(result, toolpath, plan);
  report_notes(selection, works, plan, result.part);
  result.contours = contours_of(toolpath, plan);
  report_rho(result.contours, plan, result.part);
  result.selections = selection.selections();
  refuse_idle_options(result, toolpath, plan, options);
  result.planned = std::move(toolpath);
  return result;
}

}  // namespace clearcut::pipeline
