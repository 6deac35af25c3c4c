#include "model/options/shop_options.h"

#include "model/work_material.h"

namespace clearcut::inline model {
std::optional<double> ShopOptions::widest_helix(std::optional<double> operation_radius) const {
  if (helix_widest || !operation_radius) return helix_widest;
  return 2 * *operation_radius;
}

bool ShopOptions::is_machinist() const {
  if (style) return *style == "machinist";
  const auto work = material ? work_material_named(*material) : std::nullopt;
  return work && work->has_forces();
}

}  // namespace clearcut::inline model
