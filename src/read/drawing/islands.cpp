#include "read/drawing/islands.h"

#include <algorithm>
#include <cmath>

#include "geometry/contours/boolean.h"
#include "read/repair/mends.h"

namespace clearcut::read {
namespace {

/// mm2. Less than this of an outline beyond an island is rounding.
constexpr double kBeyond = 0.01;

bool lies_within(const Region& region, const Regions& islands, const Tolerances& tol) {
  const bool near = std::any_of(islands.begin(), islands.end(),
                                [&](const Region& island) { return island.box().overlaps(region.box()); });
  return near && area(subtract({region}, islands, tol)) < kBeyond;
}

/// Whether a region within an island covers the whole island.
bool is_as_large(const Region& region, const Regions& islands) {
  return std::any_of(islands.begin(), islands.end(), [&](const Region& island) {
    return island.box().overlaps(region.box()) && std::abs(area({island}) - area({region})) < kBeyond;
  });
}

}  // namespace

Regions without_islands(Regions regions, const Regions& islands, const std::string& place,
                        const Tolerances& tol, Diagnostics& diagnostics) {
  Regions within, about;
  for (Region& region : regions)
    (lies_within(region, islands, tol) ? within : about).push_back(std::move(region));
  if (!about.empty()) about = subtract(about, islands, tol);
  for (Region& region : within) {
    if (is_as_large(region, islands)) {
      diagnostics.skip(place, "the outline at " + place_text(region.outer().front().from) +
                                  " is that of an island, which stays; nothing is cut there");
    } else {
      about.push_back(std::move(region));
    }
  }
  return about;
}

}  // namespace clearcut::read
