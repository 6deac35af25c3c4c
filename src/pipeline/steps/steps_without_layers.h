// Workingsteps that are not cleared layer by layer: V-carving and engraving, holes, holes whose tool makes its own
// shape, stated paths of the cutter, undercuts of T-slots. Each function gives the section of such a step, and
// nothing for any other.
#pragma once

#include <optional>
#include <vector>

#include "model/layer.h"
#include "model/move.h"
#include "model/options/resolved_plan.h"

namespace clearcut::pipeline {

/// The section of a carved workingstep; nothing if it is cleared layer by layer. `reserve_share`: of the distance from walls
/// that is kept because the rounding of a control's digits displaces the tip.
std::optional<Section> carve_step(int workingstep, double reserve_share, const ResolvedPlan& plan);

/// The section of a workingstep on a formed hole; nothing for any other.
std::optional<Section> formed_hole_step(int workingstep, const ResolvedPlan& plan);

/// The section of a workingstep made as a hole; nothing if it is to be cleared layer by layer.
///
/// Drilled  with drills and reamers always (a section without moves if they cannot make or pierce the hole), with
///          centre-cutting mills of the hole's own size.
/// Bored    features declared as round holes, with a mill that leaves no post, unless another strategy or a plunge is
/// requested. `layers` are those of the step.
std::optional<Section> hole_step(const std::vector<Layer>& layers, int workingstep, const ResolvedPlan& plan);

/// The section of a workingstep with a stated path; nothing for any other. The moves are as stated. If a move does
/// not begin at the end of the previous one, and before the first and after the last, the cutter moves above all
/// remaining material: down again by a rapid to the height of crossing rapids and from there at the plunge feed. The
/// section has no moves if the path of an earlier workingstep also makes this one.
std::optional<Section> stated_step(int workingstep, const ResolvedPlan& plan);

/// The disc descends at the beginning of its line, moves along the line at one height, and retracts at a free end: at
/// the end, or back at the beginning. Nothing for steps on other features.
std::optional<Section> t_slot_step(int workingstep, const ResolvedPlan& plan);

}  // namespace clearcut::pipeline
