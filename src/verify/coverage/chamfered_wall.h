// Whether a chamfer is cut wherever its wall is.
#pragma once

#include "verify/coverage/carving.h"

namespace clearcut::verify {

/// Every 0.02 mm along the line at which the program (or an earlier one) has cut the wall, or where the stock ends: over the foot, the
/// middle and near the top of the chamfer the cones have to be as deep as its plane, square to the plane within
/// tol.uncut. Corners that no cutter reached have no wall to be broken.
///
/// Cost O(length of the line / 0.02 mm * moves near).
void judge_chamfer(const Part& part, const JudgedProgram& program, const Tolerances& tol, CarvingWork& work);

}  // namespace clearcut::verify
