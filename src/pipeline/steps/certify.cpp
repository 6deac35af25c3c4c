#include "pipeline/steps/certify.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "base/version.h"
#include "features/derived_outlines.h"
#include "features/round_hole.h"
#include "link/link.h"
#include "link/sections/high_rapids.h"
#include "model/results/findings.h"
#include "model/section_names.h"
#include "pipeline/steps/corner_tolerances.h"
#include "pipeline/steps/program_conditions.h"
#include "post/post.h"
#include "post/words/comment.h"
#include "read/gcode/gcode.h"
#include "read/gcode/recognise.h"
#include "report/result.h"
#include "verify/verify.h"

namespace clearcut::pipeline {
namespace {

/// Hexadecimal digits of a hash in a header.
constexpr std::size_t kHashShown = 16;

/// Lengths of a header, in the program's unit.
struct Lengths {
  bool inch = false;

  double of(double mm) const { return inch ? mm / kMmPerInch : mm; }
  const char* unit() const { return inch ? "IN" : "MM"; }
  std::string place(double mm) const { return trimmed(of(mm), inch ? 4 : 3); }
  std::string error(double mm) const { return fmt::format("{:.{}f} {}", of(mm), inch ? 5 : 4, unit()); }
};

std::string stock_line(const Part& part, const Lengths& lengths) {
  if (!part.stock) return "STOCK: NOT GIVEN";
  const auto& stock = *part.stock;
  const auto range = [&](double low, double high) {
    return lengths.place(low) + " TO " + lengths.place(high);
  };
  return fmt::format("STOCK: X {} Y {} Z {} {}", range(stock.plan.min.x, stock.plan.max.x),
                     range(stock.plan.min.y, stock.plan.max.y), range(stock.z_bottom, stock.z_top),
                     lengths.unit());
}

/// Characters; every control takes a comment as long in one line.
constexpr std::size_t kConditionLine = 60;
/// Characters reserved for the number of further kinds.
constexpr std::size_t kForMore = 9;

/// Each kind of condition once, with its number of occurrences: "2 X OUT-OF-REACH (AT MOST ...)".
std::vector<std::string> kinds_of(const std::vector<Condition>& conditions) {
  std::vector<std::string> kinds;
  std::map<std::string, int> counts;
  for (const Condition& one : conditions) {
    const std::string kind = one.name + (one.met_by.empty() ? "" : " (" + one.met_by + ")");
    if (++counts[kind] == 1) kinds.push_back(kind);
  }
  for (std::string& kind : kinds)
    if (const int count = counts[kind]; count > 1) kind = fmt::format("{} X {}", count, kind);
  return kinds;
}

/// "NONE", or the first few kinds.
std::string condition_line(const Findings& findings) {
  std::string text = "CONDITIONS:";
  const std::vector<std::string> kinds = kinds_of(findings.conditions);
  if (kinds.empty()) return text + " NONE";
  std::size_t shown = 0;
  for (; shown < kinds.size(); ++shown) {
    const std::string more = (shown > 0 ? ", " : " ") + kinds[shown];
    const std::size_t room = kConditionLine - (shown + 1 < kinds.size() ? kForMore : 0);
    if (shown > 0 && text.size() + more.size() > room) break;
    text += more.substr(0, room - text.size());
  }
  if (shown < kinds.size()) text += fmt::format(", {} MORE", kinds.size() - shown);
  return text;
}

/// The certificate in short lines, always as many: the numbered places of the findings must stay true.
std::vector<std::string> verdict_lines(const Findings* findings, const std::string& motion_hash,
                                       const Lengths& lengths) {
  if (findings == nullptr) return {"CERTIFICATE: PENDING", "-", "-", "-", "-", "-", "-"};
  const Figures& all = findings->all;
  return {fmt::format("CERTIFICATE: {}", name_of(verdict_of(*findings))),
          condition_line(*findings),
          "LEFT UNCUT: BELOW " + lengths.error(all.uncut_thickness_mm),
          "GOUGE: " + lengths.error(all.gouge_mm),
          fmt::format("RAPIDS IN MATERIAL: {}", all.rapid_in_material),
          fmt::format("TIME: {:.1f} S", all.time_s),
          fmt::format("MOTION SHA-256: {}", motion_hash.substr(0, kHashShown))};
}

/// The tools called by the program, in the order of the part's tools.
std::vector<std::string> tool_lines(const Part& part, const Toolpath& toolpath, bool inch) {
  std::vector<std::string> lines;
  for (const Tool& tool : part.tools) {
    const bool called =
        std::any_of(toolpath.sections.begin(), toolpath.sections.end(),
                    [&](const Section& section) { return section.tool_number == tool.number; });
    if (!called) continue;
    lines.push_back(fmt::format("TOOL T{}: {} {}{}", tool.number, name_of(tool.kind),
                                post::size_text(tool.diameter, inch), post::shape_words(tool, inch)));
  }
  return lines;
}

/// One line for each title of a remark and feature.
std::vector<std::string> remark_lines(const Toolpath& toolpath) {
  std::vector<std::string> lines;
  for (const Section& section : toolpath.sections) {
    for (const Remark& remark : section.remarks) {
      std::string line = remark.title + ": " + section.label;
      if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(std::move(line));
    }
  }
  return lines;
}

std::vector<std::string> header(const Part& part, const Toolpath& toolpath, const Findings* findings,
                                const std::string& motion_hash, bool inch) {
  const Lengths lengths{inch};
  std::vector<std::string> lines{fmt::format("PART: {}", part.name), stock_line(part, lengths)};
  for (auto& line : tool_lines(part, toolpath, inch)) lines.push_back(std::move(line));
  lines.push_back(fmt::format("WRITTEN BY CLEARCUT {}", kVersion));
  for (auto& line : verdict_lines(findings, motion_hash, lengths)) lines.push_back(std::move(line));
  for (const auto& name : names_not_machined(part.diagnostics)) lines.push_back("NOT MACHINED: " + name);
  for (auto& line : remark_lines(toolpath)) lines.push_back(std::move(line));
  return lines;
}

bool same_moves(const Toolpath& a, const Toolpath& b) {
  const auto same_move = [](const Move& m, const Move& n) {
    return m.path == n.path && m.z_from == n.z_from && m.z_to == n.z_to && m.kind == n.kind &&
           m.feed == n.feed && m.line == n.line;
  };
  return std::equal(a.sections.begin(), a.sections.end(), b.sections.begin(), b.sections.end(),
                    [&](const Section& s, const Section& t) {
                      return s.tool_number == t.tool_number &&
                             std::equal(s.moves.begin(), s.moves.end(), t.moves.begin(), t.moves.end(),
                                        same_move);
                    });
}

/// Findings and the motion's hash are written into the header of a checked program.
std::string post_with(const Findings* findings, const std::string& motion_hash, const Toolpath& toolpath,
                      const Part& part, const ResolvedPlan& plan,
                      const std::vector<double>& corner_tolerances) {
  PostOptions post_options = post_options_of(plan);
  post_options.corner_tolerances = corner_tolerances;
  post_options.header = header(part, toolpath, findings, motion_hash, post_options.inch);
  if (post_options.program_name.empty()) post_options.program_name = part.name;
  return post::write_program(toolpath, part, post_options);
}

}  // namespace

std::string unchecked_program(const Toolpath& planned, const Part& part, const ResolvedPlan& plan) {
  return post_with(nullptr, "", planned, part, plan, {});
}

PostOptions post_options_of(const ResolvedPlan& plan) {
  PostOptions post = plan.post;
  const AxisValues speeds = axis_speeds(plan.machine);  // the control slows each axis down to its own
  post.rapid = MmPerMin::of(std::max({speeds[0], speeds[1], speeds[2]}));
  if (!post.spindle_wait && plan.machine.spindle_wait_s > 0)
    post.spindle_wait = Seconds::of(plan.machine.spindle_wait_s);
  const auto& numbered = plan.machine.program_number;
  if (!post.program_number && numbered && post::program_number_of(post.dialect, post.program_name))
    post.program_number = numbered;
  const auto& accepted = plan.accept;
  post.continuous = std::find(accepted.begin(), accepted.end(), "blending") != accepted.end();
  return post;
}

std::optional<MotionPlanner> planner_of_control(const ResolvedPlan& plan) {
  const auto dialect = read::gcode::dialect_named(plan.post.dialect);
  return dialect ? std::optional(read::gcode::planner_of(*dialect)) : std::nullopt;
}

namespace {

/// Distance from corners, in ranges of wear, at which a control begins and ends the compensation of a pass: beside a corner of 30
/// degrees the shifted pass ends 3.7 ranges before the corner.
constexpr double kRangesFromCorners = 4;

/// mm; 0: a pass that the control does not shift may begin anywhere.
double lead_from_corners(const ResolvedPlan& plan, int workingstep) {
  const auto& wear = plan.post.wear;
  return wear && wear->shifts(workingstep) ? kRangesFromCorners * wear->range : 0;
}

}  // namespace

link::LinkOptions link_options(const ResolvedPlan& plan, int workingstep, EntryKind entry) {
  const ResolvedStep& step = plan.steps.at(static_cast<std::size_t>(workingstep));
  const Tool& tool = tool_of(plan.part, plan.part.workplan.at(static_cast<std::size_t>(workingstep)));
  link::LinkOptions link;
  link.tool_radius = tool.radius();
  link.safe_z = plan.part.safe_z();
  link.cross_z = step.cross_z;
  link.direction = step.direction;
  link.spindle_clockwise = step.spindle_clockwise;
  link.feed = step.feed;
  link.plunge_feed = step.plunge_feed;
  link.ramp_feed = step.ramp_feed;
  link.entry = entry;
  link.entry_angle = step.entry_angle;
  link.may_plunge = tool.center_cutting;
  link.helix_widest = step.helix_widest;
  link.helix_narrowest = step.helix_narrowest;
  link.zigzag_length = step.zigzag_length;
  link.lead = {step.lead, step.lead_angle, plan.lead_overlap, lead_from_corners(plan, workingstep)};
  link.lead_feed = step.lead_feed;
  link.link_feed = plan.link_feed;
  link.link_lift = plan.link_lift;
  link.predrilled = features::holes_before(plan.part, workingstep, plan.tol);
  if (plan.part.stock) link.stock = plan.part.stock->plan;
  link.beside_stock = features::clear_of_raw_stock(tool.radius()) + plan.stock_oversize;
  link.above_material += plan.stock_oversize;
  link.machine = plan.machine;
  return link;
}

void describe(Section& section, int workingstep, const ResolvedPlan& plan) {
  const auto index = static_cast<std::size_t>(workingstep);
  const ResolvedStep& step = plan.steps.at(index);
  section.label = feature_of(plan.part, plan.part.workplan.at(index)).name;
  section.workingstep = workingstep;
  section.tool_number = tool_of(plan.part, plan.part.workplan.at(index)).number;
  section.spindle_rpm = step.spindle_rpm;
  section.spindle_clockwise = step.spindle_clockwise;
  section.coolant = step.coolant;
}

/// Distances of the contours from the walls, ascending; of contour-parallel passes only.
std::vector<double> contour_levels(const std::vector<LayerPasses>& layers) {
  std::vector<double> levels;
  for (const LayerPasses& layer : layers) {
    if (layer.strategy != "contour") continue;
    for (const Pass& pass : layer.passes) {
      if (pass.closed && pass.offset > 0) levels.push_back(pass.offset);
    }
  }
  std::sort(levels.begin(), levels.end());
  const auto same = [](double a, double b) { return b - a < kSamePlaceMm; };
  levels.erase(std::unique(levels.begin(), levels.end(), same), levels.end());
  return levels;
}

namespace {

/// Each remark once, in the order of the layers.
std::vector<Remark> remarks_on(const std::vector<LayerPasses>& layers) {
  std::vector<Remark> remarks;
  for (const LayerPasses& layer : layers) {
    for (const Remark& remark : layer.remarks)
      if (std::find(remarks.begin(), remarks.end(), remark) == remarks.end()) remarks.push_back(remark);
  }
  return remarks;
}

}  // namespace

Section link_step(const std::vector<LayerPasses>& passes, int workingstep, EntryKind entry,
                  const ResolvedPlan& plan) {
  const link::LinkOptions options = link_options(plan, workingstep, entry);
  Section section = link::link_layers(passes, options, plan.tol);
  const auto& profile =
      feature_of(plan.part, plan.part.workplan[static_cast<std::size_t>(workingstep)]).profile;
  if (profile) {
    link::rise_over_tabs(section, profile->tabs, options.tool_radius, options.plunge_feed);
    link::feed_across_tabs(section, profile->tabs, options.tool_radius,
                           options.link_feed.value_or(options.feed));
  }
  describe(section, workingstep, plan);
  section.contours = contour_levels(passes);
  section.remarks = remarks_on(passes);
  return section;
}

HandTools hand_tools_of(std::string_view program, HandTools usual) {
  HandTools said{read::gcode::tools_announced(program), "that its comments name"};
  const auto is_known = [&](int number) {
    return std::find(usual.numbers.begin(), usual.numbers.end(), number) != usual.numbers.end();
  };
  const bool all_known = std::all_of(said.numbers.begin(), said.numbers.end(), is_known);
  HandTools tools = said.numbers.empty() || !all_known ? std::move(usual) : std::move(said);
  std::erase_if(tools.numbers, [](int number) { return number <= 0; });
  tools.numbers.erase(std::unique(tools.numbers.begin(), tools.numbers.end()), tools.numbers.end());
  return tools;
}

Condition hand_tools_condition(const HandTools& tools) {
  return {"tool-by-hand",
          fmt::format("the tools are put in by hand in the order {}, one at each pause: T{}", tools.order,
                      fmt::join(tools.numbers, ", T")),
          0};
}

verify::LoadReference load_reference_of(const ResolvedPlan& plan) {
  verify::LoadReference reference{*plan.feed_rule};
  for (const ResolvedStep& step : plan.steps) reference.feed_of_step.push_back(step.feed);
  return reference;
}

verify::VerifyOptions verify_options(const ResolvedPlan& plan) {
  verify::VerifyOptions verify;
  verify.tol = plan.tol;
  verify.machine = plan.machine;
  verify.engagement_limit_deg = plan.engagement_deg;
  verify.threads = plan.threads;
  verify.cancel = plan.cancel;
  verify.progress = plan.progress;
  if (plan.earlier) verify.earlier = &*plan.earlier;
  if (plan.earlier && !plan.earlier_state.control.spans.empty())
    verify.earlier_control = &plan.earlier_state.control;
  verify.material = plan.material;
  if (plan.feed_rule) verify.reference = load_reference_of(plan);
  return verify;
}

Program read_back(const std::string& program, const Toolpath& planned, const ResolvedPlan& plan,
                  double wear) {
  read::gcode::ReadControllerOptions reading;
  reading.dialect = read::gcode::dialect_named(plan.post.dialect);
  reading.home_z = home_z(plan.machine);
  reading.safe_z = plan.part.top_z();
  if (plan.post.wear) {
    reading.compensation.wear = wear;
    reading.compensation.is_stated = true;
  }
  HandTools usual{{}, kOrderOfWork};
  for (const Section& section : planned.sections) usual.numbers.push_back(section.tool_number);
  const HandTools tools = hand_tools_of(program, std::move(usual));
  reading.hand_tools = tools.numbers;
  auto read = read::gcode::read_gcode(program, "program", reading);
  if (tools.numbers.size() > 1 && reading.dialect == Dialect::kMarlin)
    read.conditions.push_back(hand_tools_condition(tools));
  return read;
}

namespace {

bool has_wrong_units(const Findings& findings) {
  return std::any_of(findings.faults.begin(), findings.faults.end(),
                     [](const Fault& fault) { return fault.kind == FaultKind::kUnits; });
}

/// Conditions on feeds and paths of the wrong size are not separate conditions.
void drop_what_follows_from_units(Findings& findings) {
  std::erase_if(findings.conditions, [](const Condition& one) {
    return one.name == "far-move" || one.name == "chip-load" || one.name == "stated-feed" ||
           one.name == "cuts-nothing";
  });
}

/// A tool length reported as a fault is not an open condition as well: the sentence of the fault states how to accept
/// it.
void drop_what_lengths_say(Findings& findings, const std::vector<std::string>& accepted) {
  const auto is_length = [](const Fault& fault) { return fault.kind == FaultKind::kToolLength; };
  if (std::none_of(findings.faults.begin(), findings.faults.end(), is_length)) return;
  std::erase_if(findings.conditions, [&](const Condition& one) {
    const bool is_said = one.name.starts_with("tool-length-h") || one.name == "tool-length-off";
    return is_said && std::find(accepted.begin(), accepted.end(), one.name) == accepted.end();
  });
}

/// Cuts of earlier programs count only if those programs were correct themselves.
void add_earlier(Findings& findings, const ResolvedPlan& plan) {
  const EarlierState& earlier = plan.earlier_state;
  for (Condition one : earlier.conditions) {
    if (one.name == "blending" && plan.machine.path_tolerance) one.met_by = "machine file";
    findings.conditions.push_back(std::move(one));
  }
  findings.faults.insert(findings.faults.end(), earlier.faults.begin(), earlier.faults.end());
  findings.all.clean = findings.faults.empty();
}

/// States the greatest deviation of the control from the path for which these findings are valid; or the bound from
/// the machine file.
void name_blending_bound(Findings& findings, const ResolvedPlan& plan) {
  for (Condition& one : findings.conditions) {
    if (one.name != "blending") continue;
    if (findings.without_part && !plan.machine.path_tolerance) continue;  // there is no bound
    if (plan.machine.path_tolerance) {
      one.met_by = "machine file";
      continue;
    }
    const double bound =
        std::min(plan.tol.uncut - findings.all.uncut_thickness_mm, plan.tol.gouge - findings.all.gouge_mm);
    one.text += fmt::format("; what is found here holds up to {} mm", trimmed(std::max(bound, 0.0), 4));
  }
}

/// A move, counted over all sections, and the distance, mm, by which it misses a place.
struct NearMove {
  std::size_t move = 0;
  double beside = 0;
};

double distance_from(const Move& move, const Place& place) {
  const double low = std::min(move.z_from, move.z_to), high = std::max(move.z_from, move.z_to);
  const Vec2 near = move.is_vertical() ? move.path.from : nearest_point(move.path, place.point);
  return distance(near, place.point) + std::abs(place.z - std::clamp(place.z, low, high));
}

/// For each fault the move of its line that comes nearest to its place; none where no move has that line. One pass over
/// the moves for all faults.
std::vector<std::optional<NearMove>> moves_of(const std::vector<Fault>& faults, const Toolpath& toolpath) {
  std::multimap<int, std::size_t> by_line;
  for (std::size_t i = 0; i < faults.size(); ++i)
    if (faults[i].at.line > 0) by_line.emplace(faults[i].at.line, i);
  std::vector<std::optional<NearMove>> nearest(faults.size());
  std::size_t index = 0;
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      const auto [first, last] = by_line.equal_range(move.line);
      for (auto at = first; at != last; ++at) {
        std::optional<NearMove>& known = nearest[at->second];
        const double beside = distance_from(move, faults[at->second].at);
        if (!known || beside < known->beside) known = NearMove{index, beside};
      }
      ++index;
    }
  }
  return nearest;
}

