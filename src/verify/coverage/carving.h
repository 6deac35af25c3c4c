// Whether what a shaped cutter was to carve is carved: V-carvings to the depth of their outline, engravings to their line.
#pragma once

#include <functional>
#include <vector>

#include "verify/checked_move.h"
#include "verify/coverage/coverage.h"
#include "verify/verify.h"

namespace clearcut::verify {

/// What is left of one carved feature.
struct CarvingWork {
  int feature = 0;
  int last_workingstep = 0;
  bool any_cut = false;
  double left_mm =
      0;  ///< proven bound of the thickness of anything left, square to the flank; on floors its height over a cusp
  Vec2 worst;
  double worst_z = 0;
};

/// mm. Ridges between the passes of a pointed cutter that may stay on a floor.
inline constexpr double kHighestCusp = 0.05;

/// Features of which a step is carved, in order of the workplan.
std::vector<CarvingWork> carvings_of(const Part& part);

/// V-carving: from every 0.002 mm of the outline, and all round its outer corners, the largest circle that touches the outline there
/// and lies within it, no larger than the depth allows; in its middle the cutters have to be as deep as a cone in the circle, to
/// within tol.uncut. Every place of the carving lies on the line from such a middle to the outline, and both the ideal
/// carving and what cones leave rise at the flank's slope towards it. The floor, where the limit is reached, by
/// squares that are divided until each lies in what a cutter has cut, or stands no higher than a cusp.
/// Engraving: every 0.02 mm of the line.
///
/// Cost O(length of the outline / 0.002 mm * moves near).
void judge_carving(const Part& part, const JudgedProgram& program, const Tolerances& tol, CarvingWork& work);

/// Faults of what judge_carving found.
std::vector<Fault> faults_of_carving(const Feature& feature, const CarvingWork& work, const Tolerances& tol);

}  // namespace clearcut::verify
