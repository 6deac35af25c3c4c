// Finds the moves of a drilled hole that a control has one word for.
#pragma once

#include <optional>
#include <span>

#include "model/move.h"
#include "post/print_grid.h"

namespace clearcut::post {

/// A hole as G81 or G83 makes it. Printed heights.
struct DrillBlock {
  Ticks bottom;
  long long clear = 0;  ///< where feeding begins (R word)
  long long above = 0;  ///< height before and after
  long long peck = 0;   ///< Q word; 0: in one go
  MmPerMin feed;
  std::size_t moves = 0;  ///< how many it stands for
};

/// The hole that `moves` begin with: down at the rapid, down at the feed (with rises to where that began and returns to
/// just above the last depth, in equal pecks), and back up at the rapid to where it came from.
std::optional<DrillBlock> drill_block(std::span<const Move> moves, const PrintGrid& grid);

}  // namespace clearcut::post
