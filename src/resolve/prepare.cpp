#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/error.h"
#include "base/text.h"
#include "features/derived_outlines.h"
#include "features/round_hole.h"
#include "features/standing.h"
#include "features/tool_choice.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "resolve/features/clamps.h"
#include "resolve/features/shaping.h"
#include "resolve/left_over.h"
#include "resolve/resolve.h"
#include "resolve/shaped_features.h"
#include "resolve/values/cutting_values.h"

namespace clearcut::resolve {
namespace {

/// Each workingstep is held against all others: beyond this they take minutes and more memory than a command may
/// hold.
constexpr std::size_t kMostSteps = 20000;

constexpr double kDefaultFeed = 1000;     // mm/min
constexpr double kPlungeShare = 0.3;      // share of the cutting feed
constexpr double kRampShare = 0.5;        // share of the cutting feed
constexpr double kFaceMillStepdown = 2;   // mm
constexpr double kUnpeckedDiameters = 3;  // depth of a hole / diameter of the drill
constexpr double kTappingSpeed = 8;       // m/min at the circumference

double largest_fitting_diameter_of(const Part& part, const Tolerances& tol) {
  double largest = 0;
  for (const auto& step : part.workplan) {
    const auto& feature = feature_of(part, step);
    largest = std::max(largest, features::largest_fitting_diameter(feature, tol));
  }
  return largest;
}

/// Tools used by an earlier program are not chosen again while there are others.
std::vector<char> used_before(const std::vector<Tool>& tools, const PlanOptions& options) {
  std::vector<char> used(tools.size(), 0);
  if (!options.earlier) return used;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    used[i] = std::any_of(options.earlier->sections.begin(), options.earlier->sections.end(),
                          [&](const Section& section) {
                            return section.tool_number == tools[i].number && !section.carried_below;
                          });
  }
  if (std::all_of(used.begin(), used.end(), [](char u) { return u; })) std::fill(used.begin(), used.end(), 0);
  return used;
}

/// `passed_over`, and tapered mills whose flanks would cut into the walls of others, while there are other tools.
std::vector<char> without_tapers_among_steeper_walls(const Part& part, const Feature& feature,
                                                     std::vector<char> passed_over, const Tolerances& tol) {
  const std::vector<char> before = passed_over;
  for (std::size_t i = 0; i < part.tools.size(); ++i)
    if (meets_steeper_walls(part, feature, part.tools[i], tol)) passed_over[i] = 1;
  const bool any = std::any_of(passed_over.begin(), passed_over.end(), [](char over) { return !over; });
  return any ? passed_over : before;
}

void choose_tools(Part& part, const PlanOptions& options, StepSources& sources) {
  if (!options.tools.empty()) {
    part.tools = options.tools;
    number_tools(part.tools);
    const auto used = used_before(part.tools, options);
    const auto through = features::profiles_through(part);
    for (auto& step : part.workplan) {
      const Feature& feature = feature_of(part, step);
      step.operation.tool = features::tool_for(
          feature, part.tools, without_tapers_among_steeper_walls(part, feature, used, options.tol),
          options.tol);
      if (options.tabs.any() && through.contains(step.feature))
        step.operation.tool =
            features::tool_for_tabs(feature_of(part, step), step.operation.tool, part.tools);
      step.operation.is_tool_chosen = true;
      sources[step_key(step)].set("tool", source_of(options, "tool"));
      take_tool_cutting(step.operation, options);
    }
  }
  if (part.tools.empty()) {
    throw InputError(
        part.source_file,
        fmt::format("names no tool; give one, for example --tool endmill:6 (the largest that fits has {} mm)",
                    trimmed(std::floor(largest_fitting_diameter_of(part, options.tol) * 1000) / 1000, 3)));
  }
}

/// The greatest speed permitted by both tool and machine, rpm; infinity if neither has a limit.
double most_rpm(const Tool& tool, const Machine& machine) {
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  return std::min(tool.max_spindle_rpm.value_or(kNoLimit), machine.max_spindle_rpm.value_or(kNoLimit));
}

double default_spindle(const Tool& tool, const Machine& machine) {
  const double rpm =
      std::max(10.0, std::round(kDefaultCuttingSpeed * 1000 / (kPi * 2 * widest_radius(tool)) / 10) * 10);
  const double usual = machine.max_spindle_rpm ? rpm : std::min(rpm, kUsualTopRpm);
  return std::min(std::max(usual, machine.min_spindle_rpm.value_or(0)), most_rpm(tool, machine));
}

/// Copies the values set by options into an operation, with their sources.
class OptionTaker {
 public:
  OptionTaker(Sources& sources, const PlanOptions& options) : sources_(sources), options_(options) {}

