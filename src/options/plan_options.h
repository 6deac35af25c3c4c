// Options of a plan that a user can give, those on the part's input file among them. Absent values are taken from the
// file and the part's operations, else from the documented defaults of resolve().
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
#include "model/options/strategy_entry.h"
#include "model/options/tour_options.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "options/copies_options.h"

namespace clearcut::inline options {

/// Lengths in mm. Texts are as given by the user; the readers interpret them.
struct InputOptions {
  std::optional<std::string> origin;  ///< "corner", "centre" or "X,Y,Z"
  std::optional<int> setup;           ///< number of the set-up of a job, from 1
  std::vector<std::string> earlier_setups;
  std::optional<std::string> unit;
  std::vector<std::string> layers;
  std::vector<std::string> operations;  ///< "KIND:SELECTION"
  std::optional<double> top, depth;
  std::optional<std::string> stock_from;
  bool mirror = false;
  std::optional<double> scale, join_gap;
  std::optional<std::string> strokes, text, open_curves;
  std::optional<bool> find_arcs;
  std::optional<std::string> up, body;
  std::optional<double> turn_deg;
  std::optional<double> breakthrough;
  std::optional<double> clearance_z;
  std::vector<std::string> tools;  ///< "endmill:6"
  std::optional<std::string> tool_library;
  std::optional<std::string> machine_file, machine_kind;
  std::vector<std::string> predrilled, keep_outs;
  std::optional<std::string> after;
};

/// Cutting data of one tool from its library or job. Absent values are left to the operation.
struct ToolCutting {
  bool stated = false;  ///< anything at all
  CuttingData cutting;
  std::optional<double> stepdown;  ///< mm
  std::optional<double> stepover;  ///< fraction of the diameter
};

/// A part of another kind for the sheet that CopiesOptions::sheet fills, as it was read from one of CopiesOptions::with.
struct NestedPart {
  Part part;
  std::optional<int> count;               ///< absent: as many as fit
  std::vector<ToolCutting> tool_cutting;  ///< of its own tools, as PlanOptions::tool_cutting
  StepSources step_sources;
  StepChoices step_published;
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
  std::vector<NestedPart> nested;          ///< one for each of copies.with, read by the caller
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
