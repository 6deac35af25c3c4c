// Cutters and how they are driven. Each kind of tool is one row, of which every question about kinds is answered.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/units.h"
#include "model/move.h"

namespace clearcut::inline model {

enum class ToolKind {
  kEndMill,
  kFaceMill,
  kBallEndMill,
  kBullNoseEndMill,
  kDrill,
  kReamer,
  kVBit,         ///< a cone down to a point or a small flat
  kChamferMill,  ///< a cone with a flat, non-cutting tip
  kSpotDrill,    ///< a cone used with vertical moves only
  kTap,          ///< cuts a thread of its own size; its feed is pitch times speed
  kThreadMill,   ///< cuts a thread along a helix; with a pitch in many rows of teeth, else in one
  kBoringBar,    ///< one cutting edge, boring to its own diameter
  kCounterbore,  ///< a flat end for vertical moves, enlarging a narrower hole
  kTapered,      ///< an end mill widening upwards from the diameter of its flat tip
  kTSlot,        ///< a disc on a narrower neck, for undercuts
  kOther
};
/// "endmill", "facemill", "ball", "bullnose", "drill", "reamer", "vbit", "chamfer", "spotdrill", "tap", "threadmill",
/// "boringbar", "counterbore", "tapered", "tslot", "other": as on the command line.
const char* name_of(ToolKind kind);
std::optional<ToolKind> tool_kind_named(const std::string& name);

/// A rotating tool. Lengths in mm.
struct Tool {
  int number = 1;    ///< T word
  std::string name;  ///< name from the source ("T3"), for messages and headers
  ToolKind kind = ToolKind::kEndMill;
  double diameter = 0;       ///< for tapered end mills, the diameter of the tip
  double corner_radius = 0;  ///< 0 flat
  int teeth = 2;
  /// Length of the flutes; for T-slot cutters the height of the disc.
  std::optional<double> flute_length;
  std::optional<double> max_spindle_rpm = {};  ///< allowed by its maker; > 0
  bool center_cutting = true;                  ///< may plunge straight down
  std::optional<Radians> tip_angle = {};       ///< cones, tapers, points of drills: between opposite flanks
  double tip_diameter = 0;                     ///< cones: diameter of the flat at the tip
  double pitch = 0;                     ///< taps; thread mills with many rows of teeth: between the rows
  bool left_hand = false;               ///< taps: hand of the thread
  bool floating = false;                ///< taps: held with play along their axis
  std::optional<double> stickout = {};  ///< from the tip up to the holder; absent: the holder is not known
  double holder_diameter = 0;           ///< diameter of the holder at its lower end; 0: not known
  /// Diameter above the flutes; 0: no wider than the cutter; for T-slot cutters the neck.
  double shank_diameter = 0;
  /// Material of the edges; absent: the usual one for the kind, docs/feeds.md.
  std::optional<bool> high_speed_steel = {};
  bool coated = false;  ///< the edges
  double radius() const { return diameter / 2; }
};

/// The first tool with the T word `number`; null if there is none.
const Tool* tool_numbered(const std::vector<Tool>& tools, int number);

/// Whether the cutter is a cone from its tip up to its diameter: V-bits, chamfer mills, spot drills with an angle.
bool is_conical(const Tool& tool);
/// Whether the tool widens evenly upwards from its tip: cones and tapered end mills.
bool has_flanks(const Tool& tool);
/// Slope of the flanks: mm of radius for each mm of height.
double flank_slope(const Tool& tool);
/// Height of the upper end of the flanks over the tip, mm.
double flank_height(const Tool& tool);
/// Of a tool with flanks: radius of the flat at its tip, mm.
double tip_radius(const Tool& tool);
/// mm; greatest radius of the cutting part.
double widest_radius(const Tool& tool);
/// Radius at `height` mm above the tip: a cutter running deeper by `height` clears this radius. mm.
double radius_at(const Tool& tool, double height);
/// Length (mm) of a drill's point below its full diameter; 118 degrees if its angle is not stated. 0 for other tools.
double point_length(const Tool& tool);
/// Whether the tool only moves along its axis and makes a hole of its own diameter: drills, reamers, counterbores,
/// boring bars.
bool makes_holes(const Tool& tool);
/// Whether the tool may move straight down in material.
bool may_plunge(const Tool& tool);
/// Whether the tool clears areas down to a flat floor: false for tools with vertical moves only, cones, and cutters
/// of undercuts.
bool clears_floors(const Tool& tool);
/// Whether the tool clears floors and leaves vertical walls: false for tapered end mills.
bool mills_upright(const Tool& tool);
/// Whether it makes its work at once, whatever stepdown is asked for: taps, thread mills, T-slot cutters.
bool works_at_once(const Tool& tool);
/// Whether it goes straight down alone and is driven as drills are: what makes holes, spot drills, taps.
bool is_driven_down(const Tool& tool);

/// Feeds and speeds of one operation. Absent values take the documented defaults (see defaults_for).
struct CuttingData {
  std::optional<MmPerMin> feed;
  std::optional<MmPerMin> plunge_feed;
  std::optional<MmPerMin> ramp_feed;
  std::optional<MmPerMin> slot_feed;
  std::optional<double> spindle_rpm;  ///< > 0; direction apart
  bool spindle_clockwise = true;      ///< M3
  std::optional<Coolant> coolant = {};
};

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
