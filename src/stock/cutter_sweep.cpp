#include "stock/cutter_sweep.h"

#include <algorithm>

namespace clearcut::stock {

Removal removal_by(const Tool& tool) {
  const bool asks = !is_conical(tool) && tool.kind != ToolKind::kTSlot;
  return {inner_profile(tool), asks ? tool.radius() : 0};
}

double radius_cleared(const Tool& tool, double above) {
  const CutterProfile profile = inner_profile(tool);
  const bool leaves_ridges = profile.round > 0 && profile.flat <= 0 && above < profile.full_height();
  return leaves_ridges ? 0 : std::max(0.0, profile.radius_at(std::max(0.0, above)));
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
