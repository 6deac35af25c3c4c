// The part to be made: stock, features with their tabs, tools, and the order of work with the paths that the input
// states move by move.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/tolerances.h"
#include "geometry/region.h"
#include "geometry/vec2.h"
#include "model/hole.h"
#include "model/move.h"
#include "model/tool.h"

namespace clearcut::inline model {

/// Seen along the kerf: with upright sides, or rising evenly to a ridge in the middle.
enum class TabShape : unsigned char { kSquare, kTriangular };

/// Tabs holding the pieces that profiles cut free. Only one of `count`, `spacing` and `at` may be given.
struct TabOptions {
  int count = 0;                  ///< number of tabs of every profile; 0: none
  std::optional<double> spacing;  ///< mm along every profile from one tab to the next, at most
  std::vector<Vec2> at;           ///< mm; requested places of tabs, on or beside outlines
  TabShape shape = TabShape::kSquare;
  /// mm; width along the outline, for triangular tabs at the material's underside.
  double width = 4;
  std::optional<double> height;  ///< mm above the material's underside; absent: half the depth, 2 mm at most
  std::optional<double> skin;    ///< mm of material left below profiles instead of tabs

  bool any() const { return count > 0 || spacing || !at.empty(); }
};

/// Source of a workingstep's toolpath if the input states one.
enum class ToolpathSource { kFile, kOurs };

struct StatedMove {
  Edge path;  ///< in plan; z changes linearly. Vertical moves as those of Move
  double z_from = 0;
  double z_to = 0;
  MoveKind kind = MoveKind::kCut;
  std::optional<MmPerMin> feed = {};  ///< absent: the feed of the operation
  double dwell_s = 0;                 ///< dwell after the move
};

/// If a move does not begin at the end of the previous one, the cutter is retracted between them.
struct StatedPath {
  /// Empty: the path of an earlier workingstep makes this one, too.
  std::vector<StatedMove> moves;
  /// The input requests this path by its strategy: it is used unless the user decides otherwise.
  bool is_explicit = false;
  bool is_used = false;  ///< decided by resolve()
};

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
  kVCarving,        ///< carving as deep as a cone's width at the top allows
  kChamfer,         ///< the edge of a wall broken by a cone
  kIsolation,       ///< a band around pieces that remain, to separate them from each other
  kExternalThread,  ///< about a boss
  kTSlot  ///< the volume that the disc of a T-slot cutter removes along a line, below remaining material; the slot
          ///< above is a separate feature
};
const char* name_of(FeatureKind kind);

enum class ProfileSide { kOutside, kInside, kOn };

/// Material that stays in the kerf and holds the part.
struct Tab {
  TabShape shape = TabShape::kSquare;
  Vec2 center;       ///< middle of the kerf
  Edge foot;         ///< the stretch of the outline below the tab at bottom_z
  double aside = 0;  ///< mm to the left of `foot` over which the kerf may extend; negative: to the right
  double top_z = 0;  ///< height of the ridge of triangular tabs
  double bottom_z = 0;
  Regions body;  ///< plan view of the tab across the kerf, which must not be cut: for square tabs below top_z
};

/// One contour to be followed by the cutter: a profile along an outline, or a line to engrave.
struct ProfileCut {
  ProfileSide side = ProfileSide::kOutside;
  Path line;  ///< profiles: a counter-clockwise loop; engraving: any connected line
  bool closed = true;
  double beyond = 0;      ///< mm; distance of floor_z below the material
  std::vector<Tab> tabs;  ///< in the layers of this feature
};

/// Lettering and ornament, as deep as a cone that touches the outline on both sides.
struct VCarving {
  std::optional<double> limit;  ///< mm below the top: a flat floor in places where the cone would go deeper
  double start = 0;  ///< mm below the top: at this depth the outline is as drawn, and above it is wider
};

