// Questions about programs that exist.
#pragma once

#include <array>
#include <optional>

#include "model/dialect.h"
#include "model/part.h"

namespace clearcut::inline options {

/// Basis of a program's check: a part, or only a stock.
struct ProgramQuestion {
  const Part* part = nullptr;  ///< null: there is none
  std::optional<Stock> stock;  ///< without a part; absent: the box of all cuts
  std::optional<double> top;   ///< mm, likewise
  std::optional<Dialect> dialect;
};

/// Where a program was stopped: one of the two.
struct Stop {
  std::optional<int> line;  ///< the first that is run again
  std::optional<std::array<double, 3>>
      place;  ///< mm: where the tip stood; the move that passes there is run again as a whole
};

}  // namespace clearcut::inline options
