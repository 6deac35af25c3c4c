#include "pipeline/check.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/text.h"
#include "features/round_hole.h"
#include "features/tool_choice.h"
#include "model/cutter_profile.h"
#include "model/results/findings.h"
#include "model/section_names.h"
#include "pipeline/copies.h"
#include "pipeline/program_feeds.h"
#include "pipeline/result_figures.h"
#include "pipeline/selection/strategies.h"
#include "pipeline/steps/certify.h"
#include "pipeline/steps/out_of_reach.h"
#include "pipeline/steps/program_conditions.h"
#include "read/gcode/gcode.h"
#include "read/gcode/recognise.h"
#include "report/sheet/sheet_facts.h"
#include "resolve/resolve.h"
#include "resolve/unreached.h"
#include "resolve/values/cutting_values.h"

namespace clearcut::pipeline {
namespace {

/// Of the given tools, those called by the program or the earlier one: a library may contain many more. All tools if
/// the program calls unknown ones.
PlanOptions with_tools_of(const Toolpath& toolpath, PlanOptions options) {
  std::set<int> called;
  for (const Section& section : toolpath.sections) called.insert(section.tool_number);
  // The earlier program may have had its own tools; a number missing among the given tools means nothing for these.
  if (options.earlier) {
    for (const Section& section : options.earlier->sections)
      if (tool_numbered(options.tools, section.tool_number)) called.insert(section.tool_number);
  }
  const auto is_called = [&](const Tool& tool) { return called.count(tool.number) > 0; };
  if (called.empty() || static_cast<std::size_t>(std::count_if(options.tools.begin(), options.tools.end(),
                                                               is_called)) != called.size())
    return options;
  for (std::size_t i = options.tools.size(); i-- > 0;) {
    if (is_called(options.tools[i])) continue;
    options.tools.erase(options.tools.begin() + static_cast<std::ptrdiff_t>(i));
    if (i < options.tool_cutting.size())
      options.tool_cutting.erase(options.tool_cutting.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return options;
}

/// One unnumbered tool given for a program that uses one tool: they are the same tool, with any number in the
/// program.
PlanOptions numbered_by(const Toolpath& toolpath, PlanOptions options) {
  if (options.tools.size() != 1 || options.tools.front().number != 0 || toolpath.sections.empty())
    return options;
  const int number = toolpath.sections.front().tool_number;
  const bool one = std::all_of(toolpath.sections.begin(), toolpath.sections.end(),
                               [&](const Section& section) { return section.tool_number == number; });
  if (one && number > 0) options.tools.front().number = number;
  return options;
}

/// A program without a T word runs with the one tool there is.
void number_sections(Toolpath& toolpath, const Part& part) {
  if (part.tools.size() != 1) return;
  for (auto& section : toolpath.sections) {
    if (section.tool_number == 0) section.tool_number = part.tools.front().number;
  }
}

bool is_cleared_or_drilled(const Feature& feature) {
  switch (feature.kind) {
    case FeatureKind::kClosedPocket:
    case FeatureKind::kOpenPocket:
    case FeatureKind::kSlot:
    case FeatureKind::kRoundHole:
      return true;
    default:
      return false;
  }
}

/// Whether the tool clears a floor up to the foot of upright walls.
bool has_sharp_end(const Tool& tool) {
  return clears_floors(tool) && flat_end(tool) >= tool.radius();
}

/// Whether one of `tools` goes into a feature, clears its floor to the foot of the walls, or leaves the fillet there, and no tool of its
/// steps does: what the program leaves out must not count as out of reach of the tools that it calls.
bool leaves_a_feature_out(const Part& part, const std::vector<Tool>& tools, const Tolerances& tol) {
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    const Feature& feature = part.features[i];
    if (!is_cleared_or_drilled(feature)) continue;
    double narrowest = std::numeric_limits<double>::infinity();
    bool keeps_fillet = false, is_sharp = false;
    for (const Workingstep& step : part.workplan) {
      if (step.feature != static_cast<int>(i)) continue;
      narrowest = std::min(narrowest, tool_of(part, step).diameter);
      keeps_fillet = keeps_fillet || features::keeps_fillet(tool_of(part, step), feature);
      is_sharp = is_sharp || has_sharp_end(tool_of(part, step));
    }
    if (!std::isfinite(narrowest)) continue;
    const double fits = features::largest_fitting_diameter(feature, tol) + tol.fit;
    const auto best = static_cast<std::size_t>(features::tool_for(feature, tools, {}, tol));
    if (narrowest > fits && tools[best].diameter <= fits) return true;
    if (!keeps_fillet && features::keeps_fillet(tools[best], feature)) return true;
    if (!is_sharp && has_sharp_end(tools[best])) return true;
  }
  return false;
}

/// Whether --rest asks one of `tools` to mill what wider ones leave, and its flutes are too short: the plan says so.
bool leaves_a_rest_out(const Part& part, const PlanOptions& asked, const Tolerances& tol) {
  if (!asked.shop.rest.value_or(false)) return false;
  return std::any_of(part.workplan.begin(), part.workplan.end(), [&](const Workingstep& step) {
    const Feature& feature = feature_of(part, step);
    if (!is_cleared_or_drilled(feature)) return false;
    // Of a short one what fits is asked last: it takes a clearance of the feature.
    double narrowest = std::numeric_limits<double>::infinity();
    for (const Tool& tool : asked.tools)
      if (clears_floors(tool) && tool.diameter < tool_of(part, step).diameter &&
          !resolve::reaches_floor(part, feature, tool))
        narrowest = std::min(narrowest, tool.diameter);
    return std::isfinite(narrowest) &&
           narrowest <= features::largest_fitting_diameter(feature, tol) + tol.fit;
  });
}

std::string name_and_size(const Tool& tool) {
  return fmt::format("T{} ({} {} mm)", tool.number, name_of(tool.kind), trimmed(tool.diameter, 3));
}

/// Whether the part as it was read has this line to engrave. Necks of T-slots are lines too, and always milled.
bool is_line_of(const Part& part, const Feature& feature) {
  if (feature.kind != FeatureKind::kEngraving) return false;
  return std::any_of(part.features.begin(), part.features.end(), [&](const Feature& one) {
    return one.kind == FeatureKind::kEngraving && one.name == feature.name;
  });
}

/// Lines of `part` that mills engrave, where one of `tools`, the given ones, is a V-bit or a ball that would: their grooves are wider.
std::vector<Condition> engraved_by_mills(const Part& part, const ResolvedPlan& plan,
                                         const std::vector<Tool>& tools) {
  std::vector<Condition> conditions;
  if (tools.empty()) return conditions;
  for (const Workingstep& step : plan.part.workplan) {
    const Feature& feature = feature_of(plan.part, step);
    const Tool& tool = tool_of(plan.part, step);
    if (!is_line_of(part, feature) || is_carved(feature, tool)) continue;
    const Tool& engraver = tools[static_cast<std::size_t>(features::tool_for(feature, tools, {}, plan.tol))];
    if (!is_carved(feature, engraver)) continue;
    conditions.push_back({"engraved-by-mill",
                          feature.name + ": " + name_and_size(tool) +
                              " cuts a groove as wide as it is; the program does not call " +
                              name_and_size(engraver) + ", which is given and engraves",
                          0, ""});
  }
  return conditions;
}

/// Decides every value of a question with other options.
using Resolver = std::function<ResolvedPlan(const PlanOptions&)>;

/// Whether the question wants all that the given tools reach: with --rest, and where what is out of reach is accepted, which no given
/// tool must then reach.
bool wants_all_in_reach(const PlanOptions& asked) {
  const std::vector<std::string>& accepted = asked.accept;
  return asked.shop.rest.value_or(false) ||
         std::find(accepted.begin(), accepted.end(), "out-of-reach") != accepted.end();
}

/// Whether a plan with all given tools has a step for what wider mills leave whose tool is not among the `called` ones.
bool has_rest_of_others(const Part& part, const std::vector<Tool>& called) {
  return std::any_of(part.workplan.begin(), part.workplan.end(), [&](const Workingstep& step) {
    return step.operation.rest && !tool_numbered(called, tool_of(part, step).number);
  });
}

/// Nothing where the part cannot be made.
std::optional<ResolvedPlan> resolved_if_made(const PlanOptions& asked, const Resolver& resolved) {
  try {
    return resolved(asked);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The question with the tools called by the program; with all given tools if the part, or one of its features, cannot be made with
/// only the called ones, because the program leaves work out. `asked` becomes the resolved options.
ResolvedPlan resolved_for(const Toolpath& toolpath, PlanOptions& asked, const Resolver& resolved) {
  PlanOptions called = with_tools_of(toolpath, asked);
  if (called.tools.size() == asked.tools.size()) return resolved(asked);
  std::optional<ResolvedPlan> plan = resolved_if_made(called, resolved);
  if (!plan || leaves_a_feature_out(plan->part, asked.tools, plan->tol) ||
      leaves_a_rest_out(plan->part, asked, plan->tol))
    return resolved(asked);
  if (wants_all_in_reach(asked)) {
    std::optional<ResolvedPlan> all = resolved_if_made(asked, resolved);
    if (all && has_rest_of_others(all->part, called.tools)) return *std::move(all);
  }
  asked = std::move(called);
  return *std::move(plan);
}

/// Values stated for the tool of a workingstep of `prepared` take precedence over those of `stated`, the step as read
/// in `part`; values requested for everything take precedence over both. Clearcut's own defaults are not binding, and
/// tools that make their hole at once may go as deep as the hole. Returns the values stated for the step.
CuttingData keep_stated_limits(Workingstep& step, Operation stated, const Part& prepared, const Part& part,
                               const PlanOptions& options) {
  if (!options.tools.empty()) {
    stated.tool = step.operation.tool;
    resolve::take_tool_cutting(stated, options);
  } else if (stated.tool != step.operation.tool) {
    resolve::change_tool(stated, step.operation.tool, part, options);
  }
  const Tool& tool = tool_of(prepared, step);
  const Feature& feature = feature_of(prepared, step);
  const bool mills = !makes_holes(tool);
  // Upright walls are finished at their whole depth, or in as many depths as were asked for.
  const bool is_wall_pass =
      step.operation.kind == OperationKind::kSideFinishing && feature.wall_slope.radians() == 0;
  if (!resolve::is_made_at_once(feature, tool) && !is_wall_pass)
    step.operation.stepdown = options.stepdown && mills ? options.stepdown : stated.stepdown;
  const auto& plunge = options.cutting.plunge_feed;
  step.operation.cutting.plunge_feed = plunge ? plunge : stated.cutting.plunge_feed;
  return stated.cutting;
}

/// Values stated for the tool of a derived step, for example the drilling before a thread.
CuttingData stated_for_tool(int number, const Part& part, const PlanOptions& options) {
  const std::vector<Tool>& tools = options.tools.empty() ? part.tools : options.tools;
  const Tool* const tool = tool_numbered(tools, number);
  if (!tool) return {};
  Operation stated;
  stated.tool = static_cast<int>(tool - tools.data());
  resolve::take_tool_cutting(stated, options);
  return stated.cutting;
}

double mm_per_min(const std::optional<MmPerMin>& feed) {
  return feed ? feed->mm_per_min() : 0;
}

/// Adds one more operation of a tool. Values requested for everything take precedence over its stated values.
void add_drive(std::map<int, verify::StatedDrive>& drives, int tool, const CuttingData& stated,
               const PlanOptions& options) {
  const CuttingData& asked = options.cutting;
  const double feed = mm_per_min(asked.feed ? asked.feed : stated.feed);
  const double most = std::max({feed, mm_per_min(asked.plunge_feed ? asked.plunge_feed : stated.plunge_feed),
                                mm_per_min(asked.ramp_feed ? asked.ramp_feed : stated.ramp_feed),
                                mm_per_min(asked.slot_feed ? asked.slot_feed : stated.slot_feed)});
  const double rpm = (asked.spindle_rpm ? asked.spindle_rpm : stated.spindle_rpm).value_or(0);
  const verify::StatedDrive one{feed > 0 ? most : 0, rpm, rpm};
  const auto [known, is_new] = drives.try_emplace(tool, one);
  if (is_new) return;
  verify::StatedDrive& all = known->second;
  all.most_feed = all.most_feed > 0 && one.most_feed > 0 ? std::max(all.most_feed, one.most_feed) : 0;
  all.most_rpm = all.most_rpm > 0 && rpm > 0 ? std::max(all.most_rpm, rpm) : 0;
  all.least_rpm = std::min(all.least_rpm, rpm);
}

/// The number behind the last point, with the point: the place of a part on a sheet; "" for other names.
std::string_view place_in(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || dot + 1 == name.size()) return {};
  const std::string_view number = name.substr(dot);
  return number.find_first_not_of("0123456789", 1) == std::string_view::npos ? number : std::string_view();
}

/// Whether `name` is that of a step that was put beside the step `of`: for tabs, for the neck of a T-slot, for what a narrower mill
/// still reaches, or for finishing.
bool follows_from(std::string_view name, std::string_view of) {
  if (const std::string_view place = place_in(of); !place.empty() && place == place_in(name)) {
    name.remove_suffix(place.size());
    of.remove_suffix(place.size());
  }
  if (!name.starts_with(of)) return false;
  std::string_view ending = name.substr(of.size());
  constexpr std::string_view kRest = "_rest_T";
  if (ending.starts_with(kRest)) {
    const std::size_t end = ending.find_first_not_of("0123456789", kRest.size());
    ending = end == std::string_view::npos ? std::string_view() : ending.substr(end);
  }
  constexpr std::string_view kEndings[] = {"", "_tabs", "_neck", "_walls", "_floor"};
  return std::find(std::begin(kEndings), std::end(kEndings), ending) != std::end(kEndings);
}

/// A program of another CAM is checked against the stated stepdown and plunge feed, not against Clearcut's defaults.
/// Returns the stated cutting data of the tools.
std::map<int, verify::StatedDrive> keep_stated_limits(Part& prepared, const Part& part,
                                                      const PlanOptions& options) {
  std::map<int, verify::StatedDrive> drives;
  for (std::size_t i = 0; i < prepared.workplan.size(); ++i) {
    // Tabs, T-slots, narrower mills and finishing put steps of their own in between, which are named after those above or after them.
    const std::string& name = prepared.workplan[i].name;
    const bool same = i < part.workplan.size() && part.workplan[i].name == name;
    const auto stated =
        same ? part.workplan.begin() + static_cast<std::ptrdiff_t>(i)
             : std::find_if(part.workplan.begin(), part.workplan.end(),
                            [&](const Workingstep& step) { return follows_from(name, step.name); });
    const int tool = tool_of(prepared, prepared.workplan[i]).number;
    const CuttingData cutting =
        stated == part.workplan.end()
            ? stated_for_tool(tool, part, options)
            : keep_stated_limits(prepared.workplan[i], stated->operation, prepared, part, options);
    add_drive(drives, tool, cutting, options);
  }
  return drives;
}

/// Values stated for tools without a workingstep: a program may use them nevertheless.
/// Adds them to `all`.
void add_other_tools(const Part& prepared, const PlanOptions& options, StatedOfTools& all) {
  auto& limits = all.limits;
  const std::size_t stating = std::min(options.tool_cutting.size(), prepared.tools.size());
  for (std::size_t i = 0; i < (prepared.is_shape_stated ? stating : prepared.tools.size()); ++i) {
    Operation stated;
    stated.tool = static_cast<int>(i);
    resolve::take_tool_cutting(stated, options);
    limits[prepared.tools[i].number] = {
        options.stepdown ? options.stepdown : stated.stepdown,
        options.cutting.plunge_feed ? options.cutting.plunge_feed : stated.cutting.plunge_feed,
        stated.cutting.spindle_clockwise != prepared.tools[i].left_hand};
    const int number = prepared.tools[i].number;
    if (all.drives.count(number) == 0) add_drive(all.drives, number, stated.cutting, options);
  }
  for (const Workingstep& step : prepared.workplan) limits.erase(tool_of(prepared, step).number);
}

/// A program's text, and its control; no control if it is recognised from the text.
struct ProgramText {
  const std::string& text;
  const std::string& name;
  std::optional<Dialect> dialect;

  /// Whether the control has no words for tools: they are loaded by hand.
  bool names_no_tools() const { return dialect && read::gcode::rules_of(*dialect).names_no_tools; }
};

/// The tools named in a program's comments, as options: "--tool endmill:6:T1 --tool drill:3:T2"; "" if there are
/// none. `called`: the tool numbers called by the program; empty if it calls no tool.
std::string tools_by_comments(const std::string& program, const std::vector<int>& called) {
  std::string text;
  for (const read::gcode::ToolComment& one : read::gcode::tools_in_comments(program)) {
    const bool is_called = std::find(called.begin(), called.end(), one.number) != called.end();
    if (!is_called && !(called.empty() && text.empty())) continue;
    text += fmt::format("{}--tool {}", text.empty() ? "" : " ", one.tool);
  }
  return text;
}

/// Throws if no tools are given, suggesting those named in the comments.
void require_tools(bool are_given, const Toolpath& toolpath, const ProgramText& program) {
  if (are_given) return;
  std::vector<int> numbers;
  std::vector<std::string> called;
  for (const int number : report::tools_called(toolpath)) {
    if (number <= 0) continue;
    numbers.push_back(number);
    called.push_back("T" + std::to_string(number));
  }
  const std::string said = tools_by_comments(program.text, numbers);
  if (called.empty())
    throw InputError(program.name, said.empty() ? "names no tool; say what cuts, for example --tool endmill:6"
                                                : "calls no tool; say what cuts, by its comments " + said);
  const std::string wanted = fmt::format("calls {}; say what {}", fmt::join(called, ", "),
                                         called.size() == 1 ? "it is" : "they are");
  if (!said.empty()) throw InputError(program.name, wanted + ", by its comments " + said);
  throw InputError(program.name, fmt::format("{}, for example --tool endmill:6:{}, or a library with --tools",
                                             wanted, called[0]));
}

void require_moves(const Toolpath& toolpath, const std::string& program_name) {
  const auto moves = [](const Section& section) { return !section.moves.empty(); };
  if (std::any_of(toolpath.sections.begin(), toolpath.sections.end(), moves)) return;
  throw InputError(program_name,
                   "moves nothing: no block goes to a place, such as G1 X10 F300, so there is nothing to "
                   "check; give the whole program");
}

/// The stated stock, else the box of the program's cuts below `stated_top`; without a stated top, below Z 0, if no
/// cut is above.
Stock stock_for(const std::optional<Stock>& stated, const Toolpath& toolpath, const std::vector<Tool>& tools,
                std::optional<double> stated_top, const std::string& program_name,
                std::vector<Condition>& conditions) {
  if (stated) return *stated;
  if (!stated_top) {
    if (const Move* const high = work_above(toolpath, 0))
      throw InputError(
          fmt::format("{}:{}", program_name, high->line),
          fmt::format("feeds along at Z {}, above Z 0, where the top of the stock is taken; state it, for "
                      "example --top {}, or the stock, for example --stock 0:100,0:60,-20:{}",
                      trimmed(high->z_to, 3), trimmed(high->z_to, 3), trimmed(high->z_to, 3)));
  }
  const double top = stated_top.value_or(0);
  const std::optional<Stock> taken = box_of_cuts(toolpath, tools, top);
  if (!taken)
    throw InputError(program_name,
                     "feeds nowhere below Z " + trimmed(top, 3) +
                         "; state the stock, for example --stock 100,60,20 or --stock 0:100,0:60,0:20");
  conditions.push_back(stock_taken(*taken));
  return *taken;
}

HandTools as_given(const std::vector<Tool>& tools) {
  HandTools by_hand{{}, "they are given"};
  for (const Tool& tool : tools) by_hand.numbers.push_back(tool.number);
  return by_hand;
}

HandTools as_worked(const Part& part) {
  HandTools by_hand{{}, kOrderOfWork};
  for (const Workingstep& step : part.workplan) by_hand.numbers.push_back(tool_of(part, step).number);
  return by_hand;
}

/// The program as its control reads it, limited to heights up to `safe_z`, mm.
Program read_program(const ProgramText& program, const PlanOptions& options, const std::vector<Tool>& tools,
                     double safe_z, HandTools usual_by_hand, double wear = 0) {
  read::gcode::ReadControllerOptions reading = reading_of(options, tools, program.name);
  reading.dialect = program.dialect;
  reading.safe_z = safe_z;
  if (reading.compensation.wear) reading.compensation.wear = wear;
  const HandTools by_hand = hand_tools_of(program.text, std::move(usual_by_hand));
  reading.hand_tools = by_hand.numbers;
  auto read = read::gcode::read_gcode(program.text, program.name, reading);
  if (by_hand.numbers.size() > 1) read.conditions.push_back(hand_tools_condition(by_hand));
  return read;
}

/// Without a part no operation states a feed.
void require_reference(const ResolvedPlan& plan, const StatedOfTools& stated) {
  if (plan.feed_rule && !plan.feed_rule->feed && stated.reference_feeds.empty())
    throw InputError("--feed-by", "say which feed is meant at the reference: add --reference-feed");
}

/// The calls of tools by the whole program.
Toolpath called_by(const Toolpath& rest, const FirstPart* first) {
  Toolpath whole;
  const auto add = [&](const Toolpath& toolpath) {
    for (const Section& section : toolpath.sections) {
      whole.sections.emplace_back();
      whole.sections.back().tool_number = section.tool_number;
    }
  };
  if (first) add(first->toolpath);
  add(rest);
  return whole;
}

/// Lets `first` have run before, where there is one.
void take_first(ResolvedPlan& plan, const FirstPart* first) {
  if (!first || first->toolpath.sections.empty()) return;
  plan.earlier = first->toolpath;
  plan.earlier_state = first->state;
}

/// Of one part, or of a sheet as one; `resolve_part` decides its values.
CheckResult check_resolved(const Part& part, const ProgramText& text, const PlanOptions& options,
                           const std::map<int, MmPerMin>& reference_feeds, const FirstPart* first,
                           const Resolver& resolve_part) {
  std::optional<ResolvedPlan> resolved;
  if (text.names_no_tools()) resolved = resolve_part(options);
  const std::vector<Tool>& tools = options.tools.empty() ? part.tools : options.tools;
  const HandTools by_hand = resolved ? as_worked(resolved->part) : HandTools{};
  auto read = read_program(text, options, tools, part.top_z(), by_hand);
  require_tools(!options.tools.empty() || !part.tools.empty(), read.toolpath, text);
  CheckResult result;
  PlanOptions asked = numbered_by(read.toolpath, options);
  const std::vector<Tool> asked_tools = asked.tools;
  if (!resolved) resolved = resolved_for(called_by(read.toolpath, first), asked, resolve_part);
  take_first(*resolved, first);
  const ResolvedPlan& plan = *resolved;
  result.part = plan.part;
  result.earlier = plan.earlier;
  StatedOfTools stated{{}, keep_stated_limits(result.part, part, asked), reference_feeds};
  add_other_tools(result.part, asked, stated);
  result.part.diagnostics.append(read.diagnostics);
  result.control = std::move(read.control);
  result.dialect = read.dialect;
  result.toolpath = std::move(read.toolpath);
  number_sections(result.toolpath, result.part);
  SectionNames(result.part).settle(result.toolpath);
  result.findings =
      check(result.part, result.toolpath, result.control, read.conditions, result.dialect, plan, stated);
  if (resolve::writes_wear(options.shop))
    check_wear(result.findings,
               {resolve::wear_range_of(options.shop), read.compensated_tools, &result.part, &result.toolpath},
               [&](double wear) {
                 auto shifted = read_program(text, options, tools, part.top_z(), by_hand, wear);
                 const Part cut = worn(result.part, read.compensated_tools, wear);
                 number_sections(shifted.toolpath, cut);
                 SectionNames(cut).settle(shifted.toolpath);
                 Findings found = check(cut, shifted.toolpath, shifted.control, shifted.conditions,
                                        shifted.dialect, plan, stated);
                 result.worn.push_back({cut, shifted.toolpath});
                 return WornProgram{std::move(shifted.toolpath), std::move(found)};
               });
  for (Condition& one : engraved_by_mills(part, plan, asked_tools))
    result.findings.conditions.push_back(std::move(one));
  add_conditions_of_part(result.part, result.toolpath, plan, result.findings);
  add_not_machined(result.part.diagnostics, result.findings);
  result.margin = margin_asked({result.part, result.toolpath, result.control}, plan, result.findings);
  return result;
}

/// The sheet of copies that the options ask for.
CheckResult check_sheet(const Part& part, const ProgramText& text, const PlanOptions& options,
                        const std::map<int, MmPerMin>& reference_feeds, const FirstPart* first) {
  SheetOfCopies sheet = sheet_of_copies(part, options);
  PlanOptions of_sheet = options;
  of_sheet.copies = {};
  of_sheet.nested.clear();
  of_sheet.tool_cutting = sheet.tool_cutting;
  CheckResult result = check_resolved(sheet.part, text, of_sheet, reference_feeds, first, sheet.resolved);
  sheet.made.sheet = result.part.stock ? result.part.stock->plan : Box{};
  count_clean_parts(result.findings, sheet.made);
  result.copies = sheet.made;
  return result;
}

/// `reference_feeds`: as check_program(). `first`: null where nothing of the same program has run before.
CheckResult check_text(const Part& part, const ProgramText& text, const PlanOptions& options,
                       const std::map<int, MmPerMin>& reference_feeds, const FirstPart* first) {
  require_copies(options.copies);
  if (options.copies.any()) return check_sheet(part, text, options, reference_feeds, first);
  return check_resolved(part, text, options, reference_feeds, first, [&](const PlanOptions& asked) {
    return resolve::resolve(part, asked, strategies_of(options));
  });
}

CheckResult check_text_alone(const std::optional<Stock>& stock, const ProgramText& text,
                             const PlanOptions& options, std::optional<double> top,
                             const std::map<int, MmPerMin>& reference_feeds, const FirstPart* first) {
  const std::string& program_name = text.name;
  require_copies(options.copies);
  if (options.copies.any()) throw InputError(options.copies.name(), "needs --part: copies are of a part");
  auto read = read_program(text, options, options.tools, stock ? stock->z_top : top.value_or(0),
                           text.names_no_tools() ? as_given(options.tools) : HandTools{});
  require_moves(read.toolpath, program_name);
  require_tools(!options.tools.empty(), read.toolpath, text);
  const PlanOptions asked = numbered_by(read.toolpath, options);
  ResolvedPlan plan = resolve::resolve_without_part(asked);
  take_first(plan, first);
  CheckResult result;
  result.part = plan.part;
  result.part.name = program_name.substr(program_name.find_last_of('/') + 1);
  result.part.diagnostics.append(read.diagnostics);
  result.control = std::move(read.control);
  result.dialect = read.dialect;
  result.toolpath = std::move(read.toolpath);
  number_sections(result.toolpath, result.part);
  auto& conditions = read.conditions;
  result.part.stock = stock_for(stock, result.toolpath, result.part.tools, top, program_name, conditions);
  for (const auto& open : {below_stock(result.toolpath, *result.part.stock),
                           doubtful_arcs(result.toolpath, result.control, asked.tol)})
    if (open) conditions.push_back(*open);
  StatedOfTools stated{{}, {}, reference_feeds};
  require_reference(plan, stated);
  add_other_tools(result.part, asked, stated);
  result.findings = check(result.part, result.toolpath, result.control, conditions, result.dialect, plan,
                          std::move(stated));
  if (const auto open = cuts_nothing(result.findings)) result.findings.conditions.push_back(*open);
  accept_conditions(result.findings, plan.accept);
  return result;
}

}  // namespace

CheckResult check_program(const Part& part, const std::string& program, const std::string& program_name,
                          const PlanOptions& options, std::optional<Dialect> dialect,
                          const std::map<int, MmPerMin>& reference_feeds) {
  return check_text(part, {program, program_name, dialect}, options, reference_feeds, nullptr);
}

CheckResult check_program_alone(const std::optional<Stock>& stock, const std::string& program,
                                const std::string& program_name, const PlanOptions& options,
                                std::optional<Dialect> dialect, std::optional<double> top,
                                const std::map<int, MmPerMin>& reference_feeds) {
  return check_text_alone(stock, {program, program_name, dialect}, options, top, reference_feeds, nullptr);
}

CheckResult check_rest(const Part& part, const FirstPart& first, const std::string& program,
                       const std::string& program_name, const PlanOptions& options,
                       std::optional<Dialect> dialect) {
  return check_text(part, {program, program_name, dialect}, options, {}, &first);
}

CheckResult check_rest_alone(const Stock& stock, const FirstPart& first, const std::string& program,
                             const std::string& program_name, const PlanOptions& options,
                             std::optional<Dialect> dialect) {
  return check_text_alone(stock, {program, program_name, dialect}, options, {}, {}, &first);
}

}  // namespace clearcut::pipeline
