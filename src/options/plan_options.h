// What a user may ask of a plan. Absent values are taken from the part's operations, else from the documented
// defaults of resolve().
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

namespace clearcut::inline options {

/// How one tool is driven, as its library or job says. What is absent is left to the operation.
struct ToolCutting {
  bool stated = false;  ///< anything at all
  CuttingData cutting;
  std::optional<double> stepdown;  ///< mm
  std::optional<double> stepover;  ///< fraction of the diameter
};

struct PlanOptions {
  std::vector<Tool> tools;  ///< replace the part's own; empty keeps those
  /// Of `tools`, else of the part's own, in their order; those beyond its end state nothing.
  std::vector<ToolCutting> tool_cutting;
  /// "auto" or a name of `strategies`, for every workingstep; absent: what the part's operations name, else "auto".
  std::optional<std::string> strategy;
  std::optional<std::string> stepover;  ///< "0.4" (fraction of the diameter), "lom", "rho", "3.5mm"
  std::optional<double> angle_deg;      ///< of zigzag lines against x; absent: the fastest found
  std::optional<double> stepdown;       ///< mm
  std::optional<double> allowance;      ///< mm, on walls
  std::optional<double> allowance_floor;
  std::optional<double> engagement_deg;
  std::optional<EntryKind> entry;
  std::optional<Radians> entry_angle;
  std::optional<double> lead;         ///< mm; radius or length of leads into passes along walls, 0: none
  std::optional<Radians> lead_angle;  ///< straight leads, at this angle to the pass; absent: arcs
  std::optional<double> scallop;      ///< mm; greatest step between layers on drafted walls
  ShopOptions shop;
  TabOptions tabs;
  std::vector<PredrilledHole> predrilled;  ///< besides the part's own
  std::vector<KeepOut> keep_outs;          ///< besides the part's own
  std::optional<Toolpath> earlier;         ///< a program that has run before on this stock
  EarlierState earlier_state;              ///< what is known of `earlier` besides its moves
  std::vector<Condition> conditions;  ///< what the caller knows that must hold, besides what is found here
  /// Absent: the input's where it asks for them by its strategy.
  std::optional<ToolpathSource> toolpaths;
  std::optional<CutDirection> direction;
  bool outside_in = false;    ///< contours from the wall inwards; false: inside-out
  std::optional<Vec2> start;  ///< where the cutting of contours should begin, or adaptive clearing go down
  CuttingData cutting;
  Machine machine;
  PostOptions post;
  PublishedChoices published;  ///< of every workingstep; goes before those of `step_published`
  StepChoices step_published;  ///< of the job's operations
  std::string objective = "time";
  std::vector<std::string> accept;  ///< conditions that the user says hold at the machine
  std::optional<double> time_s;     ///< longest search
  std::uint64_t seed = 1;
  int threads = 0;            ///< 0: all cores
  std::stop_token cancel;     ///< asked to stop, the plan ends with Cancelled within a second
  ProgressCallback progress;  ///< told after each candidate and while a program is checked; may be empty
  Tolerances tol;
  /// Whether an option that can have no effect on the part is refused. False where the options are for many parts.
  bool refuse_idle = true;
  Sources sources;           ///< of values that are not given as options of their own names
  StepSources step_sources;  ///< of values in the part's operations that are not from where these were read
  const StrategyTable* strategies =
      nullptr;  ///< those there are, kept alive by the caller; null: the software's
};

}  // namespace clearcut::inline options
