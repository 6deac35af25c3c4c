#include "pipeline/result_figures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/text.h"
#include "base/tolerances.h"
#include "pipeline/steps/certify.h"
#include "plan/common/clearing_area.h"
#include "plan/common/layers.h"
#include "plan/contour/contour.h"
#include "plan/contour/step_rule.h"
#include "verify/engagement/load.h"
#include "verify/margin.h"

namespace clearcut::pipeline {
namespace {

/// Contours of a published method in the top layer of a section's feature; none for other strategies and for open
/// sides.
std::vector<plan::contour::ContourStep> published_contours(const Section& section, const ResolvedPlan& plan) {
  const auto index = static_cast<std::size_t>(section.workingstep);
  if (section.workingstep < 0 || index >= plan.steps.size()) return {};
  const ResolvedStep& decided = plan.steps[index];
  if (decided.strategy == nullptr) return {};
  const auto rule = plan::contour::contour_rule(decided.strategy->name, decided.stepover);
  if (!rule) return {};
  const auto& step = plan.part.workplan[index];
  const double radius = tool_of(plan.part, step).radius();
  const auto layers = plan::layers_of(feature_of(plan.part, step), step.operation, radius, plan.tol);
  if (layers.empty() || !plan::closed_all_round(layers.front())) return {};
  const Layer& top = layers.front();
  return plan::contour::contour_steps(top.allowed, *rule, radius, radius + top.wall_stock, plan.tol);
}

}  // namespace

std::vector<ContourLevels> contours_of(const Toolpath& toolpath, const ResolvedPlan& plan) {
  std::vector<ContourLevels> contours;
  for (const Section& section : toolpath.sections) {
    ContourLevels levels{section.label, section.contours, {}};
    const auto published = published_contours(section, plan);
    if (!published.empty()) levels.from_wall.clear();
    for (const auto& contour : published) {
      levels.from_wall.push_back(contour.from_wall);
      if (contour.step <= 0) continue;
      const auto& step = plan.part.workplan[static_cast<std::size_t>(section.workingstep)];
      const double radius = tool_of(plan.part, step).radius(), share = contour.step / (2 * radius);
      levels.coefficients.push_back(
          {contour.from_wall, contour.smallest_angle, share,
           plan::contour::residual_size(contour.smallest_angle, radius, 1 - share)});
    }
    if (!levels.from_wall.empty()) contours.push_back(std::move(levels));
  }
  return contours;
}

void report_rho(const std::vector<ContourLevels>& contours, const ResolvedPlan& plan, Part& part) {
  const auto is_rho = [](const ResolvedStep& step) { return step.strategy && step.strategy->name == "rho"; };
  if (!std::any_of(plan.steps.begin(), plan.steps.end(), is_rho)) return;
  for (const auto& levels : contours) {
    if (levels.coefficients.empty()) continue;
    const auto& first = levels.coefficients.front();
    part.diagnostics.note(levels.feature,
                          fmt::format("rho_opt {:.4f} from the smallest angle, {:.2f} degrees", first.share,
                                      first.smallest_angle * 180 / kPi));
  }
}

namespace {

std::string place_of(const FeatureMargin& least) {
  if (!least.at) return "";
  const std::string line = least.at->line > 0 ? fmt::format(", line {}", least.at->line) : "";
  return fmt::format(" at ({}, {}){}", trimmed(least.at->point.x, 3), trimmed(least.at->point.y, 3), line);
}

std::string not_asked_of(const Margin& margin) {
  if (margin.not_asked.empty()) return "";
  return fmt::format("; not found for {}, whose walls lean or whose shape its tool forms",
                     fmt::join(margin.not_asked, ", "));
}

}  // namespace

std::optional<Margin> margin_asked(const ProgramRead& program, const ResolvedPlan& plan, Findings& findings) {
  if (!plan.margin) return std::nullopt;
  verify::VerifyOptions asked = verify_options(plan);
  asked.control = &program.control;
  Margin margin = verify::margin_of(program.part, program.toolpath, asked, plan.margin->bounds);
  const FeatureMargin* const least = margin.least();
  if (least && least->mm < plan.margin->at_least - kRoundingMm) {
    Condition open;
    open.name = "margin";
    open.text =
        fmt::format("{}: {} mm were asked for", margin_line(margin), trimmed(plan.margin->at_least, 4));
    findings.conditions.push_back(std::move(open));
    accept_conditions(findings, plan.accept);
  }
  return margin;
}

std::string margin_line(const Margin& margin) {
  const FeatureMargin* const least = margin.least();
  if (!least) return "margin: of no feature" + not_asked_of(margin);
  const std::string what =
      least->limit == MarginLimit::kUncut
          ? fmt::format("{} mm would be left", trimmed(margin.bounds.uncut, 4))
          : fmt::format("the part would be cut {} mm too deep", trimmed(margin.bounds.gouge, 4));
  return fmt::format("margin: holds for {} mm of machine error; beyond it {} in {}{}{}",
                     trimmed(least->mm, 4), what, least->feature, place_of(*least), not_asked_of(margin));
}

namespace {

verify::CheckedProgram checked(const Part& part, const Toolpath& toolpath, const ControlTable& control,
                               const PlanOptions& options) {
  return verify::checked_program(part, toolpath, options.machine,
                                 options.earlier ? &*options.earlier : nullptr, &control);
}

MoveFigures figures_of(const verify::CheckedMove& move) {
  const verify::MoveLoad& load = move.load;
  const double mean = load.cutting_mm > 0 ? load.angle_mm_deg / load.cutting_mm : 0;
  return {move.time_s, load.max_deg, mean, load.cutting_mm, load.air_mm};
}

}  // namespace

std::vector<double> times_of_moves(const Part& part, const Toolpath& toolpath, const ControlTable& control,
                                   const PlanOptions& options) {
  std::vector<double> times;
  for (const verify::CheckedMove& move : checked(part, toolpath, control, options).moves) {
    if (!move.earlier) times.push_back(move.time_s);
  }
  return times;
}

std::vector<MoveFigures> figures_of_moves(const Part& part, const Toolpath& toolpath,
                                          const ControlTable& control, const PlanOptions& options) {
  verify::CheckedProgram program = checked(part, toolpath, control, options);
  verify::measure_load(part, program.moves, {options.tol, options.engagement_deg, {}, options.cancel});
  std::vector<MoveFigures> figures;
  for (const verify::CheckedMove& move : program.moves) {
    if (!move.earlier) figures.push_back(figures_of(move));
  }
  return figures;
}

}  // namespace clearcut::pipeline
