#include "verify/without_part.h"

#include <algorithm>
#include <limits>
#include <map>

#include "verify/engagement/forces.h"
#include "verify/faults/faults.h"
#include "verify/figures.h"

namespace clearcut::verify {
namespace {

/// mm. Heights that differ by less belong to one layer.
constexpr double kSameHeight = 1e-3;

Figures figures_not_asked(Figures figures) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  figures.uncut_mm2 = figures.uncut_thickness_mm = figures.unreachable_mm2 = none;
  figures.gouge_mm = figures.lower_bound_mm = none;
  return figures;
}

/// Heights at which a tool runs level through material, the highest first.
std::vector<LayerFindings> layers_of(const std::vector<const JudgedMove*>& moves, double top_z) {
  std::map<long long, std::vector<const JudgedMove*>, std::greater<>> by_height;
  for (const JudgedMove* judged : moves) {
    if (judged->cuts() && judged->is_flat() && !judged->move->is_vertical())
      by_height[std::llround(judged->low_z() / kSameHeight)].push_back(judged);
  }
  std::vector<LayerFindings> layers;
  for (const auto& [height, own] : by_height)
    layers.push_back({own.front()->low_z(), figures_not_asked(figures_of(own, top_z))});
  return layers;
}

}  // namespace

Findings findings_without_part(const Part& part, const JudgedProgram& program, const VerifyOptions& options) {
  Findings findings;
  findings.without_part = true;
  std::vector<const JudgedMove*> all;
  std::vector<int> order;  // of the tools' first moves
  std::map<int, std::vector<const JudgedMove*>> by_tool;
  for (const JudgedMove& judged : program.moves) {
    if (judged.earlier) continue;
    all.push_back(&judged);
    findings.move_engagement_deg.push_back(static_cast<float>(judged.load.max_deg));
    if (options.material) findings.move_force_n.push_back(force_of(judged));
    auto& own = by_tool[judged.tool_number];
    if (own.empty()) order.push_back(judged.tool_number);
    own.push_back(&judged);
  }
  findings.faults = faults_of_moves(part, program, options);
  sort_worst_first(findings.faults);
  findings.all = figures_not_asked(figures_of(all, part.top_z()));
  findings.all.clean = findings.faults.empty();
  for (const int number : order) {
    const std::vector<const JudgedMove*>& own = by_tool[number];
    FeatureFindings row;
    row.name = "T" + std::to_string(number);
    row.tool_number = number;
    if (own.front()->tool) row.tool_diameter = own.front()->tool->diameter;
    row.figures = figures_not_asked(figures_of(own, part.top_z()));
    row.layers = layers_of(own, part.top_z());
    findings.features.push_back(std::move(row));
  }
  return findings;
}

}  // namespace clearcut::verify
