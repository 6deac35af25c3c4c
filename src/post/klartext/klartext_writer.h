// Heidenhain conversational programs.
#pragma once

#include <string>

#include "model/options/post_options.h"

namespace clearcut::post {

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
