#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "geometry/region.h"
#include "resolve/features/shaping.h"
#include "resolve/values/cutting_values.h"

namespace clearcut::resolve {
namespace {

/// mm. Less is how a height was rounded.
constexpr double kFlush = 1e-4;

std::string free_name(const Part& part) {
  const auto taken = [&](const std::string& name) {
    return std::any_of(part.features.begin(), part.features.end(),
                       [&](const Feature& feature) { return feature.name == name; });
  };
  std::string name = "FACING";
  while (taken(name)) name += "_";
  return name;
}

int widest_mill(const Part& part) {
  int widest = 0;
  for (std::size_t i = 0; i < part.tools.size(); ++i) {
    const Tool &tool = part.tools[i], &best = part.tools[static_cast<std::size_t>(widest)];
    if (mills_upright(tool) && (!mills_upright(best) || tool.diameter > best.diameter))
      widest = static_cast<int>(i);
  }
  return widest;
}

}  // namespace

void add_facing(Part& part, const PlanOptions& options) {
  if (!part.stock || part.features.empty()) return;
  const auto highest = std::max_element(part.features.begin(), part.features.end(),
                                        [](const Feature& a, const Feature& b) { return a.top_z < b.top_z; });
  const double top = highest->top_z;
  if (part.stock->z_top <= top + kFlush) return;
  Feature face;
  face.name = free_name(part);
  face.kind = FeatureKind::kPlanarFace;
  face.target = {rectangular_region(part.stock->plan)};
  face.allowed = {rectangular_region(part.stock->plan.grown(kOpenReach))};
  face.top_z = part.stock->z_top;
  face.floor_z = top;
  Workingstep step;
  step.name = face.name;
  step.feature = static_cast<int>(part.features.size());
  step.operation.name = face.name;
  if (options.tools.empty() && !part.tools.empty())
    change_tool(step.operation, widest_mill(part), part, options);
  part.diagnostics.note(
      face.name,
      fmt::format("the stock stands up to z {}, {} mm over all that is milled: it is faced off to z {} "
                  "first",
                  trimmed(face.top_z, 3), trimmed(face.top_z - top, 3), trimmed(top, 3)));
  part.features.push_back(std::move(face));
  part.workplan.insert(part.workplan.begin(), std::move(step));
}

}  // namespace clearcut::resolve
