// Contour-parallel passes: rings at growing distance from the wall, and the additional passes needed to leave nothing
// uncut; and the entries of the contour-parallel methods in the table of strategies.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "base/units.h"
#include "model/layer.h"
#include "model/machine.h"
#include "model/options/strategy_entry.h"

namespace clearcut::plan::contour {

/// Rule for the distance of successive contours.
struct StepRule {
  enum class Kind {
    kWidest,          ///< "widest": as wide as the cutter allows; local passes clear the residuals
    kKappa,           ///< "lom": the widest step without residual at the smallest angle (CPO-kappa eq. 6)
    kRho,             ///< "rho": the same with an overlap of `value` * sin(alpha/2) mm (CPO-rho eq. 8)
    kSecondAngle,     ///< "second": rho of the second smallest angle if only one is smallest (CPO-rho 3.2)
    kKappaCorrected,  ///< "lom-corrected": the widest step without any residual (plan/contour/ring_band.h)
    kRhoCorrected,    ///< "rho-corrected": the same with rho's overlap
    kFraction,        ///< `value` * diameter
    kMm,              ///< `value` mm
    kPerContour       ///< one of `contours` for each contour, from the wall inwards; the last for all others
  };
  Kind kind = Kind::kWidest;
  double value = 1.0;
  std::vector<StepRule> contours = {};
};

/// Reads "widest", "lom" or "kappa", "rho", "second", "lom-corrected", "rho-corrected", the rho rules and
/// "second" with their overlap w in mm ("rho:0.5", default 1), "0.4" (fraction of the diameter), "3.5mm", or
/// several of these with commas, one for each contour. Throws InputError.
StepRule parse_step_rule(const std::string& text);

/// Rule for clearing material left by wide steps in corners and centres.
enum class ResidualRule {
  kOurs,   ///< a path along the medial axis, only if a residual is left
  kNone,   ///< not at all: the plain method, for comparison
  kLoops,  ///< a loop at every corner of every contour with a residual (Zhao); ridges as in kOurs
  /// The same with the kite of pair-wise interference detection (Park et al.); plan/contour/published_rings.h.
  kPwid,
  kSingleLoops,  ///< the same with one tangent loop (Choy and Chan)
  kDoubleLoops,  ///< the same with two
  kBisectors,    ///< a pass along the whole bisector of every corner with a residual (Lin)
  kPassages  ///< passages from each contour to the next along the bisector of a single smallest angle (CPO-rho 3.2)
};

/// Passage of the cutter from a contour to the next.
enum class Passage {
  kShortest,  ///< in the order found by linking
  kBisector   ///< along a corner's bisector (CPO-kappa eq. 3); plan/contour/published_rings.h
};

struct ContourOptions {
  StepRule step;
  ResidualRule residuals = ResidualRule::kOurs;
  Passage passage = Passage::kShortest;
  /// Reflex corners of contours stay corners (CPO-kappa eq. 2) if the outline has no arcs; false: they are rounded.
  /// Where a rule that clears everything cannot do so with corners, they are rounded, too.
  bool sharp_reflex = false;
  /// Effort of the search for shorter paths at the widest step. 0: not at all, under a millisecond; 1: some
  /// tenths of a second for an ordinary pocket.
  double effort = 1;
  /// On layers with open sides the rings are at growing distance from the walls alone, and end at the open sides; no passes if there are
  /// no walls.
  bool from_walls = false;
  /// Then all of them keep the direction of rings; else those that do not follow a wall may be cut to and fro.
  bool keeps_direction = false;
  /// Rings run with the wall on the right (climb milling for a clockwise spindle); false: on the left.
  bool wall_on_right = true;
  /// Rings at the wall come first, then the rings inside them; false: the reverse order.
  bool outside_in = false;
  /// Start of cutting, if the first pass can be reached from this point on a straight path; else cutting begins as
  /// near as possible.
  std::optional<Vec2> start;
  /// The machine and the feed for comparing the times of several plans.
  Machine machine;
  MmPerMin feed = MmPerMin::of(1000);
  /// Asked between the candidates of the search; plan_contour throws Cancelled if a stop was requested.
  std::stop_token cancel;
};

/// Plans the passes of one layer.
///
/// Shape   Closed rings oriented as their regions (the wall on the right), each with the ring around it as
///         parent; open passes on lines on which the cutter just fits and in places where rings leave material. The
///         first ring is at tool_radius + wall_stock. Empty if the cutter fits nowhere; the caller reports it.
/// Error   With ResidualRule::kOurs nothing reachable of `target` is left thicker than tol.uncut, for any step.
/// Cost    O(n log n + length of the result / radius).
/// Source  CPO-kappa, CPO-rho (papers, see docs/texts.md); for residuals docs/contour.md.
LayerPasses plan_contour(const Layer& layer, const ContourOptions& options, const Tolerances& tol);

// The papers' formulas (docs/texts.md). Angles are interior angles in radians, lengths mm.

/// CPO-kappa eq. 6: step / diameter without residual or overlap in a corner of angle alpha.
double kappa(double alpha);
/// CPO-rho eq. 8, printed with w = 1 mm: step / diameter with an overlap of w sin(alpha / 2) in the corner.
double rho(double alpha, double radius, double w = 1.0);
/// CPO-kappa eq. 4: mm; size of the residual in a corner, with overlap = 1 - step / diameter; <= 0 if there is none.
double residual_size(double alpha, double radius, double overlap);
/// mm; the passage from one contour to the next along the bisector: M = H / sin(alpha / 2).
double passage_length(double step, double alpha);
/// Smallest interior angle between successive edges; pi if all are smooth or reflex.
double smallest_angle(const Region& contour);
/// Greatest interior angle between successive edges, radians: above pi at a reflex corner.
double greatest_angle(const Region& contour);
/// The smallest interior angle apart from a single smallest one (CPO-rho 3.2).
double second_smallest_angle(const Region& contour);
/// The corner with the smallest angle; nothing if several corners have this angle.
std::optional<Vec2> single_smallest_corner(const Region& contour);

/// Clearcut's own method, then the corrected and the published ones.
std::vector<StrategyEntry> entries();

/// The step rule of a method with contours only; nothing for other methods.
std::optional<StepRule> published_rule(const std::string& method);

/// The step rule of a published contour method; none for other strategies.
std::optional<StepRule> contour_rule(const std::string& name, const Stepover& stepover);

}  // namespace clearcut::plan::contour
