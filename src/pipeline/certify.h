// The way from passes to a judged program that every plan takes: link, post, read back, verify, sign.
#pragma once

#include <vector>

#include "link/link.h"
#include "model/pass.h"
#include "pipeline/run.h"
#include "read/gcode/dialect.h"
#include "verify/verify.h"

namespace clearcut::pipeline {

/// Where rapids of a step cross: its retract plane, over all that stands.
double crossing_z(const Part& part, const Operation& operation);

/// How a workingstep of a prepared part is linked, by its place in the workplan. `entry` is how to go down where the operation
/// does not say.
link::LinkOptions link_options(const Part& part, int workingstep, EntryKind entry,
                               const resolve::PlanOptions& options);

/// Writes into `section` whose work it is and how its tool is driven.
void describe(Section& section, int workingstep, const Part& part);

/// The section of one workingstep, by its place in the workplan, through its passes layer by layer. The part
/// is prepared. `entry` is how to go down where the operation does not say.
Section link_step(const std::vector<LayerPasses>& passes, int workingstep, EntryKind entry, const Part& part,
                  const resolve::PlanOptions& options);

verify::VerifyOptions verify_options(const resolve::PlanOptions& options);

/// Judges what a control reads: its moves, what it holds meanwhile, and the conditions of both. Marks the conditions that
/// the machine file or options.accept answer.
Findings judge(const Part& part, const Toolpath& toolpath, const ControlTable& control,
               const std::vector<Condition>& conditions, read::gcode::Dialect dialect,
               const resolve::PlanOptions& options);

/// Posts `planned` for result.part, reads it back, and judges what was read.
void certify(PlanResult& result, const Toolpath& planned, const resolve::PlanOptions& options);

/// Puts the verdict into the program's header and makes sure that nothing else has changed.
void sign(PlanResult& result, const Toolpath& planned, const resolve::PlanOptions& options);

}  // namespace clearcut::pipeline
