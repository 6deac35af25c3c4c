// The way from passes to a checked program that every plan takes: link, post, read back, verify, sign.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "link/link.h"
#include "model/options/resolved_plan.h"
#include "model/pass.h"
#include "pipeline/run.h"
#include "read/gcode/dialect.h"
#include "verify/verify.h"

namespace clearcut::pipeline {

/// How a workingstep is linked, by its place in the workplan. `entry` is how to go down.
link::LinkOptions link_options(const ResolvedPlan& plan, int workingstep, EntryKind entry);

/// Writes into `section` whose work it is and how its tool is driven.
void describe(Section& section, int workingstep, const ResolvedPlan& plan);

/// The section of one workingstep, by its place in the workplan, through its passes layer by layer. `entry` is
/// how to go down.
Section link_step(const std::vector<LayerPasses>& passes, int workingstep, EntryKind entry,
                  const ResolvedPlan& plan);

/// The tools that somebody puts in, one at each pause, where the control has no words for them.
struct HandTools {
  std::vector<int> numbers;  ///< in their order
  std::string order;         ///< which that is: "of the part's work", "that its comments name"
};

inline constexpr const char* kOrderOfWork = "of the part's work";

/// The tools that comments of `program` say are put in, if they are all among `usual`; else `usual`. Without what needs no change.
HandTools hand_tools_of(std::string_view program, HandTools usual);
/// What has to hold where a program names none of its several tools.
Condition hand_tools_condition(const HandTools& tools);

/// How the program is written: what was asked for, and what the machine needs where nobody has asked for something else.
PostOptions post_options_of(const ResolvedPlan& plan);
/// Of the control that the program is for; absent where its words are no G code.
std::optional<MotionPlanner> planner_of_control(const ResolvedPlan& plan);

/// Keeps the address of plan.earlier.
verify::VerifyOptions verify_options(const ResolvedPlan& plan);

/// What somebody stated for tools, by number.
struct StatedOfTools {
  std::map<int, verify::ToolLimits> limits = {};   ///< of those that no workingstep is made with
  std::map<int, verify::StatedDrive> drives = {};  ///< of all
  std::map<int, MmPerMin> reference_feeds = {};    ///< meant at the reference where feeds follow the load
};

/// Checks what a control reads: its moves, what it holds meanwhile, and the conditions of both. Marks the conditions that
/// the machine file or plan.accept answer. `stated` binds programs of others.
Findings check(const Part& part, const Toolpath& toolpath, const ControlTable& control,
               const std::vector<Condition>& conditions, read::gcode::Dialect dialect,
               const ResolvedPlan& plan, StatedOfTools stated = {});

/// Posts `planned` for result.part, reads it back, and checks what was read.
void certify(PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan);

/// Puts the verdict into the program's header and makes sure that nothing else has changed.
void sign(PlanResult& result, const Toolpath& planned, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
