#include "verify/engagement/removal.h"

#include <cmath>

namespace clearcut::verify {

stock::Removal removal_of(const CheckedMove& checked) {
  const double radius = checked.tool->radius();
  if (checked.is_carried()) return {CutterProfile::cylinder(radius), radius};
  return stock::removal_by(*checked.tool);
}

double height_of_edges(const Tool& tool) {
  return tool.kind == ToolKind::kTSlot ? tool.flute_length.value_or(HUGE_VAL) : HUGE_VAL;
}

}  // namespace clearcut::verify
