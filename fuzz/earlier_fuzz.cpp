// Any program as one that has run before: what it leaves of a pocket lies in the pocket.
#include <cstdint>
#include <string_view>

#include "base/error.h"
#include "geometry/contours/boolean.h"
#include "read/gcode/gcode.h"
#include "resolve/left_over.h"
#include "resolve/values/plan_options.h"

namespace {

using namespace clearcut;

Part pocket() {
  const Vec2 corners[] = {{0, 0}, {40, 0}, {40, 30}, {0, 30}};
  Part part;
  for (const int number : {1, 2, 3}) {
    Tool tool;
    tool.number = number;
    tool.diameter = 3.0 * number;
    part.tools.push_back(tool);
  }
  Feature feature;
  feature.target = {Region::from_valid_loops(loop_from_points(corners), {})};
  feature.allowed = feature.target;
  feature.floor_z = -2;
  part.features.push_back(feature);
  part.workplan.push_back(Workingstep{});
  return part;
}

/// Booleans take the time that the program's length asks for.
bool is_small(const Toolpath& toolpath) {
  double moves = 0;
  for (const Section& section : toolpath.sections)
    for (const Move& move : section.moves) moves += 1 + (move.path.is_arc() ? move.length() / 5 : 0);
  return moves < 300;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  PlanOptions options;
  try {
    options.earlier = read::gcode::read_gcode({reinterpret_cast<const char*>(data), size}, "fuzz").toolpath;
  } catch (const InputError&) {
    return 0;
  }
  if (!is_small(*options.earlier)) return 0;
  static const Part part = pocket();
  const Layer layer{
      .z = -2, .target = part.features[0].target, .allowed = part.features[0].allowed, .tool_radius = 1.5};
  const Regions left = resolve::left_over(part, 0, layer, options.earlier, options.tol);
  CLEARCUT_ASSERT(area(left) <= 40 * 30 + 1e-6);
  CLEARCUT_ASSERT(area(subtract(left, layer.target, options.tol)) < 1e-3);
  return 0;
}
