// A job with everything decided: the input of the stages after resolve().
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/tolerances.h"
#include "model/control.h"
#include "model/machine.h"
#include "model/move.h"
#include "model/options/origin.h"
#include "model/options/post_options.h"
#include "model/options/shop_options.h"
#include "model/options/tour_options.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "model/results/margin.h"
#include "model/work_material.h"

namespace clearcut::inline model {

struct StrategyEntry;

/// Finishing after everything else.
enum class Finish { kNone, kWalls, kFloor, kAll };

/// Whether contours are cut from the middle to the walls or from the walls to the middle.
enum class ContourOrder { kInsideOut, kOutsideIn };

/// One step of the workplan. Lengths in mm.
struct ResolvedStep {
  const StrategyEntry* strategy = nullptr;  ///< null: the fastest of the strategies tried ("auto")
  Stepover stepover;
  /// Angle of parallel lines against x; absent: the fastest one is searched.
  std::optional<Radians> stroke_angle;
  MmPerMin feed, plunge_feed, ramp_feed;
  MmPerMin lead_feed;  ///< into and out of passes
  MmPerMin slot_feed;  ///< feed with the cutter fully in material; the operation's feed if none is requested
  double spindle_rpm = 0;
  bool spindle_clockwise = true;
  Coolant coolant = Coolant::kOff;
  CutDirection direction = CutDirection::kClimb;
  /// Requested by the user, a job or the work: "auto" tries no strategy that cuts in both directions.
  bool is_direction_asked = false;
  double stepdown = 0;
  double allowance_side = 0, allowance_floor = 0;
  EntryKind entry = EntryKind::kPlunge;
  EntryKind entry_at_limit = EntryKind::kHelix;  ///< entry of strategies that limit the engagement
  Radians entry_angle;
  bool is_plunge_asked = false;           ///< round holes are then not bored along a helix
  double zigzag_length = 0;               ///< length of one leg of a zigzag ramp; 0: up to two diameters
  std::optional<double> helix_widest;     ///< diameter of the centre's circle; absent: each entry's own limit
  std::optional<double> helix_narrowest;  ///< likewise
  double lead = 0;                        ///< radius of arcs, length of lines; 0: none
  std::optional<Radians> lead_angle;      ///< angle of lines against the pass; absent: arcs
  /// Engagement in degrees at which clearing aims; "auto" first tries the strategies that keep it. It is no limit: a
  /// greater engagement in places is no fault.
  std::optional<double> aimed_engagement_deg = {};
  double cross_z = 0;                     ///< height of rapids between passes; absolute
  std::optional<bool> bisector_passages;  ///< for contour methods; absent: the method decides
  std::optional<bool> sharp_reflex;  ///< corners of contours at reflex corners; absent: the method decides
  VisitSolver solver;                ///< solver of the strategy tour
  bool published_grid = false;       ///< for the strategy tour: Tour eq. 4.8, without additional passes

  /// Side of the wall, seen along closed passes.
  bool wall_on_right() const { return (direction == CutDirection::kClimb) == spindle_clockwise; }
};

/// One line of the table of decided values, for people and certificates.
struct ResolvedValue {
  int step = -1;  ///< place in the workplan; -1: a value of the whole plan
  std::string name;
  std::string value;
  std::string unit;
  Source source;
};

struct ResolvedPlan {
  Part part;                        ///< with the steps added by options; its operations agree with `steps`
  std::vector<ResolvedStep> steps;  ///< one for each step of part.workplan
  ContourOrder order = ContourOrder::kInsideOut;
  std::optional<Vec2> start;             ///< point at which cutting begins; absent: anywhere
  std::optional<double> engagement_deg;  ///< limit; absent: none
  Objective objective;
  /// Longest search; absent: a bound on the number of steps, the same on any machine.
  std::optional<double> search_s;
  std::uint64_t seed = 1;
  int threads = 1;
  double lead_overlap = 0, overrun = 0, link_lift = 0;  ///< mm
  double stock_oversize = 0;  ///< mm; greatest excess of the real stock over the stated one, at its sides and
                              ///< top
  std::optional<MmPerMin> link_feed;  ///< absent: the feed, or a rapid within a pass through cut material
  Radians slot_angle;                 ///< engagement above which the slot feed is used
  std::optional<MarginRule> margin;   ///< absent: not asked
  std::optional<FeedRule> feed_rule;  ///< absent: feeds are as stated
  Finish finish = Finish::kNone;
  std::optional<WorkMaterial> material;  ///< absent: no forces
  std::optional<Toolpath> earlier;       ///< an earlier program already run on this stock
  EarlierState earlier_state;            ///< facts about `earlier` other than its moves
  std::vector<Condition> conditions;     ///< conditions known to the caller
  Machine machine;
  std::vector<std::string> accept;  ///< names of conditions that the user confirms
  PostOptions post;
  Tolerances tol;
  std::stop_token cancel;             ///< asked to stop, the stages end with Cancelled
  ProgressCallback progress;          ///< receives the progress of the check of the program; may be empty
  std::vector<ResolvedValue> values;  ///< all of the above, in the order of the workplan, then of the whole
};

}  // namespace clearcut::inline model
