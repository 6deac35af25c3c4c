#include "plan/contour/line_distance.h"

#include <fmt/format.h>

#include "base/error.h"
#include "plan/contour/contour.h"

namespace clearcut::plan {

std::optional<double> line_distance(const Stepover& stepover, double diameter) {
  using Kind = contour::StepRule::Kind;
  if (!stepover.is_given()) return std::nullopt;
  const contour::StepRule rule = contour::parse_step_rule(stepover.text);
  if (rule.kind == Kind::kWidest) return std::nullopt;
  if (rule.kind == Kind::kFraction) return rule.value * diameter;
  if (rule.kind == Kind::kMm) return rule.value;
  throw InputError("--stepover", fmt::format("'{}' is a rule for contours; give a fraction of the diameter "
                                             "or mm, for example 0.8 or 4.5mm",
                                             stepover.text));
}

}  // namespace clearcut::plan
