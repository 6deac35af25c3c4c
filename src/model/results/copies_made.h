// What became of the copies of one part in one program.
#pragma once

#include <optional>

#include "geometry/box.h"

namespace clearcut::inline model {

struct CopiesMade {
  int parts = 0;               ///< on the sheet
  int clean_parts = 0;         ///< without a fault of their own
  int turned = 0;              ///< of those on the sheet, by 90 degrees
  double gap = 0;              ///< mm between the boxes of two parts
  std::optional<int> wanted;   ///< of a sheet that was to be filled
  std::optional<int> at_most;  ///< of such a sheet: no layout has more parts
  Box sheet;                   ///< mm; all blocks together, or all that is cut where no stock is stated

  bool misses() const { return wanted && *wanted > parts; }
};

}  // namespace clearcut::inline model
