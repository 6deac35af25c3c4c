#include "pipeline/certify.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/format.h"
#include "base/version.h"
#include "link/link.h"
#include "model/not_machined.h"
#include "post/post.h"
#include "read/gcode/gcode.h"
#include "stock/round_hole.h"
#include "verify/verify.h"

namespace clearcut::pipeline {
namespace {

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
  for (const auto& name : names_not_machined(part.diagnostics)) lines.push_back("NOT MACHINED: " + name);
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
                      const ResolvedPlan& plan) {
  PostOptions post_options = plan.post;
  post_options.header = header(part, verdict);
  if (post_options.program_name.empty()) post_options.program_name = part.name;
  return post::write_program(toolpath, part, post_options);
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
  link.lead = {step.lead, step.lead_angle, plan.lead_overlap};
  link.lead_feed = step.lead_feed;
  link.link_feed = plan.link_feed;
  link.link_lift = plan.link_lift;
  link.predrilled = stock::holes_before(plan.part, workingstep, plan.tol);
  if (plan.part.stock) link.stock = plan.part.stock->plan;
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
  constexpr double kSame = 1e-6;
  std::vector<double> levels;
  for (const LayerPasses& layer : layers) {
    if (layer.strategy != "contour") continue;
    for (const Pass& pass : layer.passes) {
      if (pass.closed) levels.push_back(pass.offset);
    }
  }
  std::sort(levels.begin(), levels.end());
  const auto same = [](double a, double b) { return b - a < kSame; };
  levels.erase(std::unique(levels.begin(), levels.end(), same), levels.end());
  return levels;
}

Section link_step(const std::vector<LayerPasses>& passes, int workingstep, EntryKind entry,
                  const ResolvedPlan& plan) {
  Section section = link::link_layers(passes, link_options(plan, workingstep, entry), plan.tol);
  describe(section, workingstep, plan);
  section.contours = contour_levels(passes);
  return section;
}

verify::VerifyOptions verify_options(const ResolvedPlan& plan) {
  verify::VerifyOptions verify;
  verify.tol = plan.tol;
  verify.machine = plan.machine;
  verify.engagement_limit_deg = plan.engagement_deg;
  verify.threads = plan.threads;
  verify.cancel = plan.cancel;
  if (plan.earlier) verify.earlier = &*plan.earlier;
  verify.material = plan.material;
  return verify;
}

namespace {

/// As the control that the program is posted for reads it; tools are put in by hand in the order of work where it has no
/// words for them.
Toolpath read_back(const std::string& program, const Toolpath& planned, const ResolvedPlan& plan) {
  read::gcode::ReadControllerOptions reading;
  reading.dialect = read::gcode::dialect_named(plan.post.dialect);
  reading.home_z = home_z(plan.machine);
  for (const Section& section : planned.sections) {
    const bool same = !reading.hand_tools.empty() && reading.hand_tools.back() == section.tool_number;
    if (section.tool_number > 0 && !same) reading.hand_tools.push_back(section.tool_number);
  }
  return read::gcode::read_gcode(program, "program", reading).toolpath;
}

}  // namespace

void certify(PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan) {
  result.program = post_with(std::nullopt, planned, result.part, plan);
  result.toolpath = read_back(result.program, planned, plan);
  result.findings = verify::verify_program(result.part, result.toolpath, verify_options(plan));
  add_not_machined(result.part.diagnostics, result.findings);
}

void sign(PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan) {
  result.program = post_with(result.findings.all, planned, result.part, plan);
  const auto again = read_back(result.program, planned, plan);
  CLEARCUT_ASSERT(same_moves(again, result.toolpath));
}

}  // namespace clearcut::pipeline
