// A stock other than a full block: a casting, or a partly machined block, as a solid.
#pragma once

#include <vector>

#include "model/move.h"
#include "model/part.h"

namespace clearcut::pipeline {

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