  template <typename Value, typename Target>
  void take(Target& target, const std::optional<Value>& asked, const char* name) {
    if (!asked) return;
    target = *asked;
    sources_.set(name, source_of(options_, name));
  }

 private:
  Sources& sources_;
  const PlanOptions& options_;
};

void apply_options(Operation& operation, const Tool& tool, const PlanOptions& options, Sources& sources) {
  OptionTaker taker(sources, options);
  if (!makes_holes(tool) && !works_at_once(tool))
    taker.take(operation.stepdown, options.stepdown, "stepdown");
  taker.take(operation.allowance_side, options.allowance, "allowance");
  taker.take(operation.allowance_floor, options.allowance_floor, "allowance-floor");
  taker.take(operation.entry, options.entry, "entry");
  taker.take(operation.entry_angle, options.entry_angle, "entry-angle");
  taker.take(operation.lead, options.lead, "lead");
  taker.take(operation.lead_angle, options.lead_angle, "lead-angle");
  taker.take(operation.scallop, options.scallop, "scallop");
  taker.take(operation.direction, options.direction, "direction");
  auto& cutting = operation.cutting;
  // A feed stated for a drill in a file is its plunge feed; a feed stated for all cutters is not.
  if (makes_holes(tool) && !cutting.plunge_feed && cutting.feed) {
    cutting.plunge_feed = cutting.feed;
    sources.set("plunge-feed", {Origin::kDerived, "the feed stated for the drill"});
  }
  taker.take(cutting.feed, options.cutting.feed, "feed");
  taker.take(cutting.plunge_feed, options.cutting.plunge_feed, "plunge-feed");
  taker.take(cutting.ramp_feed, options.cutting.ramp_feed, "ramp-feed");
  taker.take(cutting.slot_feed, options.cutting.slot_feed, "slot-feed");
  taker.take(cutting.spindle_rpm, options.cutting.spindle_rpm, "spindle");
  taker.take(cutting.coolant, options.cutting.coolant, "coolant");
}

/// Why no stock can be left on the feature made by the tool; "" if it can.
std::string made_to_size(const Feature& feature, const Tool& tool) {
  const bool is_drilled = feature.hole && feature.hole->kind == HoleKind::kDrilled;
  if (makes_holes(tool) || is_formed(feature) || is_drilled) return "holes are made to size";
  if (tool.kind == ToolKind::kTSlot) return "undercuts are as large as their disc";
  if (is_carved(feature, tool)) return "the cutter's shape makes it";
  return "";
}

/// Removes stock to leave if none can be left, and reports this if the user had requested it.
void leave_nothing_of_what_is_made_to_size(Part& part, Workingstep& step, Sources& sources) {
  Operation& operation = step.operation;
  const std::string why = made_to_size(feature_of(part, step), tool_of(part, step));
  if (why.empty() || (operation.allowance_side == 0 && operation.allowance_floor == 0)) return;
  operation.allowance_side = operation.allowance_floor = 0;
  sources.set("allowance", {Origin::kDerived, why});
  sources.set("allowance-floor", {Origin::kDerived, why});
  part.diagnostics.note(step.name, "no stock is left: " + why);
}

void make_at_once(Operation& operation, const Tool& tool, const Feature& feature) {
  if (is_made_at_once(feature, tool)) operation.stepdown = std::max(feature.top_z - feature.floor_z, 1e-3);
}

/// mm/min and rpm of taps: the feed is the pitch times a whole speed, regardless of other requests, and no faster
/// than the machine and the tap.
void tie_tap(Operation& operation, const Tool& tool, const PlanOptions& options, Sources& sources) {
  if (tool.kind != ToolKind::kTap) return;
  CuttingData& cutting = operation.cutting;
  double rpm =
      cutting.spindle_rpm.value_or(std::max(10.0, std::round(kTappingSpeed * 1000 / (kPi * tool.diameter))));
  if (!cutting.spindle_rpm) sources.set("spindle", {Origin::kDefault, "default: 8 m/min for taps"});
  rpm = std::min(rpm, most_rpm(tool, options.machine));
  if (options.machine.max_feed)
    rpm = std::min(rpm, std::floor(options.machine.max_feed->mm_per_min() / tool.pitch));
  cutting.spindle_rpm = std::max(1.0, std::round(rpm));
  if (*cutting.spindle_rpm < options.machine.min_spindle_rpm.value_or(0))
    throw InputError(
        operation.name,
        fmt::format("T{} taps at {} rpm and the machine turns no slower than {}: its feed would not be "
                    "the pitch; give a thread mill instead of the tap",
                    tool.number, trimmed(*cutting.spindle_rpm, 0),
                    trimmed(*options.machine.min_spindle_rpm, 0)));
  cutting.feed = cutting.plunge_feed = cutting.ramp_feed = MmPerMin::of(*cutting.spindle_rpm * tool.pitch);
  for (const char* name : {"feed", "plunge-feed", "ramp-feed"})
    sources.set(name, {Origin::kDerived, "the tap's pitch times the speed"});
}

/// mm. Half the diameter; face mills less; drills go down at once as far as their flutes clear the chips by
/// themselves, deeper holes are pecked.
double default_stepdown(const Tool& tool, const Feature& feature) {
  const double depth = feature.top_z - feature.floor_z;
  if (tool.kind == ToolKind::kFaceMill) return kFaceMillStepdown;
  if (tool.kind != ToolKind::kDrill && (makes_holes(tool) || works_at_once(tool) || is_formed(feature)))
    return std::max(depth, 1e-3);
  if (tool.kind == ToolKind::kDrill)
    return depth <= kUnpeckedDiameters * tool.diameter ? depth : tool.diameter;
  return tool.diameter / 2;
}

std::string default_stepdown_rule(const Tool& tool) {
  if (tool.kind == ToolKind::kFaceMill) return "default: 2 mm for face mills";
  if (tool.kind == ToolKind::kDrill) return "default: at once to 3 diameters, else one diameter a peck";
  if (makes_holes(tool) || works_at_once(tool)) return "default: at once";
  return "default: half the diameter";
}

/// Fills absent values, with their sources; keeps the defaulted values as texts.
class Defaults {
 public:
  explicit Defaults(Sources& sources) : sources_(sources) {}

