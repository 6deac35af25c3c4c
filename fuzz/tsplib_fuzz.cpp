// Any text as a TSPLIB instance and as a tour: read, or refused in one line. A tour that is read is written and read
// again, the same.
#include <cmath>
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "order/tsplib.h"

namespace {

using namespace clearcut;

constexpr int kSize = 6;  // of the tours

void require_one_line(const InputError& error) {
  CLEARCUT_ASSERT(std::string_view(error.what()).find('\n') == std::string_view::npos);
}

void read_instance(std::string_view text) {
  try {
    const order::Problem problem = order::read_tsplib(text, "fuzz.tsp");
    CLEARCUT_ASSERT(!problem.points.empty());
    for (const Vec2 p : problem.points) CLEARCUT_ASSERT(std::isfinite(p.x) && std::isfinite(p.y));
  } catch (const InputError& error) {
    require_one_line(error);
  }
}

void read_tour(std::string_view text) {
  order::Tour tour;
  try {
    tour = order::read_tsplib_tour(text, "fuzz.tour", kSize);
  } catch (const InputError& error) {
    return require_one_line(error);
  }
  CLEARCUT_ASSERT(order::read_tsplib_tour(order::write_tsplib_tour(tour, "again"), "again", kSize) == tour);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  read_instance(text);
  read_tour(text);
  return 0;
}
