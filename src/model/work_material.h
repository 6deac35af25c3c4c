// What the work is made of, as far as forces and wear depend on it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace clearcut::inline model {

/// Specific cutting force by Kienzle: kc = kc11 h^-mc, h the chip thickness in mm. Tool life by Taylor with cemented
/// carbide: T = (C / vc)^(1 / n) minutes, vc in m/min.
struct WorkMaterial {
  std::string name;
  double kc11 = 0;  ///< N/mm2 at a chip 1 mm thick
  double mc = 0;
  double taylor_c = 0;  ///< m/min for a life of one minute
  double taylor_n = 0;
  double elasticity = 0;  ///< N/mm2
};

/// Sources are told in docs/forces.md.
const std::vector<WorkMaterial>& work_materials();
std::optional<WorkMaterial> work_material_named(const std::string& name);

}  // namespace clearcut::inline model
