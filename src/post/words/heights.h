// Heights a program needs besides those of its moves.
#pragma once

#include "model/move.h"
#include "model/part.h"

namespace clearcut::post {

/// Height for free travel of the tool: the highest z of the toolpath, and no lower than part.safe_z(). mm.
double safe_height(const Toolpath& toolpath, const Part& part);

}  // namespace clearcut::post
