// Symbols
//
//   kc1.1, mc   steels and cast iron [kienzle1957]; the others rounded from [sandvik2010]
//   mills       middle of the range of speeds and the feeds a tooth of [protocutter]; stainless steel the lower end;
//               woods' feeds [mellowpine] at the lower end, their speeds chosen here
//   hobby_feed  light routers: within [shapeoko-a-to-z]'s windows at 1/8 and 1/4 inch, its hard woods' window
//               for metals
//   energy      N/mm2 from the removal for each horsepower of [shapeoko-a-to-z]; plywood chosen between its two woods
//   drills      high-speed steel, [protocutter]: speeds of each material, feeds by diameter; docs/feeds.md lists all
//   C, n        carbide, [groover2013]: 500 m/min for steel, 900 m/min for softer metals, n = 0.25; titanium half of
//               steel
#include "model/work_material.h"

#include <algorithm>

namespace clearcut::inline model {
namespace {

constexpr std::array<double, 4> kDrillsFreely{0.05, 0.1, 0.18, 0.25};
constexpr std::array<double, 4> kDrillsMiddling{0.04, 0.08, 0.15, 0.22};
constexpr std::array<double, 4> kDrillsHard{0.025, 0.05, 0.1, 0.18};
// One horsepower removes 30, 10 and, between them, 18 cubic inches a minute: 2730 N/mm2 over that.
constexpr double kSoftWoodEnergy = 91, kHardWoodEnergy = 273, kPlywoodEnergy = 150;

}  // namespace

const std::vector<WorkMaterial>& work_materials() {
  static const std::vector<WorkMaterial> materials{
      {"aluminium",
       700,
       0.25,
       900,
       0.25,
       70000,
       240,
       {0.025, 0.05, 0.1, 0.15},
       75,
       kDrillsFreely,
       {0.0254, 0.045, 0.065, 0.065}},
      {"brass",
       780,
       0.18,
       900,
       0.25,
       100000,
       110,
       {0.025, 0.05, 0.076, 0.1},
       60,
       kDrillsFreely,
       {0.018, 0.035, 0.05, 0.05}},
      {"steel",
       1990,
       0.26,
       500,
       0.25,
       210000,
       80,
       {0.013, 0.025, 0.076, 0.11},
       27,
       kDrillsMiddling,
       {0.013, 0.025, 0.035, 0.035}},
      {"alloy-steel",
       2500,
       0.26,
       500,
       0.25,
       210000,
       65,
       {0.013, 0.025, 0.05, 0.1},
       18,
       kDrillsHard,
       {0.013, 0.025, 0.035, 0.035}},
      {"stainless",
       2000,
       0.21,
       500,
       0.25,
       200000,
       60,
       {0.013, 0.025, 0.076, 0.1},
       15,
       kDrillsHard,
       {0.013, 0.025, 0.035, 0.035}},
      {"cast-iron",
       1160,
       0.26,
       500,
       0.25,
       110000,
       90,
       {0.013, 0.025, 0.076, 0.127},
       24,
       kDrillsFreely,
       {0.013, 0.025, 0.035, 0.035}},
      {"titanium",
       1400,
       0.23,
       250,
       0.25,
       115000,
       30,
       {0.008, 0.013, 0.025, 0.05},
       9,
       kDrillsHard,
       {0.008, 0.013, 0.025, 0.025}},
      {"plastic",
       0,
       0,
       0,
       0,
       0,
       300,
       {0.09, 0.18, 0.29, 0.32},
       30,
       kDrillsFreely,
       {0.055, 0.11, 0.18, 0.18},
       kHardWoodEnergy},
      {"softwood",
       0,
       0,
       0,
       0,
       0,
       500,
       {0.1, 0.17, 0.5, 0.5},
       90,
       kDrillsFreely,
       {0.052, 0.095, 0.15, 0.15},
       kSoftWoodEnergy},
      {"hardwood",
       0,
       0,
       0,
       0,
       0,
       400,
       {0.09, 0.17, 0.45, 0.45},
       90,
       kDrillsFreely,
       {0.0254, 0.048, 0.08, 0.08},
       kHardWoodEnergy},
      {"mdf",
       0,
       0,
       0,
       0,
       0,
       450,
       {0.14, 0.34, 0.61, 0.61},
       90,
       kDrillsFreely,
       {0.055, 0.11, 0.18, 0.18},
       kSoftWoodEnergy},
      {"plywood",
       0,
       0,
       0,
       0,
       0,
       450,
       {0.11, 0.22, 0.53, 0.53},
       90,
       kDrillsFreely,
       {0.052, 0.1, 0.16, 0.16},
       kPlywoodEnergy},
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

std::vector<std::string> work_material_names() {
  std::vector<std::string> names;
  for (const WorkMaterial& material : work_materials()) names.push_back(material.name);
  return names;
}

}  // namespace clearcut::inline model
