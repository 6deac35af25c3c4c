#include "verify/part/finished_parts.h"

#include <algorithm>

namespace clearcut::verify {
namespace {

/// mm. A disc is exactly as high as its undercut: rounding of inches, which must not move the disc below the floor,
/// raises it by up to this.
constexpr double kRaisedByDigits = 0.002;

bool has_external_threads(const Part& part) {
  return std::any_of(part.features.begin(), part.features.end(),
                     [](const Feature& feature) { return feature.kind == FeatureKind::kExternalThread; });
}

}  // namespace

FinishedParts::FinishedParts(const Part& part) : part_(part), plain_(part), with_one_(part.features.size()) {
  if (has_external_threads(part)) threaded_.emplace(part, CutFeatures{.threads = true});
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    const Feature& feature = part.features[i];
    const int number = static_cast<int>(i);
    if (feature.wall_slope.radians() > 0) drafted_.push_back(number);
    if (feature.kind == FeatureKind::kTSlot)
      undercuts_.push_back({number, EdgeTree(feature.allowed), feature.top_z + kRaisedByDigits});
  }
  for (const Undercut& undercut : undercuts_) {
    std::unique_ptr<FinishedPart>& opened = opened_[undercut.roof];
    const double top = part.features[static_cast<std::size_t>(undercut.feature)].top_z;
    if (!opened) opened = std::make_unique<FinishedPart>(part, CutFeatures{.undercuts_up_to = top});
  }
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
  if (!one) one = std::make_unique<FinishedPart>(part_, CutFeatures{.only_draft = feature});
  return *one;
}

}  // namespace clearcut::verify
