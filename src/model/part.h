// What is to be made: stock, features, tools, and the order of work.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/tolerances.h"
#include "geometry/region.h"
#include "model/hole.h"
#include "model/stated_path.h"
#include "model/tab_options.h"
#include "model/tool.h"

namespace clearcut::inline model {

/// Raw block. z in workpiece coordinates, mm.
struct Stock {
  Box plan;
  double z_bottom = 0;
  double z_top = 0;
};

enum class FeatureKind {
  kClosedPocket,
  kOpenPocket,
  kPlanarFace,
  kSlot,
  kStep,
  kRoundHole,
  kOutsideProfile,
  kInsideProfile,
  kEngraving,
  kVCarving,        ///< as deep as a cone's width at the top allows
  kChamfer,         ///< the edge of a wall broken by a cone
  kIsolation,       ///< a band about pieces that stay and are to be parted from each other
  kExternalThread,  ///< about a boss
  kTSlot  ///< what the disc of a T-slot cutter removes along a line, under what stands; the slot above it is a feature of its own
};
const char* name_of(FeatureKind kind);

enum class ProfileSide { kOutside, kInside, kOn };

/// Material that stays in the kerf and holds the part.
struct Tab {
  TabShape shape = TabShape::kSquare;
  Vec2 center;  ///< middle of the kerf
  Edge foot;    ///< the stretch of the outline that it stands on at bottom_z
  double aside =
      0;  ///< mm to the left of `foot` as far as the kerf may reach; to the right of it where it is negative
  double top_z = 0;  ///< of triangular tabs that of the ridge
  double bottom_z = 0;
  Regions body;  ///< plan view of what must not be cut across the kerf: of square tabs below top_z
};

/// One contour to be followed by the cutter: a profile along an outline, or a line to engrave.
struct ProfileCut {
  ProfileSide side = ProfileSide::kOutside;
  Path line;  ///< profiles: a counter-clockwise loop; engraving: any connected line
  bool closed = true;
  double beyond = 0;      ///< mm; how far floor_z lies below the material
  std::vector<Tab> tabs;  ///< in the layers of this feature
};

/// Lettering and ornament whose depth is that of a cone that touches the outline on both sides.
struct VCarving {
  std::optional<double> limit;  ///< mm below the top: a flat floor where the cone would go deeper
  double start = 0;             ///< mm below the top: there the outline is as drawn, and above it wider
};

/// The edge of a wall that is to be broken. The wall runs down from `line`; how wide the chamfer is follows from the cone.
struct Chamfer {
  Loop line;
  double depth = 0;        ///< mm from the wall's top down to the chamfer's foot
  bool air_inside = true;  ///< the loop bounds what is milled; else what stays
  Regions free_beside;     ///< beside the wall: where nothing stands any more at the foot
  double free_floor = 0;   ///< z of what stands in the free space beside it
  double reach = 0;        ///< mm; radius of the round corners that mills left in the free space beside it
};

/// The undercut of a T-slot; its line begins where the disc can go down and come up.
struct TSlot {
  bool leaves_at_end = false;  ///< it can do so at the line's end, too; else it comes back the way it went
};

/// A prismatic volume to remove: every point of `target` down to `floor_z`.
///
/// `target` is the plan view of the material to remove at the top. `allowed` is where the cutter may be: everything
/// outside `allowed` is the part itself, above floor_z, and must not be touched. For a closed pocket both are the same.
/// For open sides `allowed` reaches far outside the stock (kOpenReach), so that only true walls bound it.
/// target is always inside allowed.
struct Feature {
  std::string name;    ///< unique within the part
  std::string source;  ///< where it was read: "#216", "layer POCKETS", ""
  FeatureKind kind = FeatureKind::kClosedPocket;
  Regions target;
  Regions allowed;
  double top_z = 0;  ///< where its material begins, after the features before it in the workplan
  double floor_z = 0;
  /// Walls lean inwards going down by this angle from vertical: at depth h below top_z the outline is inset
  /// by h * tan(wall_slope) (islands grow).
  Radians wall_slope;
  /// Round holes only.
  std::optional<double> hole_diameter;
  bool through = false;
  /// Profiles, engraving and T-slots: what the cutter's centre follows. Their target and allowed depend on the cutter: the kerf.
  std::optional<ProfileCut> profile = {};
  /// V-carving only; its wall_slope and floor_z are those of the cutter.
  std::optional<VCarving> carving = {};
  /// Chamfers only: their target is the strip that they take of the top, and only its side away from the line leans.
  std::optional<Chamfer> chamfer = {};
  /// T-slots, once their tool is known. Then top_z is that of the disc; what they remove reaches no higher.
  std::optional<TSlot> t_slot = {};
  /// Round holes of which more is asked than a cylinder down to floor_z.
  std::optional<HoleForm> hole = {};
  double floor_fillet = 0;  ///< mm; radius that stays between floor and walls, where one is asked for
};

/// How far beyond the stock an open side's `allowed` region reaches, mm.
inline constexpr double kOpenReach = 1000.0;

enum class OperationKind {
  kRoughing,
  kFinishing,
  kBottomFinishing,
  kSideFinishing,
  kDrilling,
  kReaming,
  kOther
};
enum class EntryKind { kHelix, kRamp, kZigzagRamp, kPlunge };
enum class CutDirection { kClimb, kConventional };

/// How a tool goes straight down a hole and comes up again, where it is not by one feed. Depths in mm from where the hole begins and
/// from its floor; shares are of the plunge feed.
struct HoleFeeds {
  double start_depth = 0;
  double start_share = 1;  ///< down to start_depth
  double end_depth = 0;
  double end_share = 1;                      ///< over the last end_depth
  std::optional<double> retract_share = {};  ///< absent: up at the rapid
  double dwell_s = 0;                        ///< at the floor
};

/// How a feature is to be cut. Absent values are decided by the planner's documented defaults.
struct Operation {
  std::string name;
  std::string source;
  OperationKind kind = OperationKind::kRoughing;
  int tool = 0;                 ///< index into Part::tools
  bool is_tool_chosen = false;  ///< among several, by its size and kind; nobody named it for this
  CuttingData cutting;
  std::optional<double> stepdown;  ///< mm per layer
  std::optional<double> stepover;  ///< fraction of the diameter
  double allowance_side = 0;       ///< stock to leave on walls, mm
  double allowance_floor = 0;      ///< stock to leave on the floor, mm
  std::optional<double> scallop;   ///< mm; greatest step between layers on sloped walls
  std::optional<EntryKind> entry;
  std::optional<Radians> entry_angle;
  std::optional<double> entry_size;  ///< mm; greatest radius of a helix, length of one way of a zigzag
  std::optional<CutDirection> direction;
  std::optional<double> retract_z;  ///< absolute, mm
  std::optional<double>
      lead;  ///< mm; radius of the arcs, length of the lines into and out of passes along walls
  std::optional<Radians> lead_angle;      ///< between such a line and the pass; absent: arcs
  bool rest = false;                      ///< cut only what the earlier steps of the same feature leave
  std::optional<Radians> feed_direction;  ///< of parallel strokes against x
  std::string strategy_hint;              ///< strategy named by the file, "" if none
  std::optional<HoleFeeds> hole_feeds = {};
};

/// What a program does between two workingsteps.
enum class StopKind {
  kHalt,      ///< M0
  kOptional,  ///< M1: halts where the operator has asked for it
  kMessage    ///< tells the operator something and goes on
};
struct ProgramStop {
  StopKind kind = StopKind::kHalt;
  std::string text;
};

/// One step of the work: this feature by that operation.
struct Workingstep {
  std::string name;
  std::string source;
  int feature = 0;  ///< index into Part::features
  Operation operation;
  std::vector<ProgramStop> stops = {};  ///< before it
  /// The way that the input states for its tool.
  std::optional<StatedPath> stated_path = {};
};

/// A hole that is there before the work begins: a way down for cutters that are no wider. mm.
struct PredrilledHole {
  Vec2 center;
  double diameter = 0;
};

/// Where nothing of the tool or its holder may come: a clamp, a vice, a screw. A block, mm.
struct KeepOut {
  Box plan;
  double bottom_z = 0;
  double top_z = 0;
};

/// A whole job description; a value.
struct Part {
  std::string name;
  std::string source_file;
  /// Whether anything says what is to be made. Where not, there are a stock and tools alone: what a program cuts away is neither
  /// asked for nor forbidden.
  bool is_shape_stated = true;
  bool is_solid = false;              ///< read from a solid, so that what is seen from its sides agrees
  std::optional<Stock> stock;         ///< absent: solid everywhere outside the features (outline files)
  std::optional<double> clearance_z;  ///< security plane, absolute; absent: stock top + 10
  std::vector<Tool> tools;
  std::vector<Feature> features;
  std::vector<Workingstep> workplan;       ///< in order of cutting
  bool order_free = false;                 ///< steps that do not meet may be cut in any order
  std::vector<PredrilledHole> predrilled;  ///< as deep as any feature they lie in
  std::vector<KeepOut> keep_outs = {};
  Diagnostics diagnostics;

  double top_z() const;   ///< stock top, or the highest feature top
  double safe_z() const;  ///< clearance_z or top + 10
};

/// What a step works with and on.
const Tool& tool_of(const Part& part, const Workingstep& step);
const Feature& feature_of(const Part& part, const Workingstep& step);

/// The stated path that the step is cut by; null where a strategy decides.
const StatedPath* path_of(const Workingstep& step);

/// Whether the cutter makes the feature by its own shape along lines in space, rather than clearing it layer by layer.
bool is_carved(const Feature& feature, const Tool& tool);

/// Whether the tool makes it along its axis or a helix of its own: spots, countersinks, taps, thread mills.
bool is_formed(const Feature& feature);

/// Whether walls bound the feature on all sides, so that the cutter can leave it upwards alone.
bool closed_all_round(const Feature& feature);

}  // namespace clearcut::inline model
