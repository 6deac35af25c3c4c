#include "verify/length_bounds.h"

#include <optional>

#include "base/units.h"
#include "verify/coverage/feature_work.h"
#include "verify/coverage/length_bound.h"

namespace clearcut::verify {
namespace {

/// mm; the bound of the levels, 0 if none clears the feature.
double bound_of(const FeatureFindings& step) {
  for (const LayerFindings& layer : step.layers)
    if (layer.figures.lower_bound_mm > 0) return layer.figures.lower_bound_mm;
  return 0;
}

/// The bound of this length for the work.
LengthBound bound_of(const Part& part, const FeatureWork& work, double mm) {
  LengthBoundQuestion question;
  question.area = part.features[work.feature].target;
  question.radius = work.greatest_radius;
  question.paths = static_cast<int>(question.area.size());
  LengthBound bound = length_bound(question);
  if (bound.mm == mm) return bound;
  // Some of the area need not be cleared: the rest of it follows from the bound, which is by area alone.
  bound.points.clear();
  bound.rings.clear();
  bound.area_mm2 = 2 * question.radius * mm + question.paths * kPi * question.radius * question.radius;
  bound.mm = mm;
  return bound;
}

}  // namespace

std::vector<StepLengthBound> length_bounds_of(const Part& part, const Findings& findings) {
  std::vector<StepLengthBound> bounds;
  for (const FeatureWork& work : works_of(part)) {
    std::optional<LengthBound> bound;
    for (const FeatureFindings& step : findings.features) {
      if (step.workingstep < 0 || part.workplan[step.workingstep].feature != work.feature) continue;
      const double mm = bound_of(step);
      if (mm <= 0) continue;
      if (!bound) bound = bound_of(part, work, mm);
      bounds.push_back({step.workingstep, *bound});
    }
  }
  return bounds;
}

}  // namespace clearcut::verify
