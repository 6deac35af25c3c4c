// Toolpaths that an operation states.
#pragma once

#include <optional>

#include "model/stated_path.h"
#include "model/tool.h"
#include "read/stepnc/file/node.h"
#include "read/stepnc/shapes/placement.h"

namespace clearcut::read::stepnc {

/// What the toolpaths of an operation are read with.
struct ToolpathSetting {
  Frame placement;  ///< of the feature, in the program's coordinates: toolpaths are given in it
  Tool tool;
};

/// its_toolpath of an operation; nothing where it has none.
///
/// Shape   CUTTER_LOCATION_TRAJECTORY: the tip's way. CUTTER_CONTACT_TRAJECTORY: the same where a flat end cuts the floor (FRONT or no
///         contact type). FEEDSTOP: a dwell after the move before it. CONNECT_DIRECT: straight to the next one. Curves: polylines, lines,
///         arcs in level planes, and composites of them; a polyline named "HELIX CCW x y" (or CW) whose points lie on that helix is the helix.
/// Feeds   its_speed (RAPID, a ratio, or a constant TOOLPATH_SPEED), else its_technology, else that of the operation.
/// Throws  InputError for what is not among these, with the entity.
std::optional<StatedPath> read_toolpath(const Node& operation, const ToolpathSetting& setting,
                                        Context& context);

/// The feed of a technology as it stands: m/s, or mm/min where that is more than any cutter is fed; nothing where there is none.
std::optional<MmPerMin> feed_of_technology(const Node& technology, Context& context);

}  // namespace clearcut::read::stepnc
