// Heights a program needs besides those of its moves.
#pragma once

#include "part/part.h"
#include "toolpath/move.h"

namespace clearcut {

/// Where the tool may travel anywhere: the highest z of the toolpath, and no lower than part.safe_z(). mm.
double safe_height(const Toolpath& toolpath, const Part& part);

}  // namespace clearcut
