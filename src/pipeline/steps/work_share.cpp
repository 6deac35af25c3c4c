#include "pipeline/steps/work_share.h"

#include <algorithm>

namespace clearcut::pipeline {
namespace {

/// mm2; area to be cleared by the layers of a step.
double area_of(const StepWork& work) {
  double all = 0;
  for (const auto& layer : work.layers) all += area(layer.layer.target);
  return all;
}

}  // namespace

std::vector<std::uint64_t> work_shares(const std::vector<StepWork>& works, const ResolvedPlan& plan) {
  double all = 0;
  for (const StepWork& work : works) all += area_of(work);
  std::vector<std::uint64_t> shares;
  for (std::size_t i = 0; i < works.size(); ++i) {
    const double share = all > 0 ? area_of(works[i]) / all : 1;
    const auto own = static_cast<std::uint64_t>(share * static_cast<double>(kMostWork));
    shares.push_back(plan.steps[i].strategy ? kMostWorkAlone : std::max(own, kLeastWork));
  }
  return shares;
}

}  // namespace clearcut::pipeline
