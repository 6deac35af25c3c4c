// Symbols
//
//   kc1.1, mc   steels and cast iron [kienzle1957]; the others rounded from [sandvik2010]
//   C, n        carbide, [groover2013]: 500 m/min for steel, 900 m/min for softer metals, n = 0.25; titanium half of steel
#include "model/work_material.h"

#include <algorithm>

namespace clearcut::inline model {

const std::vector<WorkMaterial>& work_materials() {
  static const std::vector<WorkMaterial> materials{
      {"aluminium", 700, 0.25, 900, 0.25, 70000},   {"brass", 780, 0.18, 900, 0.25, 100000},
      {"steel", 1990, 0.26, 500, 0.25, 210000},     {"alloy-steel", 2500, 0.26, 500, 0.25, 210000},
      {"stainless", 2000, 0.21, 500, 0.25, 200000}, {"cast-iron", 1160, 0.26, 500, 0.25, 110000},
      {"titanium", 1400, 0.23, 250, 0.25, 115000},
  };
  return materials;
}

std::optional<WorkMaterial> work_material_named(const std::string& name) {
  const auto& all = work_materials();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const WorkMaterial& m) { return m.name == name; });
  if (found == all.end()) return std::nullopt;
  return *found;
}

}  // namespace clearcut::inline model
