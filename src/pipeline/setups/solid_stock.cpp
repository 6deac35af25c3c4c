#include "pipeline/setups/solid_stock.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
#include "pipeline/run.h"
#include "read/moved_part.h"
#include "stock/tools/fitting.h"

namespace clearcut::pipeline {
namespace {

/// mm that what goes through the block ends below it, so that it lies below all that a plan cuts there.
constexpr double kBelowBlock = 2;
/// mm. A floor that lies no higher above the block's underside goes through it.
constexpr double kAtUnderside = 0.001;

bool is_flat_mill(const Tool& tool) {
  return (tool.kind == ToolKind::kEndMill || tool.kind == ToolKind::kFaceMill) && tool.corner_radius == 0;
}

/// As long as is needed, for nothing is milled with it.
Tool narrowest_mill(const std::vector<Tool>& tools) {
  std::optional<Tool> found;
  for (const Tool& tool : tools) {
    if (is_flat_mill(tool) && (!found || tool.diameter < found->diameter)) found = tool;
  }
  if (!found)
    throw InputError(
        "--stock-from",
        "what the stock lacks is found by a flat end mill; give one, for example --tool endmill:6");
  Tool mill;
  mill.number = found->number;
  mill.kind = ToolKind::kEndMill;
  mill.diameter = found->diameter;
  return mill;
}

/// In the coordinates of the part, whose block it is.
Part moved_onto(Part stock, const Stock& block) {
  const Stock own = *stock.stock;
  return read::with_zero_at(std::move(stock), {own.plan.min.x - block.plan.min.x,
                                               own.plan.min.y - block.plan.min.y, own.z_top - block.z_top});
}

/// Leaves what the mill does not go into.
void keep_reachable(Part& stock, const Tool& mill, const Tolerances& tol) {
  std::erase_if(stock.workplan, [&](const Workingstep& step) {
    return stock::largest_fitting_diameter(feature_of(stock, step), tol) < mill.diameter;
  });
}

Section carried(const Section& section, const Move& move) {
  Section one;
  one.label = "stock";
  one.tool_number = section.tool_number;
  one.spindle_rpm = section.spindle_rpm;
  one.carried_below = std::numeric_limits<double>::infinity();
  one.is_of_stock = true;
  one.moves.push_back(move);
  return one;
}

/// The cuts of a section; those through the block once more, below it.
void append_cuts(const Section& section, double bottom, Toolpath& out) {
  for (const Move& move : section.moves) {
    if (is_rapid(move.kind)) continue;
    Section own = carried(section, move);
    if (move.z_to <= bottom + kAtUnderside) {
      Section below = own;
      below.is_of_stock = false;
      below.moves.front().z_from -= kBelowBlock;
      below.moves.front().z_to -= kBelowBlock;
      out.sections.push_back(std::move(below));
    }
    out.sections.push_back(std::move(own));
  }
}

}  // namespace

Toolpath missing_of(Part stock, const Part& part, const std::vector<Tool>& tools) {
  resolve::PlanOptions options;
  const Tool mill = narrowest_mill(tools);
  stock = moved_onto(std::move(stock), *part.stock);
  const Stock block = *stock.stock;
  keep_reachable(stock, mill, options.tol);
  Toolpath missing;
  if (stock.workplan.empty()) return missing;
  options.tools = {mill};
  options.strategy = "contour";
  options.stepdown = block.z_top - block.z_bottom + kBelowBlock;
  const PlanResult plan = plan_part(stock, options);
  for (const Section& section : plan.toolpath.sections) append_cuts(section, block.z_bottom, missing);
  return missing;
}

}  // namespace clearcut::pipeline
