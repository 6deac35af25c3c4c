// The tools of a program, and the toolpaths that an operation states.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "model/part.h"
#include "model/tool.h"
#include "read/stepnc/file/node.h"
#include "read/stepnc/shapes/placement.h"

namespace clearcut::read::stepnc {

/// What the workingsteps of a program do with a tool, which tells apart what one kind of body stands for.
struct StatedUse {
  bool mills = false;         ///< it runs along something, and not straight down alone
  double neck = 0;            ///< mm; width of the narrowest slot that it undercuts; 0: none
  bool breaks_edges = false;  ///< all that it works on are chamfers
};

/// hand_of_cut of a tool's body. Cutters of unstated hand turn clockwise, like right-handed ones.
enum class Hand { kUnstated, kRight, kLeft };

/// All tools of the file, in order of their entities, equal ones once.
class Tools {
 public:
  /// Tools that cannot be read are left out until find() asks for them.
  Tools(Context& context, const std::map<std::uint64_t, StatedUse>& uses);
  const std::vector<Tool>& list() const { return tools_; }
  /// Index of the tool of a MILLING_CUTTING_TOOL. Throws InputError for what is missing in it.
  int find(const Node& tool, Context& context) const;
  Hand hand_of(const Node& tool) const;

 private:
  int add(Tool tool, bool numbered, bool left_handed);
  void number_the_rest();
  std::vector<Tool> tools_;
  std::vector<bool> numbered_;
  std::vector<bool> left_handed_;
  std::map<std::uint64_t, int> by_entity_;
  std::map<std::uint64_t, StatedUse> uses_;
};

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
