#include "resolve/resolve.h"

#include <algorithm>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "resolve/values/names.h"

namespace clearcut::resolve {
namespace {

/// mm; default height of crossing rapids over all remaining material.
constexpr double kCrossing = 2;
/// mm. Least stated height of crossing rapids, likewise.
constexpr double kLeastCrossing = 1;
/// Degrees; angle of helices and ramps against the plane.
constexpr double kEntryAngle = 3;
/// Degrees. Above this the cutter is taken to be in a slot.
constexpr double kSlotAngle = 150;

/// Degrees. At this engagement half of the cutter's width is cut; below it chips get thinner.
constexpr double kReferenceEngagement = 90;

/// Height of a step's crossing rapids: its retract plane, over all remaining material and the clamps near the feature.
double crossing_z(const Part& part, const Workingstep& step) {
  const Operation& operation = step.operation;
  const Box reach = box(feature_of(part, step).allowed).grown(tool_of(part, step).radius());
  for (const KeepOut& block : part.keep_outs) {
    if (block.plan.overlaps(reach) && block.top_z > part.top_z()) return part.safe_z();
  }
  const double top = part.top_z();
  const double asked = operation.retract_z.value_or(top + kCrossing);
  return std::min(part.safe_z(), std::max(asked, top + kLeastCrossing));
}

/// A machinist's choices in metal: passes at 45 % of the diameter, an engagement of 84 degrees; the cutter descends
/// along a helix; climb milling is kept; no cut at full width if clearing can avoid it.
constexpr double kMachinistStepover = 0.45;
const Source kMachinist{Origin::kDerived, "the style machinist"};

/// A choice and its source.
template <typename Value>
struct Sourced {
  Value value{};
  Source source;
};

const Source kAutoByDefault{Origin::kDefault, "default: the fastest that is certified clean"};

/// The source of a step's value, if known.
const Source* find(const StepSources& sources, const Workingstep& step, const char* name) {
  const auto found = sources.find(step_key(step));
  return found == sources.end() ? nullptr : found->second.find(name);
}

/// Chooses the source of toolpaths: the paths stated in the input if the user or the strategy of the input requests
/// them.
void choose_toolpaths(Part& part, const PlanOptions& options) {
  for (Workingstep& step : part.workplan) {
    if (!step.stated_path) continue;
    StatedPath& stated = *step.stated_path;
    stated.is_used = options.toolpaths ? *options.toolpaths == ToolpathSource::kFile : stated.is_explicit;
    if (stated.is_used || options.toolpaths) continue;
    part.diagnostics.doubt(step.name.empty() ? step.source : step.name, "not-followed",
                           "the file states a toolpath that is not used: its strategy is not EXPLICIT; "
                           "--toolpaths file uses it, --toolpaths ours says that a new one is wanted");
  }
}

/// The strategy named for a step in the part's file; an unknown one is noted.
Sourced<const StrategyEntry*> strategy_of_part(const Workingstep& step, const StrategyTable& strategies,
                                               Diagnostics& diagnostics, const Source& read_from) {
  const std::string& hint = step.operation.strategy_hint;
  if (hint == "auto") return {nullptr, read_from};
  if (const StrategyEntry* entry = strategies.find(hint)) return {entry, read_from};
  if (const StrategyEntry* entry = strategies.find(strategy_of_stepnc(hint))) return {entry, read_from};
  diagnostics.warn(
      step.name.empty() ? step.source : step.name,
      "the strategy " + hint + " is not among ours; the fastest of those that are is used (see --strategy)");
  return {nullptr, {Origin::kDefault, "default: " + hint + " is not among the strategies"}};
}

/// `of_job`: source of a job's choice; null if the job makes none.
Sourced<const StrategyEntry*> strategy_of(const Workingstep& step, const PlanOptions& options,
                                          const StrategyTable& strategies, Diagnostics& diagnostics,
                                          const Source* of_job, const Source& read_from) {
  if (path_of(step) != nullptr) return {nullptr, {Origin::kDerived, "the toolpath that the file states"}};
  const Operation& operation = step.operation;
  const StrategyEntry* by_job =
      of_job ? strategy_named(operation.strategy_hint, strategies, of_job->text) : nullptr;
  if (options.strategy) {
    const Source source = source_of(options, "strategy");
    return {strategy_named(*options.strategy, strategies, source.text), source};
  }
  if (of_job) return {by_job, *of_job};
  if (operation.strategy_hint.empty()) return {nullptr, kAutoByDefault};
  return strategy_of_part(step, strategies, diagnostics, read_from);
}

/// The stepover of the options, unless a rule of a job (`of_job`: its place) states another one for this operation.
Sourced<Stepover> stepover_of(const Operation& operation, const PlanOptions& options, const Source* of_job) {
  const Source asked = source_of(options, "stepover");
  const bool is_typed = options.stepover && asked.origin == Origin::kUser;
  const bool is_own = of_job && operation.stepover && (!options.stepover || of_job->text != asked.text);
  if (is_own && !is_typed) return {{trimmed(*operation.stepover, 9)}, *of_job};
  if (options.stepover) return {{*options.stepover}, asked};
  return {{}, {Origin::kDefault, "default: the strategy decides"}};
}

MmPerMin limited(MmPerMin feed, const Machine& machine) {
  return machine.max_feed && *machine.max_feed < feed ? *machine.max_feed : feed;
}

void resolve_feeds(ResolvedStep& step, const CuttingData& cutting, const PlanOptions& options) {
  step.feed = cutting.feed.value();
  step.plunge_feed = cutting.plunge_feed.value();
  step.ramp_feed = cutting.ramp_feed.value();
  step.lead_feed = limited(options.shop.lead_feed.value_or(step.feed), options.machine);
  step.slot_feed = cutting.slot_feed.value_or(step.feed);
  step.spindle_rpm = cutting.spindle_rpm.value();
  step.spindle_clockwise = cutting.spindle_clockwise;
  step.coolant = cutting.coolant.value_or(Coolant::kOff);
}

/// Entry if none is requested: profiles ramp along themselves, others plunge, or descend along a helix for cutters
/// that cannot plunge and with limited engagement.
EntryKind usual_entry(const Feature& feature, const Tool& tool) {
  if (feature.profile) return EntryKind::kRamp;
  return tool.center_cutting ? EntryKind::kPlunge : EntryKind::kHelix;
}

void resolve_entry(ResolvedStep& step, const Operation& operation, const Feature& feature, const Tool& tool,
                   const ShopOptions& shop) {
  step.entry = operation.entry.value_or(usual_entry(feature, tool));
  step.entry_at_limit = operation.entry.value_or(EntryKind::kHelix);
  step.entry_angle = operation.entry_angle.value_or(Radians::of_degrees(kEntryAngle));
  step.is_plunge_asked = operation.entry == EntryKind::kPlunge;
  step.zigzag_length = operation.entry_size.value_or(0);
  step.helix_widest = shop.widest_helix(operation.entry_size);
  step.helix_narrowest = shop.helix_narrowest;
}

/// mm along the path that an entry may take for one layer: more is a slip of a digit.
constexpr double kLongestDescent = 10000;

/// An entry is stated by a part's file, a job or the user.
void refuse_endless_entry(const ResolvedStep& step, const Feature& feature, const Tool& tool) {
  if (!clears_floors(tool)) return;
  const double descent = step.stepdown / base::tan(step.entry_angle.radians());
  if (descent > kLongestDescent)
    throw InputError(
        feature.name,
        fmt::format("an entry at {} degrees takes {} m for a layer of {} mm; use a larger --entry-angle",
                    trimmed(step.entry_angle.degrees(), 6), trimmed(descent / 1000, 1),
                    trimmed(step.stepdown, 4)));
  if (!step.helix_widest) return;
  const double turns = descent / (kPi * *step.helix_widest);
  if (turns > kMostHelixTurns)
    throw InputError(
        feature.name,
        fmt::format(
            "an entry helix {} mm wide takes {} turns for a layer of {} mm; use a larger --helix-diameter",
            trimmed(*step.helix_widest, 6), trimmed(std::ceil(turns), 0), trimmed(step.stepdown, 4)));
}

/// Fills unstated entry values of an operation; `sources`: sources of its values.
void take_entry_of_style(Operation& operation, const Feature& feature, const Tool& tool,
                         const PlanOptions& options, Sources& sources) {
  if (!options.shop.is_machinist() || !clears_floors(tool) || operation.entry || feature.profile) return;
  operation.entry = EntryKind::kHelix;
  sources.set("entry", kMachinist);
}

void take_style(ResolvedStep& step, const Tool& tool, const PlanOptions& options, Sources& sources) {
  // A named strategy uses its own rules.
  if (!options.shop.is_machinist() || !clears_floors(tool) || step.strategy) return;
  step.is_direction_asked = true;
  if (step.stepover.is_given()) return;
  step.stepover = {trimmed(kMachinistStepover, 2)};
  sources.set("stepover", kMachinist);
  step.aimed_engagement_deg = base::acos(1 - 2 * kMachinistStepover) * 180 / kPi;
}

/// If neither a style nor a material is stated, mills plunge and cut at their full width; the user must be informed
/// of this choice.
void tell_of_style(ResolvedPlan& plan, const PlanOptions& options) {
  if (options.shop.style || options.shop.material) return;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const ResolvedStep& step = plan.steps[i];
    const bool is_by_default = step.entry == EntryKind::kPlunge && !step.is_plunge_asked;
    if (!is_by_default || !clears_floors(tool_of(plan.part, plan.part.workplan[i]))) continue;
    plan.part.diagnostics.note(
        "default",
        "style fastest: end mills plunge straight and may cut as wide as they are; "
        "--style machinist, or a metal as --material, has a helix, 45 % stepover and climb");
    return;
  }
}

void resolve_published(ResolvedStep& step, const Workingstep& planned, const PlanOptions& options) {
  const auto own = options.step_published.find(step_key(planned));
  PublishedChoices choices = own == options.step_published.end() ? PublishedChoices{} : own->second;
  choices.merge(options.published);
  step.bisector_passages = choices.bisector_passages;
  step.sharp_reflex = choices.sharp_reflex;
  step.published_grid = choices.published_grid.value_or(false);
  step.solver = choices.solver.value_or(VisitSolver{});
}

ResolvedStep resolve_step(const Part& part, const Workingstep& planned, const PlanOptions& options) {
  const Operation& operation = planned.operation;
  ResolvedStep step;
  resolve_feeds(step, operation.cutting, options);
  resolve_entry(step, operation, feature_of(part, planned), tool_of(part, planned), options.shop);
  step.direction = operation.direction.value();
  step.stepdown = operation.stepdown.value();
  refuse_endless_entry(step, feature_of(part, planned), tool_of(part, planned));
  step.allowance_side = operation.allowance_side;
  step.allowance_floor = operation.allowance_floor;
  step.lead = operation.lead.value_or(0);
  step.lead_angle = operation.lead_angle;
  step.cross_z = crossing_z(part, planned);
  resolve_published(step, planned, options);
  return step;
}

/// Lines in the direction stated in the file for a zigzag; with other strategies they run in the fastest direction.
void resolve_strokes(ResolvedStep& step, const Operation& operation, const PlanOptions& options) {
  if (step.strategy && step.strategy->name == "zigzag") step.stroke_angle = operation.feed_direction;
  if (options.angle_deg) step.stroke_angle = Radians::of_degrees(*options.angle_deg);
}

/// The rule by which feeds follow the load; nothing if not requested. Without --feed-by its other options have no
/// effect.
std::optional<FeedRule> feed_rule_of(const ShopOptions& shop) {
  if (!shop.feed_by) return std::nullopt;
  return FeedRule{*shop.feed_by,
                  Radians::of_degrees(shop.reference_engagement_deg.value_or(kReferenceEngagement)),
                  shop.reference_feed, shop.feed_cap};
}

std::optional<MarginRule> margin_rule_of(const ShopOptions& shop) {
  if (!shop.margin && !shop.margin_at_least) return std::nullopt;
  MarginRule rule{shop.margin_at_least.value_or(0), {}};
  rule.bounds.uncut = shop.margin_uncut.value_or(rule.bounds.uncut);
  rule.bounds.gouge = shop.margin_gouge.value_or(rule.bounds.gouge);
  return rule;
}

void resolve_shop(ResolvedPlan& plan, const ShopOptions& shop) {
  plan.margin = margin_rule_of(shop);
  plan.lead_overlap = shop.lead_overlap.value_or(0);
  plan.overrun = shop.overrun.value_or(shop.stock_oversize.value_or(0));  // possible excess stock is cut, too
  plan.link_lift = shop.link_lift.value_or(0);
  plan.stock_oversize = shop.stock_oversize.value_or(0);
  plan.link_feed = shop.link_feed;
  plan.slot_angle = Radians::of_degrees(shop.slot_angle_deg.value_or(kSlotAngle));
  plan.feed_rule = feed_rule_of(shop);
  plan.finish = finish_of(shop);
  if (shop.material) plan.material = work_material_named(*shop.material);
  if (plan.material && !plan.material->has_forces()) plan.material.reset();
}

/// What the control is to compensate: all passes that finish walls.
std::optional<WearCompensation> wear_of(const Part& part, const ShopOptions& shop) {
  if (!writes_wear(shop)) return std::nullopt;
  WearCompensation wear{{}, wear_range_of(shop)};
  for (std::size_t i = 0; i < part.workplan.size(); ++i)
    if (part.workplan[i].operation.kind == OperationKind::kSideFinishing)
      wear.workingsteps.push_back(static_cast<int>(i));
  if (wear.workingsteps.empty()) return std::nullopt;
  return wear;
}

void limit_feed_rule(FeedRule& rule, const Machine& machine) {
  if (rule.feed) rule.feed = limited(*rule.feed, machine);
  if (rule.cap) rule.cap = limited(*rule.cap, machine);
}

/// Whether the source is the user or a job, not the part's own file.
bool is_asked(const Source* source) {
  return source && (source->origin == Origin::kUser || source->origin == Origin::kJobFile);
}

/// Loads can be compared if they are known and all terms are figures of a certificate.
void refuse_unknown_load(const Objective& objective, const std::optional<WorkMaterial>& material,
                         const std::string& place) {
  if (!objective.asks_load()) return;
  for (const ObjectiveTerm& term : objective.terms) {
    const std::string name = name_of(term.kind);
    if (needs_material(term.kind) && !material)
      throw InputError(place, name + " is known only for a metal; add --material, for example steel");
    if (name.starts_with("engagement"))
      throw InputError(place,
                       name + " is for the order of a tour alone; leave out force, energy, wear and climb");
  }
}

ResolvedPlan resolve_whole(const PlanOptions& options) {
  ResolvedPlan plan;
  plan.order = options.outside_in ? ContourOrder::kOutsideIn : ContourOrder::kInsideOut;
  plan.start = options.start;
  plan.engagement_deg = options.engagement_deg;
  plan.objective = parse_objective(options.objective, source_of(options, "objective").text);
  plan.search_s = options.time_s;
  plan.seed = options.seed;
  plan.threads = thread_count(options);
  resolve_shop(plan, options.shop);
  refuse_unknown_load(plan.objective, plan.material, source_of(options, "objective").text);
  if (plan.link_feed) plan.link_feed = limited(*plan.link_feed, options.machine);
  if (plan.feed_rule) limit_feed_rule(*plan.feed_rule, options.machine);
  plan.earlier = options.earlier;
  plan.earlier_state = options.earlier_state;
  plan.conditions = options.conditions;
  plan.machine = options.machine;
  plan.accept = options.accept;
  plan.post = options.post;
  plan.tol = options.tol;
  plan.cancel = options.cancel;
  plan.progress = options.progress;
  return plan;
}

}  // namespace

