#include "pipeline/steps/t_slot_step.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "link/tracks/tracks.h"
#include "pipeline/steps/certify.h"
#include "post/post.h"

namespace clearcut::pipeline {

std::optional<Section> t_slot_step(int workingstep, const ResolvedPlan& plan) {
  const Workingstep& step = plan.part.workplan[static_cast<std::size_t>(workingstep)];
  const Feature& feature = feature_of(plan.part, step);
  if (!feature.t_slot) return std::nullopt;
  Path way = feature.profile->line;
  if (!feature.t_slot->leaves_at_end) {
    const Path back = reversed(way);
    way.insert(way.end(), back.begin(), back.end());
  }
  // Coarse digits put the tip no lower than half of the smallest gouge.
  const double z = feature.floor_z + std::max(0.0, post::rounding_of_heights(plan.post) - plan.tol.gouge / 2);
  Track track;
  for (const Edge& edge : way) track.pieces.push_back({edge, z, z});
  std::vector<std::vector<Track>> sets{{std::move(track)}};
  const link::LinkOptions link =
      link_options(plan, workingstep, plan.steps[static_cast<std::size_t>(workingstep)].entry);
  Section section = link::link_tracks(std::move(sets), plan.part.top_z() + link.above_material, link);
  describe(section, workingstep, plan);
  return section;
}

}  // namespace clearcut::pipeline
