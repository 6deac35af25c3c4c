#include "pipeline/certify.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/format.h"
#include "base/version.h"
#include "link/link.h"
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
                      const resolve::PlanOptions& options) {
  PostOptions post_options = options.post;
  post_options.header = header(part, verdict);
  if (post_options.program_name.empty()) post_options.program_name = part.name;
  return post::write_program(toolpath, part, post_options);
}

/// mm over all that stands, where nothing is said.
constexpr double kCrossing = 2;
/// mm. The least of what is said, likewise.
constexpr double kLeastCrossing = 1;

}  // namespace

double crossing_z(const Part& part, const Operation& operation) {
  const double top = part.top_z();
  const double asked = operation.retract_z.value_or(top + kCrossing);
  return std::min(part.safe_z(), std::max(asked, top + kLeastCrossing));
}

link::LinkOptions link_options(const Part& part, int workingstep, EntryKind entry,
                               const resolve::PlanOptions& options) {
  const auto& step = part.workplan.at(static_cast<std::size_t>(workingstep));
  const auto& operation = step.operation;
  link::LinkOptions link;
  link.tool_radius = tool_of(part, step).radius();
  link.safe_z = part.safe_z();
  link.cross_z = crossing_z(part, operation);
  link.direction = *operation.direction;
  link.spindle_clockwise = operation.cutting.spindle_clockwise;
  link.feed = *operation.cutting.feed;
  link.plunge_feed = *operation.cutting.plunge_feed;
  link.ramp_feed = *operation.cutting.ramp_feed;
  link.entry = operation.entry.value_or(entry);
  if (operation.entry_angle) link.entry_angle = *operation.entry_angle;
  link.may_plunge = tool_of(part, step).center_cutting;
  link.helix_widest = options.shop.widest_helix(operation.entry_size);
  link.zigzag_length = operation.entry_size.value_or(0);
  link.helix_narrowest = options.shop.helix_narrowest;
  link.lead = {operation.lead.value_or(0), operation.lead_angle, options.shop.lead_overlap.value_or(0)};
  link.lead_feed = options.shop.lead_feed;
  link.link_feed = options.shop.link_feed;
  link.link_lift = options.shop.link_lift.value_or(0);
  link.predrilled = stock::holes_before(part, workingstep, options.tol);
  if (part.stock) link.stock = part.stock->plan;
  link.machine = options.machine;
  return link;
}

void describe(Section& section, int workingstep, const Part& part) {
  const auto& step = part.workplan.at(static_cast<std::size_t>(workingstep));
  section.label = feature_of(part, step).name;
  section.workingstep = workingstep;
  section.tool_number = tool_of(part, step).number;
  section.spindle_rpm = *step.operation.cutting.spindle_rpm;
  section.spindle_clockwise = step.operation.cutting.spindle_clockwise;
  section.coolant = step.operation.cutting.coolant;
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

Section link_step(const std::vector<LayerPasses>& passes, int workingstep, EntryKind entry, const Part& part,
                  const resolve::PlanOptions& options) {
  Section section = link::link_layers(passes, link_options(part, workingstep, entry, options), options.tol);
  describe(section, workingstep, part);
  section.contours = contour_levels(passes);
  return section;
}

verify::VerifyOptions verify_options(const resolve::PlanOptions& options) {
  verify::VerifyOptions verify;
  verify.tol = options.tol;
  verify.machine = options.machine;
  verify.engagement_limit_deg = options.engagement_deg;
  verify.threads = resolve::thread_count(options);
  verify.cancel = options.cancel;
  if (options.earlier) verify.earlier = &*options.earlier;
  if (options.shop.material) verify.material = work_material_named(*options.shop.material);
  return verify;
}

namespace {

/// As the control that the program is posted for reads it; tools are put in by hand in the order of work where it has no
/// words for them.
Toolpath read_back(const std::string& program, const Toolpath& planned, const resolve::PlanOptions& options) {
  read::gcode::ReadControllerOptions reading;
  reading.dialect = read::gcode::dialect_named(options.post.dialect);
  reading.home_z = home_z(options.machine);
  for (const Section& section : planned.sections) {
    const bool same = !reading.hand_tools.empty() && reading.hand_tools.back() == section.tool_number;
    if (section.tool_number > 0 && !same) reading.hand_tools.push_back(section.tool_number);
  }
  return read::gcode::read_gcode(program, "program", reading).toolpath;
}

}  // namespace

void certify(PlanResult& result, const Toolpath& planned, const resolve::PlanOptions& options) {
  result.program = post_with(std::nullopt, planned, result.part, options);
  result.toolpath = read_back(result.program, planned, options);
  result.findings = verify::verify_program(result.part, result.toolpath, verify_options(options));
}

void sign(PlanResult& result, const Toolpath& planned, const resolve::PlanOptions& options) {
  result.program = post_with(result.findings.all, planned, result.part, options);
  const auto again = read_back(result.program, planned, options);
  CLEARCUT_ASSERT(same_moves(again, result.toolpath));
}

}  // namespace clearcut::pipeline