ResolvedPlan resolve(const Part& part, const PlanOptions& options, const StrategyTable& strategies) {
  ResolvedPlan plan = resolve_whole(options);
  StepSources sources;
  Part chosen = part;
  choose_toolpaths(chosen, options);
  plan.part = prepare(std::move(chosen), options, sources);
  for (std::size_t i = 0; i < plan.part.workplan.size(); ++i) {
    const Workingstep& planned = plan.part.workplan[i];
    const auto strategy = strategy_of(planned, options, strategies, plan.part.diagnostics,
                                      find(sources, planned, "strategy"), read_source(plan.part, planned));
    const auto stepover = stepover_of(planned.operation, options, find(sources, planned, "stepover"));
    Sources own = sources[step_key(planned)];
    own.set("strategy", strategy.source);
    own.set("stepover", stepover.source);
    take_entry_of_style(plan.part.workplan[i].operation, feature_of(plan.part, planned),
                        tool_of(plan.part, planned), options, own);
    ResolvedStep step = resolve_step(plan.part, planned, options);
    step.strategy = strategy.value;
    step.stepover = stepover.value;
    // Foil tears if a cutter leaves it in the wrong direction.
    const bool is_foil = feature_of(plan.part, planned).kind == FeatureKind::kIsolation;
    step.is_direction_asked = is_foil || is_asked(own.find("direction"));
    take_style(step, tool_of(plan.part, planned), options, own);
    resolve_strokes(step, planned.operation, options);
    plan.steps.push_back(std::move(step));
    list_step(plan, static_cast<int>(i), own, options);
  }
  plan.post.wear = wear_of(plan.part, options.shop);
  tell_of_style(plan, options);
  list_plan(plan, options);
  return plan;
}

ResolvedPlan resolve_possible(const Part& part, const PlanOptions& options, const StrategyTable& strategies) {
  const auto below = without_steps_above_stock(part, options.tol);
  Part asked = below ? *below : part;
  // What is left out may leave too much material over the rest.
  while (true) {
    ResolvedPlan plan = resolve(asked, options, strategies);
    std::optional<Part> rest = without_impossible_steps(asked, plan.part, options.tol);
    if (!rest) return plan;
    asked = std::move(*rest);
  }
}

ResolvedPlan resolve_without_part(const PlanOptions& options) {
  check(options);
  ResolvedPlan plan = resolve_whole(options);
  plan.part.is_shape_stated = false;
  plan.part.tools = options.tools;
  plan.part.keep_outs = options.keep_outs;
  plan.part.predrilled = options.predrilled;
  number_tools(plan.part.tools);
  return plan;
}

}  // namespace clearcut::resolve
