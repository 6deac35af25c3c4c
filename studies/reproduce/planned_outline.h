// Outlines of the contour-parallel papers as parts, planned and certified by the product.
#pragma once

#include <optional>
#include <string>

#include "geometry/region.h"
#include "geometry/side_list.h"
#include "model/part.h"
#include "pipeline/run.h"

namespace clearcut::studies {

/// One pocket of 1 mm with one cutter of `diameter` mm that plunges.
Part pocket_part(const Region& outline, const std::string& name, double diameter);

/// How a pocket is planned.
struct OutlineMethod {
  std::string strategy;
  std::optional<std::string> stepover = {};  ///< as typed; the method's own where absent
  int decimals = 4;                          ///< of the program
  /// Reflex corners stay corners and passages run along bisectors, as the papers have it; absent: the method's own way.
  std::optional<bool> as_printed = {};
};

/// The program read back and its certificate; absent where the cutter does not fit.
std::optional<PlanResult> planned_outline(const Part& part, const OutlineMethod& method);

Region outline_of(const SideList& list);
Region equilateral(double edge);
/// A regular star with so many tips of `tip` degrees; its sides have `side` mm.
Region star(int tips, double side, double tip);
/// Radius of the greatest circle in the polygon of CPO-rho table 3, mm.
inline constexpr double kInscribed = 20.46;
/// Five corners, the sharpest of 30 degrees as the paper's (figure 10 prints its rho), with that circle.
Region inscribed_polygon(const Tolerances& tol);
/// Corners of a polygon, mm, times a factor.
Region scaled(const std::vector<Vec2>& corners, double factor);

}  // namespace clearcut::studies
