#include "studies/reproduce/reproduce_scallop.h"

#include <fmt/format.h>

#include "base/elementary.h"
#include "base/error.h"
#include "pipeline/run.h"
#include "studies/fishhead.h"

namespace clearcut::studies {
namespace {

constexpr double kSlope = 0.785;  ///< radians, printed
constexpr int kSloped = 5;        ///< POCKET3, among features and steps

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

/// Certified scallop where `asked` mm are allowed.
FeatureFindings planned(double asked) {
  resolve::PlanOptions options;
  options.strategy = "tour";
  options.scallop = asked;
  const pipeline::PlanResult result = pipeline::plan_part(sloped_pocket(), options);
  CLEARCUT_ASSERT(result.findings.all.clean && result.findings.features.front().scallop);
  return result.findings.features.front();
}

/// Steps on the walls where the pocket's depth is shared out equally.
double equal_layers_scallop(std::size_t layers) {
  const Part part = sloped_pocket();
  const Feature& pocket = part.features.front();
  return (pocket.top_z - pocket.floor_z) / static_cast<double>(layers) * base::sin(kSlope);
}

}  // namespace

Reproduction scallop_table() {
  Reproduction result;
  result.table.title = "Tour table 6.1: scallop height on the drafted walls of the sloped fishhead, mm";
  result.table.columns = {
      {"specified"}, {"actual, printed"}, {"equal layers"}, {"ours, measured"}, {"layers"}};
  for (const double asked : {0.5, 0.2}) {
    const auto found = planned(asked);
    const double equal = equal_layers_scallop(found.layers.size());
    const bool is_printed = asked == 0.5;
    result.add({fmt::format("{:.2f}", asked), is_printed ? "0.48" : "-",
                is_printed ? beside(equal, 0.48, 2) : Cell(fmt::format("{:.2f}", equal)),
                fmt::format("{:.3f}", found.scallop->height_mm), std::to_string(found.layers.size())});
  }
  result.table.notes.push_back(
      "equal layers: the depth of the pocket shared out equally, depth / layers times the sine of the slope; "
      "printed is what that gives");
  result.table.notes.push_back(
      "measured on the program, square to the wall, certified clean; every layer but the last is as deep as "
      "the scallop "
      "allows");
  return result;
}

}  // namespace clearcut::studies
