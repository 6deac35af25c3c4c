// How far apart passes lie.
#pragma once

#include <string>
#include <vector>

namespace clearcut::inline model {

/// How far apart successive contours lie; of other strategies only fractions and lengths.
struct StepoverRule {
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
  std::vector<StepoverRule> contours = {};
};

/// "widest", "lom" or "kappa", "rho", "second", "lom-corrected", "rho-corrected", the last three and rho with
/// their w in mm ("rho:0.5", default 1), "0.4" (fraction of the diameter), "3.5mm", or several of them with commas,
/// one a contour. Throws InputError.
StepoverRule parse_step_rule(const std::string& text);

/// What is asked for, with its text; "" leaves it to the strategy.
struct Stepover {
  std::string text;
  StepoverRule rule;
  bool is_given() const { return !text.empty(); }
};

/// Of a text that parse_step_rule takes, or "". Throws InputError.
Stepover parse_stepover(const std::string& text);

}  // namespace clearcut::inline model
