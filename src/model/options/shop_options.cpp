#include "model/options/shop_options.h"

#include <fmt/ranges.h>

#include <cmath>

#include "base/error.h"
#include "model/work_material.h"

namespace clearcut::inline model {
namespace {

template <typename Value>
void fill(std::optional<Value>& value, const std::optional<Value>& other) {
  if (!value) value = other;
}

class Check {
 public:
  explicit Check(std::string prefix) : prefix_(std::move(prefix)) {}

  void require(bool good, const char* name, const std::string& what) const {
    if (!good) throw InputError(prefix_ + name, what);
  }
  void positive(const std::optional<double>& value, const char* name, const char* unit) const {
    require(!value || (std::isfinite(*value) && *value > 0), name, std::string("must be above 0 ") + unit);
  }
  void not_negative(const std::optional<double>& value, const char* name) const {
    require(!value || (std::isfinite(*value) && *value >= 0), name, "must be 0 mm or more");
  }
  void feed(const std::optional<MmPerMin>& value, const char* name) const {
    require(!value || value->mm_per_min() > 0, name, "must be above 0 mm/min");
  }

 private:
  std::string prefix_;
};

}  // namespace

std::optional<double> ShopOptions::widest_helix(std::optional<double> operation_radius) const {
  if (helix_widest || !operation_radius) return helix_widest;
  return 2 * *operation_radius;
}

bool ShopOptions::is_machinist() const {
  if (style) return *style == "machinist";
  const auto work = material ? work_material_named(*material) : std::nullopt;
  return work && work->has_forces();
}

ShopOptions ShopOptions::or_else(const ShopOptions& other) const {
  ShopOptions out = *this;
  fill(out.helix_widest, other.helix_widest);
  fill(out.helix_narrowest, other.helix_narrowest);
  fill(out.lead_feed, other.lead_feed);
  fill(out.lead_overlap, other.lead_overlap);
  fill(out.link_feed, other.link_feed);
  fill(out.overrun, other.overrun);
  fill(out.link_lift, other.link_lift);
  fill(out.slot_angle_deg, other.slot_angle_deg);
  fill(out.rest, other.rest);
  fill(out.finish, other.finish);
  fill(out.finish_stock, other.finish_stock);
  fill(out.finish_stock_floor, other.finish_stock_floor);
  fill(out.finish_depths, other.finish_depths);
  fill(out.dogbones, other.dogbones);
  fill(out.material, other.material);
  fill(out.style, other.style);
  return out;
}

void check(const ShopOptions& options, const std::string& prefix) {
  const Check check(prefix);
  check.positive(options.helix_widest, "helix-diameter", "mm");
  check.positive(options.helix_narrowest, "helix-min", "mm");
  check.feed(options.lead_feed, "lead-feed");
  check.not_negative(options.lead_overlap, "lead-overlap");
  check.feed(options.link_feed, "link-feed");
  check.not_negative(options.overrun, "overrun");
  check.not_negative(options.link_lift, "link-lift");
  const auto& angle = options.slot_angle_deg;
  check.require(!angle || (*angle >= 10 && *angle <= 180), "slot-angle",
                "must lie between 10 and 180 degrees");
  const auto& finish = options.finish;
  check.require(!finish || *finish == "walls" || *finish == "floor" || *finish == "all", "finish",
                "must be walls, floor or all");
  check.not_negative(options.finish_stock, "finish-stock");
  check.not_negative(options.finish_stock_floor, "finish-stock-floor");
  const auto& depths = options.finish_depths;
  check.require(!depths || (*depths >= 1 && *depths <= 1000 && *depths == std::floor(*depths)),
                "finish-depths", "must be a whole number, 1 or more");
  const auto& dogbones = options.dogbones;
  check.require(!dogbones || *dogbones == "corner" || *dogbones == "t-bone", "dogbones",
                "must be corner or t-bone");
  const auto& style = options.style;
  check.require(!style || *style == "machinist" || *style == "fastest", "style",
                "must be machinist or fastest");
  check.require(!options.material || work_material_named(*options.material), "material",
                "'" + options.material.value_or("") + "' is unknown; use one of " +
                    fmt::format("{}", fmt::join(work_material_names(), ", ")));
}

}  // namespace clearcut::inline model
