// What holds the pieces that profiles cut free.
#pragma once

#include <optional>

namespace clearcut::inline model {

/// Bridges that hold what profiles cut free.
struct TabOptions {
  int count = 0;                 ///< of every profile; 0: none
  double width = 4;              ///< mm, along the outline
  std::optional<double> height;  ///< mm above the material's underside; absent: half the depth, 2 mm at most
  std::optional<double> skin;    ///< mm of material that profiles leave under themselves, instead of tabs
};

}  // namespace clearcut::inline model
