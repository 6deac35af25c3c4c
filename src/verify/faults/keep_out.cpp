#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/text.h"
#include "verify/faults/faults.h"

namespace clearcut::verify {
namespace {

/// mm. Coming nearer by less is rounding.
constexpr double kTouch = 1e-3;

/// A cylinder of the tool: the height of its lower end above the tip, and its radius, mm. It extends upwards without
/// limit.
struct Cylinder {
  double above;
  double radius;
};

std::array<Cylinder, 3> cylinders_of(const Tool& tool) {
  const double shank = tool.flute_length ? std::max(tool.shank_diameter, tool.diameter) : tool.diameter;
  return {{{0, tool.radius()},
           {tool.flute_length.value_or(0), shank / 2},
           {tool.stickout.value_or(0), tool.stickout ? tool.holder_diameter / 2 : 0}}};
}

/// mm; distance of a path in plan from a box, 0 within.
double distance_of(const Edge& path, const Box& box) {
  if (box.contains(path.from) || box.contains(path.to)) return 0;
  if (path.from == path.to) return box.distance_to(path.from);
  const std::array<Vec2, 4> corners{box.min, Vec2{box.max.x, box.min.y}, box.max, Vec2{box.min.x, box.max.y}};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 4; ++i)
    least = std::min(least, distance(path, Edge::line(corners[i], corners[(i + 1) % 4])));
  return least;
}

/// The part of the path on which the tip is below z; nothing if there is none.
std::optional<Edge> path_below(const Move& move, double z) {
  if (std::min(move.z_from, move.z_to) >= z) return std::nullopt;
  if (move.is_vertical()) return Edge::line(move.path.from, move.path.from);
  if (std::max(move.z_from, move.z_to) <= z) return move.path;
  const double t = (z - move.z_from) / (move.z_to - move.z_from);
  return move.z_from < z ? move.path.part(0, t) : move.path.part(t, 1);
}

/// mm; depth of the tool inside the block, seen from above; 0 if it stays outside.
double depth_in(const KeepOut& block, const CheckedMove& checked, double radius, double above) {
  const auto path = path_below(*checked.move, block.top_z - above - kTouch);
  return path ? radius - distance_of(*path, block.plan) : 0;
}

/// mm; top of the highest clamp.
double highest_of(const Part& part) {
  double top = -std::numeric_limits<double>::infinity();
  for (const KeepOut& block : part.keep_outs) top = std::max(top, block.top_z);
  return top;
}

}  // namespace

std::string stickout_that_clears(double top, double lowest) {
  return ", which a stickout of " + trimmed(std::ceil(10 * (top - lowest + kTouch)) / 10, 1) + " mm clears";
}

std::optional<Fault> keep_out_fault(const Part& part, const CheckedMove& checked, double lowest) {
  for (const KeepOut& block : part.keep_outs) {
    double most = 0;
    const char* what = "";
    const auto cylinders = checked.tool ? cylinders_of(*checked.tool) : std::array<Cylinder, 3>{};
    constexpr std::array<const char*, 3> kNames{"The cutter", "The shank", "The holder"};
    for (std::size_t i = 0; i < cylinders.size(); ++i) {
      const double depth = depth_in(block, checked, cylinders[i].radius, cylinders[i].above);
      if (depth > std::max(most, kTouch)) most = depth, what = kNames[i];
    }
    if (most <= 0) continue;
    const Place place{checked.move->path.to, checked.low_z(), checked.move->line};
    return fault_of(part, FaultKind::kKeepOut, checked, place, most,
                    std::string(what) + " comes " + trimmed(most, 3) + " mm into the clamp at x " +
                        trimmed(block.plan.min.x, 3) + " to " + trimmed(block.plan.max.x, 3) + ", y " +
                        trimmed(block.plan.min.y, 3) + " to " + trimmed(block.plan.max.y, 3) +
                        (what == kNames[2] ? stickout_that_clears(highest_of(part), lowest) : ""));
  }
  return std::nullopt;
}

}  // namespace clearcut::verify
