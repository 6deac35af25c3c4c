#include "pipeline/run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/error.h"
#include "base/format.h"
#include "base/version.h"
#include "link/link.h"
#include "pipeline/prepare.h"
#include "pipeline/strategies.h"
#include "plan/layers.h"
#include "read/gcode/gcode.h"
#include "toolpath/kinematics.h"
#include "verify/verify.h"

namespace clearcut {
namespace {

const Tool& tool_of(const Part& part, const Workingstep& step) {
  return part.tools.at(static_cast<std::size_t>(step.operation.tool));
}

const Feature& feature_of(const Part& part, const Workingstep& step) {
  return part.features.at(static_cast<std::size_t>(step.feature));
}

/// Where nobody says how to go down: a helix under limited engagement and for cutters that cannot plunge.
EntryKind default_entry(const Tool& tool, const Attempt& attempt) {
  return tool.center_cutting && attempt.strategy != "adaptive" ? EntryKind::kPlunge : EntryKind::kHelix;
}

LinkOptions link_options(const Part& part, const Workingstep& step, const Attempt& attempt,
                         const PlanOptions& options) {
  const auto& operation = step.operation;
  LinkOptions link;
  link.tool_radius = tool_of(part, step).radius();
  link.safe_z = part.safe_z();
  link.direction = *operation.direction;
  link.spindle_clockwise = operation.cutting.spindle_clockwise;
  link.feed = *operation.cutting.feed;
  link.plunge_feed = *operation.cutting.plunge_feed;
  link.ramp_feed = *operation.cutting.ramp_feed;
  link.entry = operation.entry.value_or(default_entry(tool_of(part, step), attempt));
  if (operation.entry_angle) link.entry_angle = *operation.entry_angle;
  if (part.stock) link.stock = part.stock->plan;
  link.machine = options.machine;
  return link;
}

void describe(Section& section, int index, const Part& part, const Workingstep& step) {
  section.label = feature_of(part, step).name;
  section.workingstep = index;
  section.tool_number = tool_of(part, step).number;
  section.spindle_rpm = *step.operation.cutting.spindle_rpm;
  section.spindle_clockwise = step.operation.cutting.spindle_clockwise;
  section.coolant = step.operation.cutting.coolant;
}

bool has_open_side(const Feature& feature) {
  return feature.kind != FeatureKind::kClosedPocket && feature.kind != FeatureKind::kRoundHole;
}

/// mm. What coarse digits of a controller may move a pass into a wall or floor beyond half of the smallest
/// gouge that counts.
double printing_reserve(const PlanOptions& options) {
  return std::max(0.0, rounding_of(options.post) - options.tol.gouge / 2);
}

/// The layers of one workingstep over which something still stands. Open features cut only that; in closed
/// ones the walls bound every pass, so the whole layer is cut.
std::vector<Layer> standing_layers(const Part& part, const Workingstep& step, const PlanOptions& options) {
  const auto& feature = feature_of(part, step);
  Operation operation = step.operation;
  operation.allowance_side += printing_reserve(options);
  operation.allowance_floor += printing_reserve(options);
  auto layers = layers_of(feature, operation, tool_of(part, step).radius(), options.tol);
  for (auto& layer : layers) {
    const Regions standing = standing_target(part, step.feature, layer.z, options.tol);
    if (standing.empty() || has_open_side(feature)) layer.target = standing;
  }
  std::erase_if(layers, [](const Layer& layer) { return layer.target.empty(); });
  return layers;
}

/// The section of one workingstep; without moves where the cutter does not fit.
Section plan_step(int index, const Part& part, const Attempt& attempt, const PlanOptions& options) {
  const auto& step = part.workplan[static_cast<std::size_t>(index)];
  const auto strategy = strategy_for(attempt, step.operation, options);
  std::vector<LayerPasses> passes;
  for (const auto& layer : standing_layers(part, step, options)) passes.push_back(strategy(layer));
  Section section = link_layers(passes, link_options(part, step, attempt, options), options.tol);
  describe(section, index, part, step);
  return section;
}

std::string does_not_fit(const Part& part, const Workingstep& step, const PlanOptions& options) {
  return fmt::format("tool T{} ({} mm) does not fit {}; the largest that does has {} mm",
                     tool_of(part, step).number, trimmed(tool_of(part, step).diameter, 4),
                     feature_of(part, step).name,
                     trimmed(largest_fitting_diameter(feature_of(part, step), options.tol), 3));
}

/// What is planned for each workingstep, and by which of the attempts.
struct Draft {
  std::vector<Section> sections;
  std::vector<std::size_t> attempt;
};

Draft draft_all(const Part& part, const std::vector<Attempt>& attempts, const PlanOptions& options) {
  Draft draft;
  for (int i = 0; i < static_cast<int>(part.workplan.size()); ++i) {
    draft.sections.push_back(plan_step(i, part, attempts.front(), options));
    draft.attempt.push_back(0);
  }
  return draft;
}

Toolpath toolpath_of(const Draft& draft) {
  Toolpath toolpath;
  for (const auto& section : draft.sections) {
    if (!section.moves.empty()) toolpath.sections.push_back(section);
  }
  return toolpath;
}

void report_what_does_not_fit(Part& part, const Draft& draft, const PlanOptions& options) {
  const bool nothing = std::all_of(draft.sections.begin(), draft.sections.end(),
                                   [](const Section& section) { return section.moves.empty(); });
  if (nothing) {
    throw InputError(part.source_file,
                     "nothing can be cut: " + does_not_fit(part, part.workplan.front(), options));
  }
  for (std::size_t i = 0; i < draft.sections.size(); ++i) {
    const auto& step = part.workplan[i];
    if (!draft.sections[i].moves.empty() || standing_layers(part, step, options).empty()) continue;
    part.diagnostics.skip(feature_of(part, step).name, does_not_fit(part, step, options));
  }
}

VerifyOptions verify_options(const PlanOptions& options) {
  VerifyOptions verify;
  verify.tol = options.tol;
  verify.machine = options.machine;
  verify.engagement_limit_deg = options.engagement_deg;
  verify.threads = options.threads;
  return verify;
}

std::string stock_line(const Part& part) {
  if (!part.stock) return "STOCK: NOT GIVEN";
  const auto& stock = *part.stock;
  return fmt::format("STOCK: X {} TO {} Y {} TO {} Z {} TO {} MM", trimmed(stock.plan.min.x, 3),
                     trimmed(stock.plan.max.x, 3), trimmed(stock.plan.min.y, 3), trimmed(stock.plan.max.y, 3),
                     trimmed(stock.z_bottom, 3), trimmed(stock.z_top, 3));
}

/// The certificate in short lines, always as many: the numbered places of the findings must stay true.
std::vector<std::string> verdict_lines(const std::optional<Figures>& all) {
  if (!all) return {"CERTIFICATE: PENDING", "-", "-", "-", "-"};
  return {fmt::format("CERTIFICATE: {}", all->clean ? "CLEAN" : "FAULTS FOUND"),
          fmt::format("LEFT UNCUT: BELOW {:.4f} MM", all->uncut_thickness_mm),
          fmt::format("GOUGE: {:.4f} MM", all->gouge_mm),
          fmt::format("RAPIDS IN MATERIAL: {}", all->rapid_in_material),
          fmt::format("TIME: {:.1f} S", all->time_s)};
}

std::vector<std::string> header(const Part& part, const std::optional<Figures>& all) {
  std::vector<std::string> lines{fmt::format("PART: {}", part.name), stock_line(part)};
  for (const auto& tool : part.tools) {
    lines.push_back(
        fmt::format("TOOL T{}: {} {} MM", tool.number, name_of(tool.kind), trimmed(tool.diameter, 4)));
  }
  lines.push_back(fmt::format("WRITTEN BY CLEARCUT {}", kVersion));
  for (auto& line : verdict_lines(all)) lines.push_back(std::move(line));
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

std::string post_with(const std::optional<Figures>& verdict, const Toolpath& toolpath, const Part& part,
                      const PlanOptions& options) {
  PostOptions post_options = options.post;
  post_options.header = header(part, verdict);
  if (post_options.program_name.empty()) post_options.program_name = part.name;
  return post(toolpath, part, post_options);
}

/// Posts, reads back, and judges what was read.
void certify(PlanResult& result, const Toolpath& planned, const PlanOptions& options) {
  result.program = post_with(std::nullopt, planned, result.part, options);
  result.toolpath = read_gcode(result.program, "program").toolpath;
  result.findings = verify(result.part, result.toolpath, verify_options(options));
}

/// Plans every workingstep that was not certified clean by the next attempt. False when there was nothing to
/// do.
bool retry_unclean(Draft& draft, PlanResult& result, const std::vector<Attempt>& attempts,
                   const PlanOptions& options) {
  bool retried = false;
  for (const auto& feature : result.findings.features) {
    if (feature.figures.clean || feature.workingstep < 0) continue;
    const auto i = static_cast<std::size_t>(feature.workingstep);
    if (draft.sections[i].moves.empty() || draft.attempt[i] + 1 >= attempts.size()) continue;
    const Attempt& next = attempts[++draft.attempt[i]];
    draft.sections[i] = plan_step(feature.workingstep, result.part, next, options);
    result.part.diagnostics.note(feature.name,
                                 "was not certified clean at first and is planned again: " + next.strategy +
                                     (next.stepover ? ", stepover " + *next.stepover : ""));
    retried = true;
  }
  return retried;
}

/// Puts the verdict into the program's header and makes sure that nothing else has changed.
void sign(PlanResult& result, const Toolpath& planned, const PlanOptions& options) {
  result.program = post_with(result.findings.all, planned, result.part, options);
  const auto again = read_gcode(result.program, "program").toolpath;
  CLEARCUT_ASSERT(same_moves(again, result.toolpath));
}

/// One unnumbered tool given for a program that uses one tool: they are the same, whatever its number there.
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

/// A program of another CAM is held to the stepdown that somebody stated, not to our default.
void keep_stated_stepdowns(Part& prepared, const Part& part, const PlanOptions& options) {
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    prepared.workplan[i].operation.stepdown =
        options.stepdown ? options.stepdown : part.workplan[i].operation.stepdown;
  }
}

}  // namespace

PlanResult plan(const Part& part, const PlanOptions& options) {
  PlanResult result;
  result.part = prepare(part, options);
  const auto attempts = attempts_for(options);
  Draft draft = draft_all(result.part, attempts, options);
  report_what_does_not_fit(result.part, draft, options);
  certify(result, toolpath_of(draft), options);
  while (retry_unclean(draft, result, attempts, options)) certify(result, toolpath_of(draft), options);
  sign(result, toolpath_of(draft), options);
  return result;
}

JudgeResult judge(const Part& part, const std::string& program, const std::string& program_name,
                  const PlanOptions& options) {
  auto read = read_gcode(program, program_name);
  JudgeResult result;
  result.part = prepare(part, numbered_by(read.toolpath, options));
  keep_stated_stepdowns(result.part, part, options);
  result.part.diagnostics.append(read.diagnostics);
  result.toolpath = std::move(read.toolpath);
  number_sections(result.toolpath, result.part);
  result.findings = verify(result.part, result.toolpath, verify_options(options));
  return result;
}

}  // namespace clearcut
