// Contour-parallel passes: rings at growing distance from the wall, and whatever else it takes to leave
// nothing.
#pragma once

#include <optional>
#include <stop_token>
#include <string>

#include "base/tolerances.h"
#include "base/units.h"
#include "model/layer.h"
#include "model/machine.h"
#include "model/pass.h"

namespace clearcut::plan::contour {

/// How far apart successive contours lie.
struct StepRule {
  enum class Kind {
    kWidest,       ///< as wide as the cutter allows; what it leaves is cut by local passes ("ours")
    kKappa,        ///< "lom": the widest that leaves nothing in the smallest angle (CPO-kappa eq. 6)
    kRho,          ///< "rho": the same with an overlap of `value` * sin(alpha/2) mm (CPO-rho eq. 8)
    kSecondAngle,  ///< "second": rho of the second smallest angle when the smallest is single (CPO-rho 3.2)
    kKappaCorrected,  ///< "lom-corrected": the widest that leaves nothing anywhere (plan/contour/ring_band.h)
    kRhoCorrected,    ///< "rho-corrected": the same with rho's overlap
    kFraction,        ///< `value` * diameter
    kMm,              ///< `value` mm
    kPerContour       ///< `contours`, from the wall inwards; the last serves all after it
  };
  Kind kind = Kind::kWidest;
  double value = 1.0;
  std::vector<StepRule> contours = {};
};

/// "widest", "lom" or "kappa", "rho", "second", "lom-corrected", "rho-corrected", the last three and rho with
/// their w in mm ("rho:0.5", default 1), "0.4" (fraction of the diameter), "3.5mm", or several of them with commas,
/// one a contour. Throws InputError.
StepRule parse_step_rule(const std::string& text);

/// How material that wide steps leave in corners and centres is removed.
enum class ResidualRule {
  kOurs,   ///< the cheapest local pass along the medial axis, only where something is left
  kNone,   ///< not at all: the plain method, for comparison
  kLoops,  ///< a loop at every corner of every contour that leaves something (Zhao); ridges as ours
  kPwid,  ///< the same with the kite of pair-wise interference detection (Park et al.); plan/contour/corner_loop.h
  kSingleLoops,  ///< the same with one tangent loop (Choy and Chan)
  kDoubleLoops,  ///< the same with two
  kBisectors,    ///< along the whole bisector of every such corner (Lin)
  kPassages  ///< passages from each contour to the next along the bisector of a single smallest angle (CPO-rho 3.2)
};

/// How the cutter gets from a contour to the next.
enum class Passage {
  kShortest,  ///< as linking finds it
  kBisector   ///< along a corner's bisector (CPO-kappa eq. 3); plan/contour/passages.h
};

struct ContourOptions {
  StepRule step;
  ResidualRule residuals = ResidualRule::kOurs;
  Passage passage = Passage::kShortest;
  /// How long to look for shorter paths at the widest step: 0 not at all (under a millisecond), 1 some tenths
  /// of a second for an ordinary pocket.
  double effort = 1;
  /// Rings run with the wall on the right (climb milling for a clockwise spindle); false: on the left.
  bool wall_on_right = true;
  /// Rings at the wall come first, those they surround after them; false: the other way round.
  bool outside_in = false;
  /// Where cutting should begin: exactly there where the first pass can be reached on a straight path.
  std::optional<Vec2> start;
  /// What the fastest of several plans is checked by.
  Machine machine;
  MmPerMin feed = MmPerMin::of(1000);
  /// Looked at between the trials of the search; Cancelled is thrown when it asks to stop.
  std::stop_token cancel;
};

/// The passes of one layer.
///
/// Shape   closed rings as oriented by their regions (the wall on the right), each with the ring that
/// surrounds it as
///         parent; open passes where the tool just fits and where rings leave material. First ring at
///         radius + wall_stock. Empty where the cutter has no legal position: the caller reports it.
/// Error   nothing reachable of `target` is left thicker than tol.uncut with ResidualRule::kOurs, whatever
/// the step. Cost    O(n log n + length of the result / radius). Source  CPO-kappa, CPO-rho; residuals:
/// docs/contour.md.
LayerPasses plan_contour(const Layer& layer, const ContourOptions& options, const Tolerances& tol);

// The papers' formulas. Angles are interior angles in radians, lengths mm.

/// CPO-kappa eq. 6: step / diameter that leaves neither residual nor overlap in a corner of angle alpha.
double kappa(double alpha);
/// CPO-rho eq. 8, printed with w = 1 mm: overlap of w sin(alpha/2) in the corner.
double rho(double alpha, double radius, double w = 1.0);
/// CPO-kappa eq. 4: size of what is left in a corner, overlap = 1 - step / diameter; <= 0 nothing.
double residual_size(double alpha, double radius, double overlap);
/// Passage from one contour to the next along the bisector: M = H / sin(alpha/2).
double passage_length(double step, double alpha);
/// Smallest interior angle between successive edges; pi where all is smooth or reflex.
double smallest_angle(const Region& contour);
/// Smallest after leaving out one single smallest (CPO-rho 3.2).
double second_smallest_angle(const Region& contour);
/// Where that single smallest is; none where several are equal.
std::optional<Vec2> single_smallest_corner(const Region& contour);

}  // namespace clearcut::plan::contour
