// What the tools of a drill file make, as outlines of a drawing.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "read/common/read_options.h"
#include "read/drawing/drawing.h"

namespace clearcut::read {

/// What one tool makes, mm.
struct DrillTool {
  double diameter = 0;
  std::vector<Vec2> holes;
  std::vector<Path> slots;  ///< what its centre follows
};

/// Holes, then slots, of one tool after the other.
///
/// Holes    drilled twice count once. Those of one tool that overlap each other or its slots are areas like slots, because a drill
///          would wander into the hole beside it. Those within slots of wider tools are left out.
std::vector<DrawnGroup> drilled_groups(const std::map<int, DrillTool>& tools, const std::string& file,
                                       const ReadOptions& options, Diagnostics& diagnostics);

}  // namespace clearcut::read
