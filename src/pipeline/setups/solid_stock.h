// A stock other than a full block, a casting or a partly machined block, as a solid: cuts treated as made before.
#pragma once

#include <utility>
#include <vector>

#include "model/move.h"
#include "model/part.h"

namespace clearcut::pipeline {

/// Collects moves; moves that do not follow each other start new sections.
class Sweeps {
 public:
  /// `like`: section with the tool and the data of earlier cuts.
  void add(const Section& like, const Move& move);
  void append(Toolpath other);
  Toolpath take() { return std::move(out_); }

 private:
  Toolpath out_;
};

/// The volume of its block missing in the solid `stock`, as cuts that count as made before: straight down by the
/// narrowest flat mill among `tools`, everywhere within its reach. `stock` must be read with SolidOptions::is_stock.
/// `block`: place of its block in the coordinates of the part, which was read with it (ReadOptions::block) and may
/// have another zero since. Throws InputError if no tool is a flat mill.
///
/// Error   On the safe side: corners too narrow for that mill, undercuts, and openings only to the side or from below
///         count as filled. A cut reaching into the part is a gouge in the certificate: the stock lacks material of
///         the part.
/// Cost    that of one plan by contours.
Toolpath missing_of(Part stock, const Stock& block, const std::vector<Tool>& tools);

}  // namespace clearcut::pipeline
