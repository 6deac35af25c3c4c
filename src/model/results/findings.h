// Results of verification: figures, faults and conditions, with places; features that are not machined at all; the
// state after earlier programs. Data, not exceptions.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "geometry/vec2.h"
#include "model/control.h"

namespace clearcut::inline model {

/// One kind of condition. `#` in a name represents the number of an offset, a word or a length: "g#-p#" is g54.1-p2.
struct ConditionRow {
  std::string_view name = {};
  std::string_view example = {};  ///< an example of a full name, if it differs from `name`
};

/// In the order of docs/conditions.md, which explains each condition.
std::span<const ConditionRow> condition_rows();

/// Whether there is a condition of this name.
bool is_condition(const std::string& name);

/// A place in the work and in the program.
struct Place {
  Vec2 point;
  double z = 0;
  int line = 0;  ///< line of the program text; 0 if unknown
};

/// Kinds of faults of a program. The properties of each kind are in its row, see row_of().
enum class FaultKind {
  kUncut,
  kGouge,
  kRapidInMaterial,
  kPlungeTooFast,
  kTooDeep,
  kOutsideTravel,
  kNoFeed,
  kNothingCut,
  kWrongTool,
  kToolLength,
  kSpindleOff,
  kSpindleDirection,
  kSpindleSpeed,
  kBeyondFlutes,
  kBeyondStock,
  kOverEngagement,
  kMissingTab,
  kTabHeight,
  kThread,
  kHolder,
  kKeepOut,
  kLoosePart,
  kFeedTooFast,
  kTapping,
  kStockToLeave,
  kMoreThanItCuts,
  kAboveReference,
  kUnits
};

/// All properties of a kind of fault.
struct FaultRow {
  FaultKind kind = FaultKind::kUncut;
  const char* name = "";     ///< short and stable, in certificates and reports
  int rank = 0;              ///< the gravest is listed first: 1
  const char* meaning = "";  ///< description for documents
  bool has_length = true;    ///< Fault::size is in mm
  bool by_strategy = true;   ///< another strategy may avoid this fault
  /// Concerns only the control and the tool: one mistake causes the fault in all features.
  bool of_state = false;
  bool of_missing_cuts = false;  ///< means that some material was not cut
};
const FaultRow& row_of(FaultKind kind);
/// In the order of FaultKind.
const std::vector<FaultRow>& fault_rows();
inline const char* name_of(FaultKind kind) {
  return row_of(kind).name;
}

struct Fault {
  FaultKind kind = FaultKind::kUncut;
  std::string feature;  ///< name, "" if none
  Place at;
  double size = 0;   ///< mm; thickness, depth or length, depending on the kind
  std::string text;  ///< one sentence for the user
  /// The kind of the fault that causes this one; this fault is then counted there and not reported by itself. "" if
  /// there is no such cause. During the search for faults: the description without the place, since faults with equal
  /// descriptions have one common mistake as their cause.
  std::string cause{};
};

/// Degrees by which the engagement may exceed its limit without a fault: arcs fitted to a path of constant engagement
/// oscillate about it by more than one degree, and the distance of the samples may hide half a degree.
inline constexpr double kFreeEngagementDeg = 2;

/// Angle of the cutter's circle in material, over all feed moves at depth after the entry.
struct Engagement {
  double max_deg = 0;
  std::optional<Place> max_at;
  double mean_deg = 0;                    ///< over cutting length
  double over_limit_mm = 0;               ///< length above the requested limit (0 without a limit)
  std::array<double, 18> histogram_mm{};  ///< cutting length by 10 degree classes
  double climb_mm = 0;  ///< cutting length with the material on the right (clockwise spindle)
  double conventional_mm = 0;
};

/// Descents into material, each up to its end: the limit of engagement does not apply to them.
struct Entries {
  int count = 0;
  double length_mm = 0;         ///< length of feed in material
  double max_deg = 0;           ///< greatest angle of the cutter's circle in material
  double max_axial_mm = 0;      ///< greatest depth of material above the tip
  std::optional<Place> max_at;  ///< place of max_deg
};

/// Forces computed from the engagement by a force model; only if the material of the work is known.
struct CuttingLoad {
  double max_force_n = 0;  ///< greatest mean tangential force over a turn of the cutter
  std::optional<Place> max_force_at;
  double mean_force_n = 0;  ///< over cutting length
  double max_power_w = 0;   ///< at the cutter
  double energy_j = 0;
  double removed_mm3 = 0;
  double wear = 0;  ///< contact time / tool life (Taylor): 1 uses one cutter up
};

/// The wall of the finished part that bends most under the greatest force beside it.
struct ThinWall {
  double thickness_mm = 0;
  double height_mm = 0;
  double deflection_mm = 0;
  Place at;
};

/// The greatest load of any feed move relative to the load at the reference of the feed rule.
struct ReferenceLoad {
  double share = 0;  ///< 1: as much as at the reference, or as fast as the cap
  Place at;
};

struct Figures {
  double feed_mm = 0;
  double rapid_mm = 0;
  double plunge_mm = 0;
  int turns = 0;  ///< changes of direction above 0.1 degree between successive feed moves in plan
  double turn_angle_deg = 0;
  int retracts = 0;               ///< rises to or above the stock's top between feed moves
  double time_s = 0;              ///< kinematic: acceleration, cornering; with all waits
  double waits_s = 0;             ///< part of the time: dwells, spindle starts, tool changes
  double time_naive_s = 0;        ///< length / feed
  double uncut_mm2 = 0;           ///< area of reachable material left (upper bound)
  double uncut_thickness_mm = 0;  ///< proven upper bound of the width of anything left
  /// The control may round corners by this distance; included in the bounds of uncut and gouge.
  double path_tolerance_mm = 0;
  std::optional<Place> uncut_at;
  double gouge_mm = 0;  ///< depth of the deepest cut into the part
  std::optional<Place> gouge_at;
  double unreachable_mm2 = 0;  ///< corners no legal position of the cutter reaches
  int rapid_in_material = 0;   ///< number of rapids through stock
  double max_axial_mm = 0;     ///< greatest depth of material above the tip at a feed move
  Engagement engagement;
  Entries entries;
  double air_cut_mm = 0;  ///< length at feed and at depth without touching material
  std::optional<CuttingLoad> load;
  std::optional<ReferenceLoad> reference_load;  ///< if feeds follow the load
  std::optional<ThinWall> thin_wall;            ///< only if the wall bends by more than 0.02 mm
  double lower_bound_mm = 0;                    ///< no program can cut this with less feed length
  bool clean = false;
};

struct LayerFindings {
  double z = 0;
  Figures figures;
};

/// Steps left by layers on drafted walls, mm square to the wall.
struct Scallop {
  double height_mm = 0;            ///< the highest step; for a flat end, rounded corners leave less
  std::optional<double> asked_mm;  ///< greatest permitted scallop
  double z = 0;                    ///< height of the layer below
};

struct FeatureFindings {
  std::string name;
  int workingstep = -1;
  int tool_number = 0;
  double tool_diameter = 0;
  Figures figures;
  std::vector<LayerFindings> layers;    ///< descending z
  std::optional<Scallop> scallop = {};  ///< scallops of drafted walls
};

/// D words of compensated paths from -range to range were looked at.
struct WearFindings {
  double range_mm = 0;
  std::vector<int> tools;  ///< T words whose paths are compensated, ascending
};

struct Findings {
  /// The shape to be made was not stated: uncut and gouge were not examined, and their figures are NaN.
  bool without_part = false;
  Figures all;
  std::vector<FeatureFindings> features;  ///< in workplan order
  std::vector<Fault> faults;              ///< worst first
  std::vector<Condition> conditions;      ///< what must hold at the machine, met and open
  std::optional<WearFindings> wear = {};  ///< where the control compensates for wear
  /// Degrees, of each move of the program in its order: the largest angle of the cutter in material. Empty: not measured.
  std::vector<float> move_engagement_deg;
  /// N, likewise: the largest mean tangential force. Empty: the material of the work is not known.
  std::vector<float> move_force_n = {};
};

/// Whether the reachable rest of an area, mm2, is no more than the error of areas.
bool is_nothing_in_reach(double unreachable_mm2, double whole_mm2);

/// CLEAN: no fault, and nothing is open. CONDITIONAL: no fault as long as the open conditions hold. FAULTY: a fault.
enum class Verdict : unsigned char { kClean, kConditional, kFaulty };
/// "CLEAN", "CONDITIONAL", "FAULTY".
const char* name_of(Verdict verdict);
Verdict verdict_of(const Findings& findings);
/// Name of the verdict; without a part also its restriction: "CLEAN AS FAR AS CAN BE SAID WITHOUT A PART".
std::string verdict_words(const Findings& findings);

/// Conditions that nobody has confirmed.
std::vector<Condition> open_conditions(const Findings& findings);
/// Marks conditions as met; `names` are those accepted by name. Returns the names without a condition.
std::vector<std::string> accept_conditions(Findings& findings, const std::vector<std::string>& names);

/// The verdict, then each fault and each open condition on a line of its own; of many of one kind the first and their
/// number.
std::string verdict_and_reasons(const Findings& findings);

/// The conditions and faults of earlier programs. A verdict relying on their cuts is valid only if these conditions
/// were met, and is FAULTY if there are such faults.
struct EarlierState {
  /// State of the control at each of their moves; without spans: it was checked elsewhere.
  ControlTable control;
  /// Facts that must have been true at the machine; the text names the program.
  std::vector<Condition> conditions;
  std::vector<Fault> faults;  ///< faults found elsewhere in these programs; the text names the program
};

/// Reports that `name` (of a feature or workingstep ordered by the input) is not machined, and the reason.
void say_not_machined(Diagnostics& diagnostics, const std::string& where, const std::string& name,
                      const std::string& why);

/// The names of features not machined, in the order of the reports.
std::vector<std::string> names_not_machined(const Diagnostics& diagnostics);

/// A fault for each of them, before all others; then nothing is clean.
void add_not_machined(const Diagnostics& diagnostics, Findings& findings);

/// Faults without a cause among the others, the worst first; faults caused by one of them are counted in its
/// sentence.
std::vector<Fault> told_faults(const Findings& findings);

}  // namespace clearcut::inline model