  template <typename Value>
  void fill(std::optional<Value>& target, Value value, const char* name, Source source,
            const std::string& text = "") {
    if (target) return;
    target = value;
    sources_.set(name, std::move(source));
    if (!text.empty()) defaulted_.push_back(text);
  }
  const std::vector<std::string>& defaulted() const { return defaulted_; }

 private:
  Sources& sources_;
  std::vector<std::string> defaulted_;
};

/// No feed, even a stated one, exceeds the machine's stated limit.
void limit_feeds(CuttingData& cutting, const PlanOptions& options, Sources& sources) {
  const Machine& machine = options.machine;
  const auto keep_below = [&](std::optional<MmPerMin>& feed, MmPerMin most, const char* name,
                              const char* by) {
    if (!feed || *feed <= most) return;
    feed = most;
    sources.set(name, {Origin::kDerived, by});
  };
  const AxisValues speeds = axis_speeds(machine);
  const bool is_rapid_stated = options.sources.find("rapid") != nullptr;
  const auto limit = [&](std::optional<MmPerMin>& feed, const char* name, double rapid) {
    if (machine.max_feed) keep_below(feed, *machine.max_feed, name, "the machine's max_feed");
    if (is_rapid_stated) keep_below(feed, MmPerMin::of(rapid), name, "the machine's rapid");
  };
  const double level = std::min(speeds[0], speeds[1]);
  limit(cutting.feed, "feed", level);
  limit(cutting.plunge_feed, "plunge-feed", speeds[2]);
  limit(cutting.ramp_feed, "ramp-feed", level);
  limit(cutting.slot_feed, "slot-feed", level);
}

/// The material whose values count for the operation: the user's, else the input's where the operation has no feed or no speed; "" if none.
std::string material_for(const Part& part, const Operation& operation, const PlanOptions& options) {
  if (options.shop.material) return *options.shop.material;
  const CuttingData& cutting = operation.cutting;
  return cutting.feed && cutting.spindle_rpm ? "" : part.material.value_or("");
}

/// Applies the values of the work's material; for taps before their feed is derived from the speed. Adds messages to
/// `noted`.
void apply_material(Part& part, Workingstep& step, const PlanOptions& options, Sources& sources,
                    std::vector<std::string>& noted) {
  const Tool& tool = tool_of(part, step);
  const Feature& feature = feature_of(part, step);
  const double stepdown = step.operation.stepdown.value_or(default_stepdown(tool, feature));
  const double whole = feature.top_z - feature.floor_z;
  const double depth = is_conical(tool) ? whole : std::min(stepdown, whole);
  const FilledValues told = fill_cutting_values(
      step.operation, tool, depth, material_for(part, step.operation, options), options, sources);
  const auto is_new = [&](const std::string& text) {
    return std::find(noted.begin(), noted.end(), text) == noted.end();
  };
  for (std::string text : told.filled) {
    text += " (T" + std::to_string(tool.number) + ")";
    if (is_new(text)) part.diagnostics.note("material", text), noted.push_back(text);
  }
  for (const std::string& text : told.warnings)
    if (is_new(text)) part.diagnostics.warn("material", text), noted.push_back(text);
}

/// Whether the tool's layers leave steps on the feature's walls: true for walls with more draft than the tool's own
/// flanks.
bool leaves_steps(const Feature& feature, const Tool& tool) {
  if (feature.wall_slope.radians() <= 0 || !clears_floors(tool) || feature.chamfer || feature.carving)
    return false;
  const double flank = has_flanks(tool) ? flank_slope(tool) : 0;
  return base::tan(feature.wall_slope.radians()) > flank * (1 + 1e-9);
}

/// Fills absent values; returns the names of the defaulted values.
std::vector<std::string> apply_defaults(Workingstep& step, const Tool& tool, const Feature& feature,
                                        const PlanOptions& options, Sources& sources) {
  Defaults defaults(sources);
  Operation& operation = step.operation;
  auto& cutting = operation.cutting;
  if (path_of(step) != nullptr)
    defaults.fill(operation.stepdown, std::max(feature.top_z - feature.floor_z, 1e-3), "stepdown",
                  {Origin::kDerived, "the toolpath that the file states"});
  const double stepdown = default_stepdown(tool, feature);
  defaults.fill(operation.stepdown, stepdown, "stepdown", {Origin::kDefault, default_stepdown_rule(tool)},
                makes_holes(tool) || works_at_once(tool) || is_formed(feature)
                    ? ""
                    : "stepdown " + trimmed(stepdown, 3) + " mm");
  if (leaves_steps(feature, tool)) {
    const double scallop = Tolerances{}.scallop;
    defaults.fill(operation.scallop, scallop, "scallop",
                  {Origin::kDefault, "default: " + trimmed(scallop, 3) + " mm"});
  }
  const std::string feed = trimmed(kDefaultFeed, 0) + " mm/min";
  if ((makes_holes(tool) || tool.kind == ToolKind::kSpotDrill) && cutting.plunge_feed) {
    defaults.fill(cutting.feed, *cutting.plunge_feed, "feed",
                  {Origin::kDerived, "the plunge feed: the tool only plunges"});
  }
  defaults.fill(cutting.feed, MmPerMin::of(kDefaultFeed), "feed", {Origin::kDefault, "default: " + feed},
                "feed " + feed);
  limit_feeds(cutting, options, sources);
  defaults.fill(cutting.plunge_feed, *cutting.feed * kPlungeShare, "plunge-feed",
                {Origin::kDerived, "30 % of the feed"});
  defaults.fill(cutting.ramp_feed, *cutting.feed * kRampShare, "ramp-feed",
                {Origin::kDerived, "50 % of the feed"});
  const double rpm = default_spindle(tool, options.machine);
  defaults.fill(cutting.spindle_rpm, rpm, "spindle",
                {Origin::kDefault, "default: 100 m/min at the circumference"},
                "spindle " + trimmed(rpm, 0) + " rpm");
  defaults.fill(operation.direction, CutDirection::kClimb, "direction", {Origin::kDefault, "default: climb"});
  return defaults.defaulted();
}

/// Reports steps in which a mill takes far more at once than cutters of its diameter bear. Finishing cuts are thin,
/// as are cuts with a limit on the engagement.
void tell_of_deep_steps(const Workingstep& step, const Tool& tool, const Feature& feature,
                        const PlanOptions& options, Diagnostics& diagnostics,
                        std::vector<std::string>& told) {
  constexpr double kDeep = 2, kDeepWhereThin = 4;  // diameters
  const bool finishes = step.operation.kind == OperationKind::kFinishing ||
                        step.operation.kind == OperationKind::kSideFinishing;
  if (!mills_upright(tool) || finishes || !step.operation.stepdown) return;
  const double depth = std::min(*step.operation.stepdown, feature.top_z - feature.floor_z);
  const bool thin = options.engagement_deg && *options.engagement_deg < 90;
  if (depth <= (thin ? kDeepWhereThin : kDeep) * tool.diameter) return;
  std::string text = fmt::format(
      "T{} takes {} mm at once, {} times its diameter: a cutter of {} mm bears half of it to one "
      "diameter; a smaller stepdown keeps it whole",
      tool.number, trimmed(depth, 3), trimmed(depth / tool.diameter, 1), trimmed(tool.diameter, 3));
  if (std::find(told.begin(), told.end(), text) != told.end()) return;
  diagnostics.warn("stepdown", text);
  told.push_back(std::move(text));
}

}  // namespace

