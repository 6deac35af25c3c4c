// DXF of the CADs that write SVG, too.
#pragma once

#include <string>
#include <vector>

#include "support/cad/cad_part.h"

namespace clearcut::test_support {

std::string kicad_dxf(const CadPart& part, Random& random);
std::string openscad_dxf(const std::vector<std::vector<Vec2>>& polygons);

}  // namespace clearcut::test_support
