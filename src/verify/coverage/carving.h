// Checks that V-carvings, engravings and chamfers are cut to their required depth, chamfers wherever their wall is.
#pragma once

#include <functional>
#include <vector>

#include "verify/coverage/coverage.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// Material left in one carved feature.
struct CarvingWork {
  int feature = 0;
  int last_workingstep = 0;
  bool any_cut = false;
  /// mm; bound of the thickness of the material left, square to the flank; on the floor, of its height.
  double left_mm = 0;
  Vec2 worst;
  double worst_z = 0;
};

/// mm. Permitted height of the ridges on a floor between the passes of a pointed cutter.
inline constexpr double kHighestCusp = 0.05;

/// The features carved by some workingstep, in the order of the workplan; not checked yet.
std::vector<CarvingWork> carvings_of(const Part& part);

/// V-carving  Every 0.002 mm along the outline, and all round corners pointing into the carving, the largest circle
///            inside the outline that touches the outline there is found. At its middle a cone must have been as deep
///            as a cone filling the circle, to within tol.uncut. Towards the outline the ideal carving and the
///            surface left by cones rise alike. The floor is divided into squares until each is wholly cut or no
///            higher than kHighestCusp.
/// Engraving  The depth is checked every 0.02 mm along the line.
/// Chamfer    See carving.h.
///
/// Cost O(length of the outline / 0.002 mm * moves near).
void check_carving(const Part& part, const CheckedProgram& program, const Tolerances& tol, CarvingWork& work);

/// The faults of a feature after check_carving.
std::vector<Fault> faults_of_carving(const Feature& feature, const CarvingWork& work, const Tolerances& tol);

/// Checks the chamfer every 0.02 mm along its line, at places where the wall was cut by this program or an earlier
/// one or is a side of the stock. Cones must have been as deep as the chamfer's plane at its foot, in its middle and
/// near its top, to within tol.uncut square to the plane. In places not reached by any cutter, as in sharp corners,
/// there is no edge to chamfer.
///
/// Cost O(length of the line / 0.02 mm * moves near).
void check_chamfer(const Part& part, const CheckedProgram& program, const Tolerances& tol, CarvingWork& work);

}  // namespace clearcut::verify
