#include "read/gcode/cycle.h"

#include <algorithm>

#include "base/error.h"

namespace clearcut::read::gcode {

namespace {

constexpr double kPeckGap = 0.254;  // mm; how far above the last depth feeding begins again (LinuxCNC)
constexpr double kMostPecks = 10000;

Target height(double z) {
  return {std::nullopt, std::nullopt, z};
}

void peck_down(ToolpathBuilder& builder, const DrillCycle& cycle, MmPerMin feed, int line) {
  const double peck = cycle.peck.value_or(0);
  if (!(peck > 0) || (*cycle.r - *cycle.z) / peck > kMostPecks) {
    throw InputError(builder.place(line), "peck drilling needs a Q word of a sensible size; correct it");
  }
  for (double depth = *cycle.r - peck; depth > *cycle.z; depth -= peck) {
    builder.feed(height(depth), feed, line);
    if (cycle.code == 730) {
      builder.rapid(height(depth + kPeckGap), line);
    } else {
      builder.rapid(height(*cycle.r), line);
      builder.rapid(height(std::min(depth + kPeckGap, *cycle.r)), line);
    }
  }
  builder.feed(height(*cycle.z), feed, line);
}

}  // namespace

bool is_drill_cycle(int code) {
  return code == 730 || code == 740 || (code >= 810 && code <= 860 && code % 10 == 0) || code == 890;
}

void drill(ToolpathBuilder& builder, const DrillCycle& cycle, double clear_z, MmPerMin feed, int line) {
  if (!cycle.z || !cycle.r) {
    throw InputError(builder.place(line), "drilling cycle without its Z or R word; give both");
  }
  if (*cycle.r < *cycle.z) {
    throw InputError(builder.place(line), "drilling cycle whose R lies below its Z; correct it");
  }
  builder.rapid(height(*cycle.r), line);
  if (cycle.code == 730 || cycle.code == 830) {
    peck_down(builder, cycle, feed, line);
  } else {
    builder.feed(height(*cycle.z), feed, line);
  }
  const bool feeds_out = cycle.code == 740 || cycle.code == 840 || cycle.code == 850 || cycle.code == 890;
  if (feeds_out) builder.feed(height(*cycle.r), feed, line);
  builder.rapid(height(clear_z), line);
}

}  // namespace clearcut::read::gcode