/// An edge of a wall to be broken by a chamfer. The wall extends down from `line`; the cone determines the chamfer's
/// width.
struct Chamfer {
  Loop line;
  double depth = 0;        ///< mm from the wall's top down to the chamfer's foot
  bool air_inside = true;  ///< the loop bounds the milled area; else the remaining material
  Regions free_beside;     ///< area beside the wall without material at the height of the wall's foot
  double free_floor = 0;   ///< z of the remaining material in the free space beside the wall
  double reach = 0;  ///< mm; radius of the round corners left by mills in the free space beside the wall
};

/// The undercut of a T-slot; its line begins at a place where the disc can descend and retract.
struct TSlot {
  /// The disc can retract at the line's end, too; else it returns along the line.
  bool leaves_at_end = false;
};

/// A prismatic volume to remove: every point of `target` down to `floor_z`.
///
/// `target` is the plan view of the material to remove at the top. `allowed` is the area permitted to the cutter:
/// everything outside `allowed` is the part itself, above floor_z, and must not be touched. For a closed pocket both
/// are the same. For open sides `allowed` reaches far outside the stock (kOpenReach), so that only true walls bound
/// it. target is always inside allowed.
struct Feature {
  std::string name;    ///< unique within the part
  std::string source;  ///< place in the input: "#216", "layer POCKETS", ""
  FeatureKind kind = FeatureKind::kClosedPocket;
  Regions target;
  Regions allowed;
  double top_z = 0;  ///< height of the top of its material, after the preceding features of the workplan
  double floor_z = 0;
  /// Walls lean inwards going down by this angle from vertical: at depth h below top_z the outline is inset
  /// by h * tan(wall_slope) (islands grow).
  Radians wall_slope;
  /// Round holes only.
  std::optional<double> hole_diameter;
  bool through = false;
  /// Profiles, engraving and T-slots: path of the cutter's centre. Their `target` and `allowed` are the kerf and
  /// depend on the cutter.
  std::optional<ProfileCut> profile = {};
  /// V-carving only; its wall_slope and floor_z are those of the cutter.
  std::optional<VCarving> carving = {};
  /// Chamfers only: their target is the strip removed from the top, and only the strip's side away from the line is
  /// inclined.
  std::optional<Chamfer> chamfer = {};
  /// T-slots, once their tool is known. Then top_z is the top of the disc; the removed volume reaches no higher.
  std::optional<TSlot> t_slot = {};
  /// Round holes requiring more than a cylinder down to floor_z.
  std::optional<HoleForm> hole = {};
  double floor_fillet = 0;  ///< mm; radius to be left between floor and walls, if requested
};

/// Extent of an open side's `allowed` region beyond the stock, mm.
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
/// Greatest number of turns of an entry's helix: more would grind on one spot for hours.
inline constexpr double kMostHelixTurns = 1000;
enum class CutDirection { kClimb, kConventional };

/// How a tool descends in a hole and retracts, if not with one feed. Depths in mm from the hole's top and from its
/// floor; shares of the plunge feed.
struct HoleFeeds {
  double start_depth = 0;
  double start_share = 1;  ///< down to start_depth
  double end_depth = 0;
  double end_share = 1;                      ///< over the last end_depth
  std::optional<double> retract_share = {};  ///< absent: up at the rapid
  double dwell_s = 0;                        ///< at the floor
};

/// Manner of cutting a feature. Absent values are decided by the planner's documented defaults.
struct Operation {
  std::string name;
  std::string source;
  OperationKind kind = OperationKind::kRoughing;
  int tool = 0;  ///< index into Part::tools
  /// The tool was chosen among several by size and kind, not named in the input.
  bool is_tool_chosen = false;
  CuttingData cutting;
  std::optional<double> stepdown;  ///< mm per layer
  std::optional<double> stepover;  ///< fraction of the diameter
  double allowance_side = 0;       ///< stock to leave on walls, mm
  double allowance_floor = 0;      ///< stock to leave on the floor, mm
  std::optional<double> scallop;   ///< mm; greatest step between layers on sloped walls
  std::optional<EntryKind> entry;
  std::optional<Radians> entry_angle;
  std::optional<double> entry_size;  ///< mm; greatest radius of a helix, length of one leg of a zigzag
  std::optional<CutDirection> direction;
  std::optional<double> retract_z;  ///< absolute, mm
  /// mm; radius of the arcs, length of the lines into and out of passes along walls.
  std::optional<double> lead;
  std::optional<Radians> lead_angle;      ///< angle between a straight lead and the pass; absent: arcs
  bool rest = false;                      ///< cut only the material left by earlier steps of the same feature
  std::optional<Radians> feed_direction;  ///< direction of parallel strokes against x
  std::string strategy_hint;              ///< strategy named by the file, "" if none
  std::optional<HoleFeeds> hole_feeds = {};
};

