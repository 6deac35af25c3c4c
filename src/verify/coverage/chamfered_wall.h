// Whether a chamfer is cut wherever its wall is.
#pragma once

#include "verify/coverage/carving.h"

namespace clearcut::verify {

/// Checks the chamfer every 0.02 mm along its line, at places where the wall was cut by this program or an earlier
/// one or is a side of the stock. Cones must have been as deep as the chamfer's plane at its foot, in its middle and
/// near its top, to within tol.uncut square to the plane. In places not reached by any cutter, as in sharp corners,
/// there is no edge to chamfer.
///
/// Cost O(length of the line / 0.02 mm * moves near).
void check_chamfer(const Part& part, const CheckedProgram& program, const Tolerances& tol, CarvingWork& work);

}  // namespace clearcut::verify
