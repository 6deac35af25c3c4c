// Material of the work: the properties that determine feeds, forces and wear.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace clearcut::inline model {

/// Diameters for which WorkMaterial states feeds, mm.
inline constexpr std::array<double, 4> kFeedDiameters{3.175, 6.35, 12.7, 19.05};

/// Specific cutting force by Kienzle: kc = kc11 h^-mc, h the chip thickness in mm. Tool life by Taylor with cemented
/// carbide: T = (C / vc)^(1 / n) minutes, vc in m/min.
struct WorkMaterial {
  std::string name;
  double kc11 = 0;  ///< N/mm2 at a chip 1 mm thick
  double mc = 0;
  double taylor_c = 0;  ///< m/min for a life of one minute
  double taylor_n = 0;
  double elasticity = 0;  ///< N/mm2

  double mill_speed = 0;                  ///< m/min, uncoated carbide
  std::array<double, 4> mill_feed = {};   ///< mm a tooth, at kFeedDiameters
  double drill_speed = 0;                 ///< m/min, high-speed steel
  std::array<double, 4> drill_feed = {};  ///< mm a turn, at kFeedDiameters
  std::array<double, 4> hobby_feed = {};  ///< mm a tooth on light machines, at kFeedDiameters
  /// N/mm2 (J/cm3) for chips of any thickness; used for limits on power and force if Kienzle's values are not known.
  double specific_energy = 0;

  /// Whether forces and wear are known; for woods and plastics they are not.
  bool has_forces() const { return kc11 > 0; }
};

/// Sources are listed in docs/forces.md and docs/feeds.md.
const std::vector<WorkMaterial>& work_materials();
std::optional<WorkMaterial> work_material_named(const std::string& name);
/// All names accepted by work_material_named().
std::vector<std::string> work_material_names();

}  // namespace clearcut::inline model
