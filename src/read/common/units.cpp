#include "read/common/units.h"

#include <array>
#include <utility>

#include "base/error.h"
#include "base/inch.h"
#include "read/common/text.h"

namespace clearcut::read {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 16> kUnits{{
    {"mm", 1},
    {"millimeter", 1},
    {"millimeters", 1},
    {"cm", 10},
    {"m", 1000},
    {"um", 0.001},
    {"in", kMmPerInch},
    {"inch", kMmPerInch},
    {"inches", kMmPerInch},
    {"ft", 12 * kMmPerInch},
    {"mil", kMmPerInch / 1000},
    {"thou", kMmPerInch / 1000},
    {"pt", kMmPerInch / 72},
    {"pc", kMmPerInch / 6},
    {"px", kMmPerInch / 96},
    {"q", 0.25},
}};

}  // namespace

std::optional<double> mm_per_unit(std::string_view name) {
  const std::string wanted = capitals(name);
  for (const auto& [unit, mm] : kUnits) {
    if (wanted == capitals(unit)) return mm;
  }
  return std::nullopt;
}

const std::string& known_units() {
  static const std::string names = "mm, cm, m, um, in, ft, mil, pt, pc, px";
  return names;
}

double require_unit(std::string_view name, const std::string& place) {
  const auto unit = mm_per_unit(name);
  if (!unit) {
    throw InputError(place, "unknown unit '" + printable(name) + "'; use one of " + known_units());
  }
  return *unit;
}

}  // namespace clearcut::read