/// Faults of moves within subprograms say which line of which file makes them, and who called it.
void tell_calls(Findings& findings, const Toolpath& toolpath, const ControlTable& control) {
  if (control.calls.empty()) return;
  const auto nearest = moves_of(findings.faults, toolpath);
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    const std::string* const calls = nearest[i] ? control.calls_at(nearest[i]->move) : nullptr;
    if (calls) findings.faults[i].text += " (" + *calls + ")";
  }
}

}  // namespace

Findings check(const Part& part, const Toolpath& toolpath, const ControlTable& control,
               const std::vector<Condition>& conditions, Dialect dialect, const ResolvedPlan& plan,
               StatedOfTools stated) {
  verify::VerifyOptions verify = verify_options(plan);
  verify.tool_limits = std::move(stated.limits);
  verify.stated = std::move(stated.drives);
  if (verify.reference) verify.reference->feed_of_tool = std::move(stated.reference_feeds);
  verify.control = &control;
  verify.accepted = plan.accept;
  const read::gcode::DialectRules& rules = read::gcode::rules_of(dialect);
  verify.speed_may_be_power = rules.speed_may_be_power;
  verify.needs_tool_length = rules.needs_lengths;
  verify.changes_tools_alone = rules.changer_alone;
  Findings findings = verify::verify_program(part, toolpath, verify);
  findings.conditions.insert(findings.conditions.begin(), conditions.begin(), conditions.end());
  if (auto far = far_move(part, toolpath)) findings.conditions.push_back(*std::move(far));
  if (has_wrong_units(findings)) drop_what_follows_from_units(findings);
  drop_what_lengths_say(findings, plan.accept);
  name_blending_bound(findings, plan);
  tell_calls(findings, toolpath, control);
  add_earlier(findings, plan);
  accept_conditions(findings, plan.accept);
  return findings;
}