void number_tools(std::vector<Tool>& tools) {
  std::set<int> taken;
  for (const auto& tool : tools) {
    if (tool.number > 0 && !taken.insert(tool.number).second) {
      throw InputError("--tool",
                       fmt::format("two tools are numbered T{}; give each its own number", tool.number));
    }
  }
  int next = 1;
  for (auto& tool : tools) {
    if (tool.number > 0) continue;
    while (taken.count(next)) ++next;
    tool.number = next;
    taken.insert(next);
  }
}

Part with_tools(Part part, const PlanOptions& options) {
  if (options.tools.empty() && part.tools.empty()) {
    Tool tool;
    tool.number = 1;
    // Rounded down to tenths; never nothing.
    tool.diameter = std::max(std::floor(largest_fitting_diameter_of(part, options.tol) * 5) / 10, 0.1);
    part.tools = {tool};
    part.diagnostics.note(part.source_file,
                          "names no tool: an end mill of " + trimmed(tool.diameter, 1) + " mm is written");
  }
  StepSources sources;
  choose_tools(part, options, sources);
  return part;
}

bool is_made_at_once(const Feature& feature, const Tool& tool) {
  if (feature.kind == FeatureKind::kTSlot) return true;
  return feature.hole && tool.kind != ToolKind::kDrill && !clears_floors(tool);
}

