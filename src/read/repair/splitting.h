// A loop that touches itself in points becomes several that do not.
#pragma once

#include <vector>

#include "read/repair/meetings.h"

namespace clearcut::read {

/// Splits `loop` at every place of `touches` (its meetings with itself): edges are divided there, and each
/// part that returns to a place becomes a loop of its own. Together they bound the same area under the
/// even-odd rule. Cost O(n log n).
std::vector<Loop> split_at(const Loop& loop, const std::vector<Meeting>& touches);

}  // namespace clearcut::read
