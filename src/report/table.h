// The final table of the command, one line per feature, the total, and the faults, and the results of the strategies,
// feature by feature.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/part.h"
#include "model/results/findings.h"
#include "model/results/strategy_selection.h"
#include "report/words/text_table.h"

namespace clearcut::report {

/// Shape   heading, one row per feature and tool in the order of work, the total, then the faults: the worst
///         ten with their places, and the number of the others.
/// Units   mm, mm2, degrees, hours:minutes:seconds, each named in its heading. Uncut mm is the proven bound.
/// Text    ASCII, no line of the table wider than `width` columns; a figure that is not a number is "?".
std::string table(const Part& part, const Findings& findings, std::size_t width = 120);

/// Feed length of all levels with a lower bound, and the sum of the bounds, mm. Levels without one, as of profiles and
/// holes, do not count.
struct BoundedFeed {
  double feed_mm = 0;
  double bound_mm = 0;
  /// Per cent by which the feed exceeds the least possible at most; 0 without a bound.
  double percent_above() const { return bound_mm > 0 ? 100 * (feed_mm / bound_mm - 1) : 0; }
};
BoundedFeed bounded_feed(const Findings& findings);

/// One row for each feature and strategy: time, feed length, outcome. Times with ">" are lower bounds of strategies
/// not planned because they cannot win.
TextTable selection_table(const std::vector<StrategySelection>& selections);

}  // namespace clearcut::report
