// What each kind of tool is: one row a kind, of which every question about kinds is answered.
#pragma once

#include <span>

#include "model/tool.h"

namespace clearcut::inline model {

/// The work that a kind of tool is made for.
enum class ToolUse : unsigned char {
  kFloors,    ///< clears areas down to a floor
  kHoles,     ///< goes straight down and makes a hole of its own diameter
  kEdges,     ///< a cone that breaks edges, engraves and spots
  kThreads,   ///< cuts a thread into a hole or about a boss
  kUndercuts  ///< a disc on a neck that cuts below material
};

/// The outline of the cutting part, from the tip up.
enum class CutterForm : unsigned char {
  kRounded,  ///< a flat, an arc of the corner radius, then upright: also flat mills and balls
  kPointed,  ///< the point of a drill, then upright
  kUpright,  ///< a flat end and upright sides
  kFlanked   ///< a flat or a point, then flanks that widen upwards
};

struct ToolKindRow {
  ToolKind kind;
  const char* name;  ///< as on the command line
  ToolUse use;
  CutterForm form;
  bool straight_down = false;  ///< feeds and speeds are those of drilling
};

/// In the order in which messages list them; "other", which no option names, is the last.
std::span<const ToolKindRow> tool_kinds();
const ToolKindRow& row_of(ToolKind kind);

}  // namespace clearcut::inline model
