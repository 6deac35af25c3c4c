#include "verify/without_part.h"

#include <algorithm>
#include <limits>
#include <map>

#include "verify/engagement/forces.h"
#include "verify/faults/causes.h"
#include "verify/faults/faults.h"
#include "verify/figures.h"

namespace clearcut::verify {
namespace {

/// mm. Heights differing by less belong to one layer.
constexpr double kSameHeight = 1e-3;

Figures figures_not_asked(Figures figures) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  figures.uncut_mm2 = figures.uncut_thickness_mm = figures.unreachable_mm2 = none;
  figures.gouge_mm = figures.lower_bound_mm = none;
  return figures;
}

/// The tip of a cone that cuts with its flank alone is in no material: its depth is that of the flank at most.
Figures figures_with_flanks(const std::vector<const CheckedMove*>& moves, double top_z) {
  Figures figures = figures_of(moves, top_z);
  for (const CheckedMove* checked : moves) {
    if (!checked->load.by_flank) continue;
    const double deep = std::min(flank_height(*checked->tool), top_z - checked->low_z());
    figures.max_axial_mm = std::max(figures.max_axial_mm, deep);
  }
  return figures;
}

/// Heights of a tool's level moves through material, the highest first.
std::vector<LayerFindings> layers_of(const std::vector<const CheckedMove*>& moves, double top_z) {
  std::map<long long, std::vector<const CheckedMove*>, std::greater<>> by_height;
  for (const CheckedMove* checked : moves) {
    if (checked->cuts() && checked->is_flat() && !checked->move->is_vertical())
      by_height[std::llround(checked->low_z() / kSameHeight)].push_back(checked);
  }
  std::vector<LayerFindings> layers;
  for (const auto& [height, own] : by_height)
    layers.push_back({own.front()->low_z(), figures_not_asked(figures_of(own, top_z))});
  return layers;
}

/// Figures of the moves of one tool.
FeatureFindings row_of(const std::vector<const CheckedMove*>& own, double top) {
  FeatureFindings row;
  row.tool_number = own.front()->tool_number;
  row.name = "T" + std::to_string(row.tool_number);
  if (own.front()->tool) row.tool_diameter = own.front()->tool->diameter;
  row.figures = figures_not_asked(figures_with_flanks(own, top));
  row.layers = layers_of(own, top);
  return row;
}

}  // namespace

Findings findings_without_part(const Part& part, const CheckedProgram& program,
                               const VerifyOptions& options) {
  Findings findings;
  findings.without_part = true;
  std::vector<const CheckedMove*> all;
  std::vector<int> order;  // order of the tools' first moves
  std::map<int, std::vector<const CheckedMove*>> by_tool;
  for (const CheckedMove& checked : program.moves) {
    if (checked.earlier) continue;
    all.push_back(&checked);
    findings.move_engagement_deg.push_back(static_cast<float>(checked.load.max_deg));
    if (options.material) findings.move_force_n.push_back(force_of(checked));
    auto& own = by_tool[checked.tool_number];
    if (own.empty()) order.push_back(checked.tool_number);
    own.push_back(&checked);
  }
  findings.conditions = conditions_of_moves(program, options);
  findings.faults = faults_of_moves(part, program, options);
  fold_causes(part, program, options, findings.faults);
  sort_worst_first(findings.faults);
  findings.all = figures_not_asked(figures_with_flanks(all, part.top_z()));
  findings.all.clean = findings.faults.empty();
  for (const int number : order) findings.features.push_back(row_of(by_tool[number], part.top_z()));
  return findings;
}

}  // namespace clearcut::verify
