#include "pipeline/contour_results.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/format.h"
#include "plan/common/clearing_area.h"
#include "plan/common/layers.h"
#include "plan/contour/contour.h"
#include "plan/contour/entries.h"
#include "plan/contour/step_rule.h"

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

std::vector<report::ContourLevels> contours_of(const Toolpath& toolpath, const ResolvedPlan& plan) {
  std::vector<report::ContourLevels> contours;
  for (const Section& section : toolpath.sections) {
    report::ContourLevels levels{section.label, section.contours, {}};
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

void report_rho(const std::vector<report::ContourLevels>& contours, const ResolvedPlan& plan, Part& part) {
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

}  // namespace clearcut::pipeline
