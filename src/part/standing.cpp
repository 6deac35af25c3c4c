#include "part/standing.h"

#include <algorithm>

#include "geometry/boolean.h"

namespace clearcut {
namespace {

/// Heights nearer than this are one height, mm.
constexpr double kSameHeight = 1e-6;

bool is_cut_to(const Part& part, const Workingstep& step, double z) {
  const auto& feature = part.features[static_cast<std::size_t>(step.feature)];
  return step.operation.allowance_side == 0 && feature.wall_slope.radians() == 0 &&
         feature.floor_z + step.operation.allowance_floor <= z + kSameHeight;
}

}  // namespace

Regions standing_above(const Part& part, int index, const Regions& target, double z, const Tolerances& tol) {
  const auto& own = part.workplan[static_cast<std::size_t>(index)];
  Regions standing = target;
  std::vector<int> done{own.feature};
  for (int i = 0; i < index && !standing.empty(); ++i) {
    const auto& step = part.workplan[static_cast<std::size_t>(i)];
    const bool seen = std::find(done.begin(), done.end(), step.feature) != done.end();
    if (seen || !is_cut_to(part, step, z)) continue;
    done.push_back(step.feature);
    const auto& cut = part.features[static_cast<std::size_t>(step.feature)].target;
    if (box(cut).overlaps(box(standing))) standing = subtract(standing, cut, tol);
  }
  return standing;
}

}  // namespace clearcut
