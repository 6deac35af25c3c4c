// A stock that is no full block: a casting, or a block that is machined in part, as a solid.
#pragma once

#include <vector>

#include "model/move.h"
#include "model/part.h"

namespace clearcut::pipeline {

/// What the solid `stock` lacks of its block, as cuts that count as made before: of the narrowest flat mill among `tools`, straight
/// down, everywhere it reaches. `stock` is read with SolidOptions::is_stock. `block`: where its block lies in the coordinates of the
/// part, which was read with it (ReadOptions::block) and may have another zero since. Throws InputError where no tool is a flat mill.
///
/// Error   On the safe side: corners too narrow for that mill, undercuts, and what is open to the side or from below alone count as
///         there. A cut that reaches into the part is a gouge of the certificate: the stock lacks material that the part has.
/// Cost    that of one plan by contours.
Toolpath missing_of(Part stock, const Stock& block, const std::vector<Tool>& tools);

}  // namespace clearcut::pipeline
