// Drill files of circuit boards (Excellon, XNC), see docs/input.md, and the holes and slots of their tools as
// outlines of a drawing.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "model/part.h"
#include "options/read_options.h"
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

/// Holes by tools, each a layer "T1" with the diameter in its name, and slots, as wide as their tool, as pockets.
///
/// Throws  InputError "file:line: ..." for damaged files, tools without a diameter, and unsupported motion commands
/// (patterns, routed arcs). Source: XNC Format Specification, revision 2021.11 (Ucamco); commands of older Excellon
/// machines as far as CAD programs write them.
Part read_excellon(std::string_view text, const std::string& file_name, const ReadOptions& options);

}  // namespace clearcut::read
