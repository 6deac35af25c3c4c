// Options of a plan that a user can give. Absent values are taken from the part's operations, else from the
// documented defaults of resolve().
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
#include "model/options/published_solver.h"
#include "model/options/shop_options.h"
#include "model/options/strategy_entry.h"
#include "model/part.h"
#include "model/results/earlier_state.h"
#include "model/tab_options.h"
#include "options/copies_options.h"

namespace clearcut::inline options {

/// Cutting data of one tool from its library or job. Absent values are left to the operation.
struct ToolCutting {
  bool stated = false;  ///< anything at all
  CuttingData cutting;
  std::optional<double> stepdown;  ///< mm
  std::optional<double> stepover;  ///< fraction of the diameter
};

struct PlanOptions {
  std::vector<Tool> tools;  ///< replace the part's own; empty keeps those
  /// Cutting data of `tools`, else of the part's own, in their order; tools beyond its end have none.
  std::vector<ToolCutting> tool_cutting;
  /// "auto" or a name of `strategies`, for every workingstep; absent: the strategies named by the part's operations,
  /// else "auto".
  std::optional<std::string> strategy;
  std::optional<std::string> stepover;  ///< "0.4" (fraction of the diameter), "lom", "rho", "3.5mm"
  std::optional<double> angle_deg;      ///< angle of zigzag lines against x; absent: the fastest found
  std::optional<double> stepdown;       ///< mm
  std::optional<double> allowance;      ///< mm; stock to leave on walls
  std::optional<double> allowance_floor;
  std::optional<double> engagement_deg;
  std::optional<EntryKind> entry;
  std::optional<Radians> entry_angle;
  std::optional<double> lead;         ///< mm; radius or length of leads into passes along walls, 0: none
  std::optional<Radians> lead_angle;  ///< straight leads, at this angle to the pass; absent: arcs
  std::optional<double> scallop;      ///< mm; greatest step between layers on drafted walls
  ShopOptions shop;
  TabOptions tabs;
  CopiesOptions copies;
  std::vector<PredrilledHole> predrilled;  ///< besides the part's own
  std::vector<KeepOut> keep_outs;          ///< besides the part's own
  std::optional<Toolpath> earlier;         ///< an earlier program already run on this stock
  EarlierState earlier_state;              ///< facts about `earlier` other than its moves
  std::vector<Condition> conditions;  ///< conditions known to the caller, in addition to those found here
  /// Absent: the input's toolpaths if its strategy requests them.
  std::optional<ToolpathSource> toolpaths;
  std::optional<CutDirection> direction;
  bool outside_in = false;    ///< contours from the wall inwards; false: inside-out
  std::optional<Vec2> start;  ///< point at which contours begin, or adaptive clearing descends
  CuttingData cutting;
  Machine machine;
  PostOptions post;
  /// Choices for every workingstep; takes precedence over those of `step_published`.
  PublishedChoices published;
  StepChoices step_published;  ///< choices of the job's operations
  std::string objective = "time";
  std::vector<std::string> accept;  ///< names of conditions that the user confirms
  std::optional<double> time_s;     ///< longest search
  std::uint64_t seed = 1;
  int threads = 0;            ///< 0: all cores
  std::stop_token cancel;     ///< asked to stop, the plan ends with Cancelled within a second
  ProgressCallback progress;  ///< called after each candidate and during the check of a program; may be empty
  Tolerances tol;
  /// Whether an option without a possible effect on the part is refused. False for options shared by many parts.
  bool refuse_idle = true;
  Sources sources;  ///< sources of values not given by options of the same names
  /// Sources of values in the part's operations that differ from the source of the operations.
  StepSources step_sources;
  /// Those there are, kept alive by the caller; null: the software's.
  const StrategyTable* strategies = nullptr;
};

}  // namespace clearcut::inline options
