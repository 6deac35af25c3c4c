#include "verify/engagement/removal.h"

#include <cmath>

namespace clearcut::verify {

Removal removal_of(const CheckedMove& checked) {
  const Tool& tool = *checked.tool;
  if (checked.is_carried()) return {CutterProfile::cylinder(tool.radius()), tool.radius()};
  const bool asks = !is_conical(tool) && tool.kind != ToolKind::kTSlot;
  return {inner_profile(tool), asks ? tool.radius() : 0};
}

int add_to(stock::Material& material, const Removal& removal) {
  return material.add_cutter(removal.profile, removal.circle);
}

double height_of_edges(const Tool& tool) {
  return tool.kind == ToolKind::kTSlot ? tool.flute_length.value_or(HUGE_VAL) : HUGE_VAL;
}

}  // namespace clearcut::verify