namespace {

void certify_as_it_is(PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan) {
  result.program = post_with(nullptr, "", planned, result.part, plan, result.corner_tolerances);
  Program read = read_back(result.program, planned, plan);
  result.toolpath = std::move(read.toolpath);
  SectionNames(result.part).settle(result.toolpath);
  result.control = std::move(read.control);
  result.findings = check(result.part, result.toolpath, result.control, read.conditions, read.dialect, plan);
  if (!plan.post.wear) return;
  const WearQuestion question{plan.post.wear->range, read.compensated_tools, &result.part, &result.toolpath};
  check_wear(result.findings, question, [&](double wear) {
    Program shifted = read_back(result.program, planned, plan, wear);
    const Part part = worn(result.part, read.compensated_tools, wear);
    SectionNames(part).settle(shifted.toolpath);
    Findings found =
        check(part, shifted.toolpath, shifted.control, shifted.conditions, shifted.dialect, plan);
    return WornProgram{std::move(shifted.toolpath), std::move(found)};
  });
}

}  // namespace

void certify(PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan) {
  result.corner_tolerances = widest_corner_tolerances(planned, plan);
  certify_as_it_is(result, planned, plan);
  for (int tries = 1; narrow_corner_tolerances(result, planned, plan, tries); ++tries)
    certify_as_it_is(result, planned, plan);
}

void sign(PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan) {
  const std::string hash = sha256_hex(report::motion_text(result.program));
  result.program = post_with(&result.findings, hash, planned, result.part, plan, result.corner_tolerances);
  const auto again = read_back(result.program, planned, plan);
  CLEARCUT_ASSERT(same_moves(again.toolpath, result.toolpath));
  CLEARCUT_ASSERT(sha256_hex(report::motion_text(result.program)) == hash);
}

}  // namespace clearcut::pipeline
