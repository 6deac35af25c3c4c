// What became of the parts of one sheet in one program: copies of one part, or parts of several kinds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/box.h"

namespace clearcut::inline model {

/// All parts of one kind on a sheet of several kinds.
struct KindMade {
  std::string name;           ///< of its file
  int parts = 0;              ///< on the sheet
  int clean_parts = 0;        ///< without a fault of their own
  int turned = 0;             ///< by 90 degrees
  std::optional<int> wanted;  ///< absent: as many as fit

  int missing() const { return wanted ? std::max(0, *wanted - parts) : 0; }
};

/// One part of a sheet of several kinds. The features of the first place are named "NAME.1", and so on.
struct PlaceMade {
  std::size_t kind = 0;  ///< index into CopiesMade::kinds
  Box taken;             ///< mm; box of the part on the sheet
  bool turned = false;   ///< by 90 degrees to the left
};

struct CopiesMade {
  int parts = 0;                     ///< on the sheet
  int clean_parts = 0;               ///< without a fault of their own
  int turned = 0;                    ///< of those on the sheet, by 90 degrees
  double gap = 0;                    ///< mm between the boxes of two parts
  std::optional<int> wanted;         ///< of a sheet that was to be filled
  std::optional<int> at_most;        ///< of such a sheet: no layout has more parts
  Box sheet;                         ///< mm; all blocks together, or all that is cut where no stock is stated
  std::vector<KindMade> kinds = {};  ///< in the order in which they were asked for; empty: there is one kind
  std::vector<PlaceMade> places = {};  ///< in the order of their numbers; empty: there is one kind

  bool misses() const {
    return (wanted && *wanted > parts) ||
           std::any_of(kinds.begin(), kinds.end(), [](const KindMade& kind) { return kind.missing() > 0; });
  }
};

}  // namespace clearcut::inline model
