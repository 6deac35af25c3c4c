#include "pipeline/setups/solid_stock.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/error.h"
#include "features/tool_choice.h"
#include "pipeline/run.h"
#include "read/common/moved_part.h"

namespace clearcut::pipeline {
namespace {

/// mm; depth of through openings below the block, so that they are below all cuts of a plan there.
constexpr double kBelowBlock = 2;
/// mm. A floor no higher above the block's underside counts as through.
constexpr double kAtUnderside = 0.001;

bool is_flat_mill(const Tool& tool) {
  return (tool.kind == ToolKind::kEndMill || tool.kind == ToolKind::kFaceMill) && tool.corner_radius == 0;
}

/// As long as needed, since the mill makes no real cuts.
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

/// Moves the stock into the coordinates of the part and its block.
Part moved_onto(Part stock, const Stock& block) {
  const Stock own = *stock.stock;
  return read::with_zero_at(std::move(stock), {own.plan.min.x - block.plan.min.x,
                                               own.plan.min.y - block.plan.min.y, own.z_top - block.z_top});
}

/// Leaves out areas that the mill cannot enter.
void keep_reachable(Part& stock, const Tool& mill, const Tolerances& tol) {
  std::erase_if(stock.workplan, [&](const Workingstep& step) {
    return features::largest_fitting_diameter(feature_of(stock, step), tol) < mill.diameter;
  });
}

Section lacking(const Section& section, bool is_of_stock) {
  Section like;
  like.label = "stock";
  like.tool_number = section.tool_number;
  like.spindle_rpm = section.spindle_rpm;
  like.carried_below = std::numeric_limits<double>::infinity();
  like.is_of_stock = is_of_stock;
  return like;
}

Move lowered(Move move, double by) {
  move.z_from -= by;
  move.z_to -= by;
  return move;
}

/// The cuts of a section; cuts ending at the underside of the block are added once more below it.
void append_cuts(const Section& section, double bottom, Sweeps& out) {
  const auto cuts = [](const Move& move) { return !is_rapid(move.kind); };
  for (const Move& move : section.moves)
    if (cuts(move)) out.add(lacking(section, true), move);
  for (const Move& move : section.moves)
    if (cuts(move) && move.z_to <= bottom + kAtUnderside)
      out.add(lacking(section, false), lowered(move, kBelowBlock));
}

}  // namespace

Toolpath missing_of(Part stock, const Stock& block, const std::vector<Tool>& tools) {
  PlanOptions options;
  const Tool mill = narrowest_mill(tools);
  stock = moved_onto(std::move(stock), block);
  keep_reachable(stock, mill, options.tol);
  if (stock.workplan.empty()) return {};
  options.tools = {mill};
  options.strategy = "contour";
  options.stepdown = block.z_top - block.z_bottom + kBelowBlock;
  const PlanResult plan = plan_part(stock, options);
  Sweeps missing;
  for (const Section& section : plan.toolpath.sections) append_cuts(section, block.z_bottom, missing);
  return missing.take();
}

}  // namespace clearcut::pipeline
