// The steps from passes to a checked program, common to all plans (link, post, read back, verify, sign), and their
// result.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "link/link.h"
#include "model/control.h"
#include "model/layer.h"
#include "model/move.h"
#include "model/options/resolved_plan.h"
#include "model/results/findings.h"
#include "model/runs/plan_result.h"
#include "read/gcode/program/dialect.h"
#include "read/gcode/program/program.h"
#include "report/result.h"
#include "verify/verify.h"

namespace clearcut::pipeline {

/// Link options of a workingstep, by its place in the workplan. `entry`: kind of descent.
link::LinkOptions link_options(const ResolvedPlan& plan, int workingstep, EntryKind entry);

/// Writes the workingstep and the cutting data into `section`.
void describe(Section& section, int workingstep, const ResolvedPlan& plan);

/// The section of one workingstep, by its place in the workplan, through its passes layer by layer. `entry` is
/// how to go down.
Section link_step(const std::vector<LayerPasses>& passes, int workingstep, EntryKind entry,
                  const ResolvedPlan& plan);

/// The tools loaded by the operator, one at each pause, if the control has no words for them.
struct HandTools {
  std::vector<int> numbers;  ///< in their order
  std::string order;         ///< description of the order: "of the part's work", "that its comments name"
};

inline constexpr const char* kOrderOfWork = "of the part's work";

/// The tools named in comments of `program` as loaded, if they are all among `usual`; else `usual`. Without
/// immediate repetitions and numbers below 1.
HandTools hand_tools_of(std::string_view program, HandTools usual);
/// The condition for a program that names none of its several tools.
Condition hand_tools_condition(const HandTools& tools);

/// Options for writing the program: requested ones, and the machine's needs if not requested otherwise.
PostOptions post_options_of(const ResolvedPlan& plan);
/// Of the control that the program is for; absent where its words are no G code.
std::optional<MotionPlanner> planner_of_control(const ResolvedPlan& plan);

/// Keeps the address of plan.earlier.
verify::VerifyOptions verify_options(const ResolvedPlan& plan);

/// What feeds that follow the load are held against: the plan's rule, which it must have, and the feed of each step.
verify::LoadReference load_reference_of(const ResolvedPlan& plan);

/// Values stated for tools, by number.
struct StatedOfTools {
  std::map<int, verify::ToolLimits> limits = {};   ///< limits of tools without a workingstep
  std::map<int, verify::StatedDrive> drives = {};  ///< cutting data of all tools
  std::map<int, MmPerMin> reference_feeds = {};    ///< feeds at the reference if feeds follow the load
};

/// Checks a program as read by a control: its moves, the control's states meanwhile, and the conditions of both.
/// Marks the conditions met by the machine file or plan.accept. `stated` limits programs of other origin.
Findings check(const Part& part, const Toolpath& toolpath, const ControlTable& control,
               const std::vector<Condition>& conditions, Dialect dialect, const ResolvedPlan& plan,
               StatedOfTools stated = {});

/// The program for `planned` without a verdict in its header.
std::string unchecked_program(const Toolpath& planned, const Part& part, const ResolvedPlan& plan);

/// As the control that the program is posted for reads it; tools are put in by hand in the order of work where it has no words for
/// them. `wear`: mm in every D word, where the control compensates.
Program read_back(const std::string& program, const Toolpath& planned, const ResolvedPlan& plan,
                  double wear = 0);

/// Posts `planned` for result.part, reads the program back, and checks the result.
void certify(PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan);

/// Puts the verdict into the program's header and verifies that nothing else has changed.
void sign(PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
