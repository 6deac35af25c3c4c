#include "studies/reproduce_scallop.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "pipeline/run.h"
#include "studies/fishhead.h"

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

/// Certified scallop where `asked` mm are allowed.
FeatureFindings planned(double asked) {
  resolve::PlanOptions options;
  options.strategy = "tour";
  options.scallop = asked;
  const pipeline::PlanResult result = pipeline::plan_part(sloped_pocket(), options);
  CLEARCUT_ASSERT(result.findings.all.clean && result.findings.features.front().scallop);
  return result.findings.features.front();
}

}  // namespace

report::TextTable scallop_table() {
  report::TextTable table;
  table.title = "Tour table 6.1: scallop height on the leaning walls of the sloped fishhead, mm";
  table.columns = {{"specified"}, {"actual, printed"}, {"ours"}, {"layers"}};
  for (const double asked : {0.5, 0.2}) {
    const auto found = planned(asked);
    table.add({fmt::format("{:.2f}", asked), asked == 0.5 ? "0.48" : "-",
               fmt::format("{:.3f}", found.scallop->height_mm), std::to_string(found.layers.size())});
  }
  table.notes.push_back(
      "square to the wall, certified clean; every layer but the last is as deep as the scallop allows");
  return table;
}

}  // namespace clearcut::studies
