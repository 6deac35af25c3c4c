// Heidenhain conversational programs, and Heidenhain's cycles for one hole.
#pragma once

#include <string>

#include "model/options/post_options.h"
#include "post/words/drill_cycle.h"

namespace clearcut::post {

/// The definition of the cycle for exactly the moves of this hole: a block of several lines; CYCL CALL runs it at the
/// tool's position. "" if there is no such cycle, or if the meaning of its words is not certain: the moves are
/// written then. `surface`: Z of the material's top there, mm, between the bottom and the height at which feeding
/// begins.
std::string hole_cycle(const DrillBlock& hole, double surface, const Tool* tap, const PrintGrid& grid,
                       bool inch);

/// Whether the control can tie this tap's feed to its spindle: its pitch can be printed.
bool taps_rigidly(const Tool& tap, bool inch);

/// Decimals accepted by older controls; newer ones read one more.
inline constexpr int kKlartextMmDecimals = 3;
inline constexpr int kKlartextInchDecimals = 4;

inline constexpr int kKlartextFeedDecimals = 2;

/// A feed as printed, in steps of its decimals: mm/min, or in inch programs tenths of an inch. At least one step.
long long klartext_feed(MmPerMin feed, bool inch);

/// Permitted distance of a helix' end from the grid, in steps: its angle is printed, not its end.
inline constexpr double kKlartextDrift = 0.15;

/// `toolpath` has been checked by post().
std::string write_klartext(const Toolpath& toolpath, const Part& part, const PostOptions& options);

}  // namespace clearcut::post
