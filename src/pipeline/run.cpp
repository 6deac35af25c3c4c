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

LinkOptions link_options(const Part& part, const Workingstep& step, const PlanOptions& options) {
  const auto& operation = step.operation;
  LinkOptions link;
  link.tool_radius = tool_of(part, step).radius();
  link.safe_z = part.safe_z();
  link.direction = *operation.direction;
  link.spindle_clockwise = operation.cutting.spindle_clockwise;
  link.feed = *operation.cutting.feed;
  link.plunge_feed = *operation.cutting.plunge_feed;
  link.ramp_feed = *operation.cutting.ramp_feed;
  if (operation.entry) link.entry = *operation.entry;
  if (operation.entry_angle) link.entry_angle = *operation.entry_angle;
  if (part.stock) link.stock = part.stock->plan;
  link.machine = options.machine;
  return link;
}

Section section_by(const std::string& strategy_name, const Part& part, const Workingstep& step,
                   const std::vector<Layer>& layers, const PlanOptions& options) {
  const auto strategy = strategy_named(strategy_name, step.operation, options);
  std::vector<LayerPasses> passes;
  for (const auto& layer : layers) passes.push_back(strategy(layer));
  return link_layers(passes, link_options(part, step, options), options.tol);
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

/// The layers of one workingstep over which something still stands. Open features cut only that; in closed
/// ones the walls bound every pass, so the whole layer is cut.
std::vector<Layer> standing_layers(const Part& part, const Workingstep& step, const PlanOptions& options) {
  const auto& feature = feature_of(part, step);
  auto layers = layers_of(feature, step.operation, tool_of(part, step).radius(), options.tol);
  for (auto& layer : layers) {
    const Regions standing = standing_target(part, step.feature, layer.z, options.tol);
    if (standing.empty() || has_open_side(feature)) layer.target = standing;
  }
  std::erase_if(layers, [](const Layer& layer) { return layer.target.empty(); });
  return layers;
}

/// The fastest section that the wanted strategies give for one workingstep; empty where the cutter does not
/// fit.
Section plan_step(int index, const Part& part, const PlanOptions& options) {
  const auto& step = part.workplan[static_cast<std::size_t>(index)];
  const auto layers = standing_layers(part, step, options);
  Section best;
  double best_time = 0;
  for (const auto& name : candidates_for(options.strategy)) {
    Section section = section_by(name, part, step, layers, options);
    const double time = kinematic_time(section.moves, options.machine).seconds();
    if (section.moves.empty() || (!best.moves.empty() && time >= best_time)) continue;
    best = std::move(section);
    best_time = time;
  }
  describe(best, index, part, step);
  return best;
}

void refuse_if_nothing_is_cut(const Toolpath& toolpath, const Part& part, const PlanOptions& options) {
  if (!toolpath.sections.empty()) return;
  const auto& step = part.workplan.front();
  throw InputError(
      part.source_file,
      fmt::format("nothing can be cut: tool T{} ({} mm) does not fit {}; the largest that does has {} mm",
                  tool_of(part, step).number, trimmed(tool_of(part, step).diameter, 4),
                  feature_of(part, step).name,
                  trimmed(largest_fitting_diameter(feature_of(part, step), options.tol), 3)));
}

Toolpath plan_all(Part& part, const PlanOptions& options) {
  Toolpath toolpath;
  for (int i = 0; i < static_cast<int>(part.workplan.size()); ++i) {
    Section section = plan_step(i, part, options);
    if (!section.moves.empty()) {
      toolpath.sections.push_back(std::move(section));
      continue;
    }
    const auto& step = part.workplan[static_cast<std::size_t>(i)];
    part.diagnostics.skip(feature_of(part, step).name,
                          fmt::format("tool T{} ({} mm) has no legal position in it",
                                      tool_of(part, step).number, trimmed(tool_of(part, step).diameter, 4)));
  }
  return toolpath;
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

/// Always the same number of lines, so that the numbered places of the certificate stay true.
std::vector<std::string> header(const Part& part, const std::string& verdict) {
  std::vector<std::string> lines{fmt::format("PART: {}", part.name), stock_line(part)};
  for (const auto& tool : part.tools) {
    lines.push_back(
        fmt::format("TOOL T{}: {} {} MM", tool.number, name_of(tool.kind), trimmed(tool.diameter, 4)));
  }
  lines.push_back(fmt::format("WRITTEN BY CLEARCUT {}", kVersion));
  lines.push_back(verdict);
  return lines;
}

std::string verdict_line(const Figures& all) {
  return fmt::format("CERTIFICATE: {}, UNCUT BELOW {} MM, GOUGE {} MM, RAPIDS IN MATERIAL {}, TIME {} S",
                     all.clean ? "CLEAN" : "FAULTS FOUND", trimmed(all.uncut_thickness_mm, 4),
                     trimmed(all.gouge_mm, 4), all.rapid_in_material, trimmed(all.time_s, 1));
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

std::string post_with(const std::string& verdict, const Toolpath& toolpath, const Part& part,
                      const PlanOptions& options) {
  PostOptions post_options = options.post;
  post_options.header = header(part, verdict);
  if (post_options.program_name.empty()) post_options.program_name = part.name;
  return post(toolpath, part, post_options);
}

/// Puts the verdict into the program's header and makes sure that nothing else has changed.
void sign(PlanResult& result, const Toolpath& planned, const PlanOptions& options) {
  result.program = post_with(verdict_line(result.findings.all), planned, result.part, options);
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
  const Toolpath planned = plan_all(result.part, options);
  refuse_if_nothing_is_cut(planned, result.part, options);
  result.program = post_with("CERTIFICATE: PENDING", planned, result.part, options);
  result.toolpath = read_gcode(result.program, "program").toolpath;
  result.findings = verify(result.part, result.toolpath, verify_options(options));
  sign(result, planned, options);
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
