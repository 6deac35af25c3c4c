#include "read/repair/repair.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "read/repair/clean.h"
#include "read/repair/joining.h"
#include "read/repair/mends.h"
#include "read/repair/nesting.h"

namespace clearcut {
namespace {

/// Loops thinner than this on average enclose nothing to mill, mm.
constexpr double kThinnest = 1e-3;

/// Area and length of a thin loop compared: its mean width, mm.
double mean_width(const Loop& loop) {
  return 2 * std::abs(signed_area(loop)) / length(loop);
}

std::vector<RawLoop> without_thin(std::vector<RawLoop> loops, const RepairOptions& options,
                                  Diagnostics& diagnostics) {
  std::vector<RawLoop> kept;
  for (RawLoop& loop : loops) {
    if (mean_width(loop.loop) > kThinnest) {
      kept.push_back(std::move(loop));
      continue;
    }
    diagnostics.repair(options.where + " at " + place_text(loop.loop.front().from),
                       "an outline (" + loop.source + ") that encloses nothing was dropped: length " +
                           short_number(length(loop.loop)) + " mm");
  }
  return kept;
}

}  // namespace

Regions repair(std::vector<RawCurve> curves, const RepairOptions& options, Diagnostics& diagnostics) {
  const bool nothing_drawn = curves.empty();
  std::vector<RawLoop> loops = join(clean(std::move(curves), options, diagnostics), options, diagnostics);
  loops = without_thin(std::move(loops), options, diagnostics);
  if (loops.empty()) {
    throw InputError(options.where, nothing_drawn
                                        ? "no closed outline found; draw the pocket as a closed curve"
                                        : "no outline encloses an area; draw the pocket as a closed curve");
  }
  std::vector<Loop> clean_loops;
  for (RawLoop& loop : loops) clean_loops.push_back(std::move(loop.loop));
  return nested(clean_loops);
}

}  // namespace clearcut
