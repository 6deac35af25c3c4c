#include "pipeline/steps/far_moves.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/format.h"
#include "geometry/box.h"

namespace clearcut::pipeline {
namespace {

/// mm. Permitted distance from the work below its top, where clamps are beside it; and above, where greater distances
/// exceed machines of any size.
constexpr double kFarLow = 50, kFarHigh = 2000;
/// mm, for heights rounded by the coarsest controller (0.0001 inch).
constexpr double kRoundedHeight = 5.5e-3;

Box box_of_work(const Part& part) {
  if (part.stock) return part.stock->plan;
  Box work;
  for (const Feature& feature : part.features) {
    if (!feature.allowed.empty()) work.add(box(feature.allowed));
    if (!feature.target.empty()) work.add(box(feature.target));
  }
  return work;
}

double beyond(const Box& work, const Box& path) {
  return std::max(
      {work.min.x - path.min.x, work.min.y - path.min.y, path.max.x - work.max.x, path.max.y - work.max.y});
}

}  // namespace

std::optional<Condition> far_move(const Part& part, const Toolpath& toolpath) {
  const Box work = box_of_work(part);
  if (work.empty()) return std::nullopt;
  const double low = part.top_z() - kRoundedHeight;
  const Move* farthest = nullptr;
  double most = 0;
  for (const Section& section : toolpath.sections) {
    const Tool* const tool = tool_numbered(part.tools, section.tool_number);
    const double width = tool ? 2 * widest_radius(*tool) : 0;
    for (const Move& move : section.moves) {
      const Box path = move.path.box();
      const double away = beyond(work, path);
      const bool is_low = std::min(move.z_from, move.z_to) < low;
      if (away <= (is_low ? kFarLow + width : kFarHigh) || away <= most) continue;
      farthest = &move;
      most = away;
    }
  }
  if (!farthest) return std::nullopt;
  return Condition{
      "far-move",
      fmt::format("a move to z {} leads {} mm away from the work; it is meant so, and its way is free",
                  trimmed(farthest->z_to, 3), trimmed(most, 1)),
      farthest->line};
}

}  // namespace clearcut::pipeline
