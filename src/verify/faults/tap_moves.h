// How taps are driven, whatever part they are for.
#pragma once

#include <string>
#include <vector>

#include "model/part.h"
#include "model/results/findings.h"
#include "verify/checked_move.h"
#include "verify/verify.h"

namespace clearcut::verify {

/// What is wrong with one move of a tap along its axis.
struct TapDefect {
  double size = 0;   ///< mm in each turn by which the feed misses the pitch; 0: another
  std::string text;  ///< what it does, without its place
};

/// Of the move with that place in the program, a feed move of a tap straight down or up: its feed is the tap's pitch times the speed, the
/// spindle turns as the tap's hand asks, in and out, and after the way down it comes out at its feed at once, up to `top_z`, mm, at least.
std::vector<TapDefect> defects_of_tap_move(const CheckedProgram& program, std::size_t index, double top_z,
                                           const VerifyOptions& options);

/// Of taps where nobody states a part: the same of each of their strokes into the stock, and whether a hole was made before.
std::vector<Fault> faults_of_taps_alone(const Part& part, const CheckedProgram& program,
                                        const VerifyOptions& options);

}  // namespace clearcut::verify
