// Checks that V-carvings, engravings and chamfers are cut as deep as they have to be.
#pragma once

#include <functional>
#include <vector>

#include "verify/coverage/coverage.h"
#include "verify/program/checked_move.h"
#include "verify/program/verify_options.h"

namespace clearcut::verify {

/// What is left of one carved feature.
struct CarvingWork {
  int feature = 0;
  int last_workingstep = 0;
  bool any_cut = false;
  double left_mm =
      0;  ///< mm; bound of the thickness of what is left, square to the flank; on the floor of its height
  Vec2 worst;
  double worst_z = 0;
};

/// mm. Height of the ridges between the passes of a pointed cutter that may stay on a floor.
inline constexpr double kHighestCusp = 0.05;

/// The features that some workingstep carves, in the order of the workplan; nothing is checked yet.
std::vector<CarvingWork> carvings_of(const Part& part);

/// V-carving  Every 0.002 mm along the outline, and all round corners that point into the carving, the largest circle is
///            found that touches the outline there and lies within it. In its middle a cone must have been as deep as one that
///            fills the circle, to within tol.uncut. Towards the outline the ideal carving and what cones leave rise alike.
///            The floor is divided into squares until each lies in what was cut or stands no higher than kHighestCusp.
/// Engraving  The depth is checked every 0.02 mm along the line.
/// Chamfer    See chamfered_wall.h.
///
/// Cost O(length of the outline / 0.002 mm * moves near).
void check_carving(const Part& part, const CheckedProgram& program, const Tolerances& tol, CarvingWork& work);

/// The faults of a feature that check_carving has checked.
std::vector<Fault> faults_of_carving(const Feature& feature, const CarvingWork& work, const Tolerances& tol);

}  // namespace clearcut::verify
