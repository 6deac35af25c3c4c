#include <fmt/format.h>

#include <cmath>

#include "base/error.h"
#include "pipeline/run.h"
#include "studies/fishhead.h"
#include "studies/reproduce/reproduce_parts.h"

namespace clearcut::studies {
namespace {

constexpr int kSloped = 5;  ///< POCKET3, among features and steps

/// The pocket alone, in a stock whose top it begins at.
Part sloped_pocket() {
  const Part whole = fishhead(true, {});
  Part part = whole;
  part.features = {whole.features[kSloped]};
  part.workplan = {whole.workplan[kSloped]};
  part.workplan.front().feature = 0;
  part.stock->z_top = part.features.front().top_z;
  return part;
}

/// The pocket as planned and certified; its layers are as deep as `options` say.
FeatureFindings planned(PlanOptions options) {
  options.strategy = "tour";
  const PlanResult result = pipeline::plan_part(sloped_pocket(), options);
  CLEARCUT_ASSERT(result.findings.all.clean && result.findings.features.front().scallop);
  return result.findings.features.front();
}

/// Layers as deep as a scallop of `asked` mm allows, the last one with what is left.
FeatureFindings planned_by_scallop(double asked) {
  PlanOptions options;
  options.scallop = asked;
  return planned(options);
}

/// The pocket's depth shared out equally; mm, to the four decimals that a command states.
double equal_stepdown(std::size_t layers) {
  const Part part = sloped_pocket();
  const Feature& pocket = part.features.front();
  return std::ceil(1e4 * (pocket.top_z - pocket.floor_z) / static_cast<double>(layers)) / 1e4;
}

FeatureFindings planned_by_stepdown(double stepdown) {
  PlanOptions options;
  options.stepdown = stepdown;
  return planned(options);
}

}  // namespace

Reproduction scallop_table() {
  Reproduction result;
  result.table.title = "Tour table 6.1: scallop height on the drafted walls of the sloped fishhead, mm";
  result.table.columns = {{"specified"},       {"actual, printed"}, {"layers"},
                          {"stepdown, equal"}, {"equal, measured"}, {"as deep as allowed, measured"}};
  for (const double asked : {0.5, 0.2}) {
    const FeatureFindings deepest = planned_by_scallop(asked);
    const double stepdown = equal_stepdown(deepest.layers.size());
    const FeatureFindings equal = planned_by_stepdown(stepdown);
    CLEARCUT_ASSERT(equal.layers.size() == deepest.layers.size());
    const bool is_printed = asked == 0.5;
    const double height = equal.scallop->height_mm;
    result.add({fmt::format("{:.2f}", asked), is_printed ? "0.48" : "-", std::to_string(equal.layers.size()),
                fmt::format("{:.4f}", stepdown),
                is_printed ? beside(height, 0.48, 2) : Cell(fmt::format("{:.2f}", height)),
                fmt::format("{:.3f}", deepest.scallop->height_mm)});
  }
  result.table.notes.push_back(
      "measured on the certified program, square to the wall; equal: clearcut plan "
      "examples/fishhead_sloped.p21 --strategy tour "
      "--stepdown 0.6786");
  result.table.notes.push_back(
      "as deep as allowed: every layer but the last takes all of the scallop that is specified");
  return result;
}

}  // namespace clearcut::studies
