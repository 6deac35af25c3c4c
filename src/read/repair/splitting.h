// Splits a loop that touches itself in points into several that do not.
#pragma once

#include <vector>

#include "read/repair/meetings.h"

namespace clearcut::read {

/// Splits `loop` at every place of `touches` (its meetings with itself): edges are divided there, and each part
/// returning to a place becomes a separate loop. Together they bound the same area under the even-odd rule. Cost O(n
/// log n).
std::vector<Loop> split_at(const Loop& loop, const std::vector<Meeting>& touches);

}  // namespace clearcut::read