/// Kind of program stop between two workingsteps.
enum class StopKind {
  kHalt,      ///< M0
  kOptional,  ///< M1: halts if the operator has enabled optional stops
  kMessage    ///< shows a message to the operator and continues
};
struct ProgramStop {
  StopKind kind = StopKind::kHalt;
  std::string text;
};

/// One step of the work: one feature cut by one operation.
struct Workingstep {
  std::string name;
  std::string source;
  int feature = 0;  ///< index into Part::features
  Operation operation;
  std::vector<ProgramStop> stops = {};  ///< stops before this step
  /// The path that the input states for its tool.
  std::optional<StatedPath> stated_path = {};
};

/// A hole that exists before the work begins; cutters that are no wider can descend in it. mm.
struct PredrilledHole {
  Vec2 center;
  double diameter = 0;
};

/// A block (mm) that neither the tool nor its holder may enter: a clamp, a vice, a screw.
struct KeepOut {
  Box plan;
  double bottom_z = 0;
  double top_z = 0;
};

/// A whole job description; a value.
struct Part {
  std::string name;
  std::string source_file;
  /// Whether the input states the shape to be made. If not, there are only a stock and tools: the cuts of a program
  /// are neither requested nor forbidden.
  bool is_shape_stated = true;
  bool is_solid = false;              ///< read from a solid, so that the shapes of different set-ups agree
  std::optional<Stock> stock;         ///< absent: solid everywhere outside the features (outline files)
  std::optional<double> clearance_z;  ///< security plane, absolute; absent: see safe_z()
  std::vector<Tool> tools;
  std::vector<Feature> features;
  std::vector<Workingstep> workplan;       ///< in order of cutting
  bool order_free = false;                 ///< steps with disjoint features may be cut in any order
  std::vector<PredrilledHole> predrilled;  ///< predrilled holes, as deep as any feature around them
  std::vector<KeepOut> keep_outs = {};
  Regions left_out =
      {};  ///< plan view of the part's faces that no feature makes: the material over them stays
  Diagnostics diagnostics;
  /// Options that were found to have no effect on this part while it was prepared, with the reason.
  std::map<std::string, std::string> idle = {};
  /// The work's material as the input states it, a name of work_material_names(), where it is needed: some operation has no feed or no speed.
  std::optional<std::string> material = {};

  double top_z() const;   ///< stock top, or the highest feature top
  double safe_z() const;  ///< clearance_z; else 10 mm above the top and at least 2 mm above all keep-outs
};

/// Tool, feature and operation of a step.
const Tool& tool_of(const Part& part, const Workingstep& step);
const Feature& feature_of(const Part& part, const Workingstep& step);

/// The stated path of the step; null if a strategy plans its path.
const StatedPath* path_of(const Workingstep& step);

/// Whether the cutter's own shape, moved along lines in space, makes the feature, rather than passes layer by layer.
bool is_carved(const Feature& feature, const Tool& tool);

/// Whether the tool makes the feature by moves along its axis or on a prescribed helix: spots, countersinks, taps,
/// thread mills.
bool is_formed(const Feature& feature);

/// Whether walls bound the feature on all sides, so that the cutter can leave it only upwards.
bool closed_all_round(const Feature& feature);

}  // namespace clearcut::inline model
