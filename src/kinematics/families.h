// The planners, one for each family of controllers.
#pragma once

#include <span>
#include <vector>

#include "kinematics/leg.h"

namespace clearcut::kinematics {

/// Adds the time of each leg to the time of its move.
using PlanFamily = void (*)(std::span<const Leg> legs, const Machine& machine, std::vector<Seconds>& times);

void plan_grbl(std::span<const Leg> legs, const Machine& machine, std::vector<Seconds>& times);
void plan_linuxcnc(std::span<const Leg> legs, const Machine& machine, std::vector<Seconds>& times);
void plan_marlin(std::span<const Leg> legs, const Machine& machine, std::vector<Seconds>& times);
void plan_mach(std::span<const Leg> legs, const Machine& machine, std::vector<Seconds>& times);
void plan_jerk_limited(std::span<const Leg> legs, const Machine& machine, std::vector<Seconds>& times);

}  // namespace clearcut::kinematics
