#include "plan/common/leaves_nothing.h"

#include <vector>

#include "geometry/contours/boolean.h"
#include "geometry/route/legal_area.h"
#include "plan/common/cover.h"

namespace clearcut::plan {
namespace {

/// mm. Thickness of residuals permitted between exactly meeting rings.
constexpr double kThinResidual = 0.0035;

}  // namespace

bool leaves_nothing(const LayerPasses& passes, double tool_radius) {
  std::vector<Edge> edges;
  for (const Pass& pass : passes.passes) edges.insert(edges.end(), pass.path.begin(), pass.path.end());
  const LegalArea legal(passes.legal);
  const Cover cover(edges, tool_radius + kThinResidual, Cover::SearchPlaces::kAtRims);
  return !cover.has_hole(box(passes.target),
                         [&](Vec2 p) { return legal.contains(p) && contains(passes.target, p); });
}

}  // namespace clearcut::plan
