#include "stock/cutter_sweep.h"

namespace clearcut::stock {

Removal removal_by(const Tool& tool) {
  const bool asks = !is_conical(tool) && tool.kind != ToolKind::kTSlot;
  return {inner_profile(tool), asks ? tool.radius() : 0};
}

int add_tool(Material& material, const Tool& tool) {
  const Removal removal = removal_by(tool);
  return material.add_cutter(removal.profile, removal.circle);
}

void remove_cut(Material& material, const Move& move, const Tool& tool) {
  const int cutter = add_tool(material, tool);
  if (cutter != Material::kCylinder) {
    material.add_sweep(move, cutter);
  } else {
    material.add(move, tool.radius());
  }
}

}  // namespace clearcut::stock