/// What is made at once also goes through the stock that earlier steps leave above it for finishing.
void go_through_stock_above(Part& part, const Tolerances& tol) {
  const auto leaves_stock = [](const Workingstep& step) { return step.operation.allowance_floor > 0; };
  if (std::none_of(part.workplan.begin(), part.workplan.end(), leaves_stock)) return;
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    Workingstep& step = part.workplan[i];
    const Feature& feature = feature_of(part, step);
    if (!is_made_at_once(feature, tool_of(part, step)) || !step.operation.stepdown) continue;
    const double top = features::Standing(part, static_cast<int>(i), tol).top();
    step.operation.stepdown = std::max(*step.operation.stepdown, top - feature.floor_z);
  }
}

Part prepare(Part part, const PlanOptions& options) {
  StepSources sources;
  return prepare(std::move(part), options, sources);
}

Part prepare(Part part, const PlanOptions& options, StepSources& sources) {
  if (part.workplan.empty()) throw InputError(part.source_file, "holds nothing that can be machined");
  if (part.workplan.size() > kMostSteps) {
    throw InputError(
        part.source_file,
        fmt::format("it holds {} workingsteps, more than the {} that are planned at once; plan it "
                    "in parts, of a drawing by its layers (--layer)",
                    part.workplan.size(), kMostSteps));
  }
  sources = options.step_sources;
  add_facing(part, options);
  refuse_above_stock(part);
  take_near_drills(part, options);
  choose_tools(part, options, sources);
  mark_ways_through(part);
  shape_holes(part, options, sources);
  shape_t_slots(part, options, sources);
  part.keep_outs.insert(part.keep_outs.end(), options.keep_outs.begin(), options.keep_outs.end());
  part.predrilled.insert(part.predrilled.end(), options.predrilled.begin(), options.predrilled.end());
  for (auto& step : part.workplan)
    apply_options(step.operation, tool_of(part, step), options, sources[step_key(step)]);
  for (auto& step : part.workplan) leave_nothing_of_what_is_made_to_size(part, step, sources[step_key(step)]);
  std::vector<std::string> told;  // messages on the material
  for (auto& step : part.workplan) {
    make_at_once(step.operation, tool_of(part, step), feature_of(part, step));
    if (tool_of(part, step).kind == ToolKind::kTap)
      apply_material(part, step, options, sources[step_key(step)], told);
    tie_tap(step.operation, tool_of(part, step), options, sources[step_key(step)]);
  }
  relieve_profiles(part, options);
  shape_profiles(part, options, sources);
  shape_carvings(part, options, sources);
  lean_walls(part);
  allow_for_places_of_holes(part, options.tol);
  const std::size_t without_rest = part.workplan.size();
  add_rest_steps(part, options, sources);
  relieve_pockets(part, options);
  if (part.workplan.size() > without_rest) put_what_frees_last(part);
  if (finish_of(options.shop) != Finish::kNone) {
    add_finishing_steps(part, options, sources);
    put_what_frees_last(part);
  }
  shape_chamfers(part, options.tol);
  go_through_stock_above(part, options.tol);
  keep_out_of_clamps(part, options.tol);
  std::vector<std::string> noted;
  for (auto& step : part.workplan) {
    const auto& tool = tool_of(part, step);
    const auto& feature = feature_of(part, step);
    if (tool.kind != ToolKind::kTap) apply_material(part, step, options, sources[step_key(step)], told);
    for (auto& text : apply_defaults(step, tool, feature, options, sources[step_key(step)])) {
      text += " (T" + std::to_string(tool.number) + ")";
      if (std::find(noted.begin(), noted.end(), text) == noted.end()) noted.push_back(text);
    }
    tell_of_deep_steps(step, tool, feature, options, part.diagnostics, told);
  }
  for (const auto& text : noted) part.diagnostics.note("default", text);
  return part;
}

}  // namespace clearcut::resolve
