#include "verify/part/finished_parts.h"

#include <algorithm>

namespace clearcut::verify {
namespace {

bool has_external_threads(const Part& part) {
  return std::any_of(part.features.begin(), part.features.end(),
                     [](const Feature& feature) { return feature.kind == FeatureKind::kExternalThread; });
}

}  // namespace

FinishedParts::FinishedParts(const Part& part) : part_(part), plain_(part), with_one_(part.features.size()) {
  if (has_external_threads(part)) threaded_.emplace(part, CutFeatures{.threads = true, .only_draft = {}});
  for (std::size_t i = 0; i < part.features.size(); ++i)
    if (part.features[i].wall_slope.radians() > 0) drafted_.push_back(static_cast<int>(i));
}

std::vector<int> FinishedParts::drafted_at(Vec2 p) const {
  std::vector<int> at;
  std::copy_if(drafted_.begin(), drafted_.end(), std::back_inserter(at),
               [&](int feature) { return plain_.is_inside(feature, p); });
  return at;
}

const FinishedPart& FinishedParts::with_one_draft(int feature) const {
  const std::lock_guard lock(mutex_);
  std::unique_ptr<FinishedPart>& one = with_one_[static_cast<std::size_t>(feature)];
  if (!one) one = std::make_unique<FinishedPart>(part_, CutFeatures{.threads = false, .only_draft = feature});
  return *one;
}

}  // namespace clearcut::verify
