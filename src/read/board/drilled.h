// Holes and slots of a drill file's tools, as outlines of a drawing.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "read/common/read_options.h"
#include "read/drawing/drawing.h"

namespace clearcut::read {

/// Holes and slots of one tool, mm.
struct DrillTool {
  double diameter = 0;
  std::vector<Vec2> holes;
  std::vector<Path> slots;  ///< paths of its centre
};

/// Holes, then slots, of one tool after the other.
///
/// Holes    drilled twice count once. Holes of one tool that overlap each other or its slots become areas like slots,
///          because a drill would wander into the neighbouring hole. Holes within slots of wider tools are left out.
std::vector<DrawnGroup> drilled_groups(const std::map<int, DrillTool>& tools, const std::string& file,
                                       const ReadOptions& options, Diagnostics& diagnostics);

}  // namespace clearcut::read
