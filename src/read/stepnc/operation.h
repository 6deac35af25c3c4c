// Operations and their cutting data.
#pragma once

#include "model/part.h"
#include "read/stepnc/node.h"
#include "read/stepnc/tools.h"

namespace clearcut::read::stepnc {

/// An operation; its retract_z is above the top of the feature. Throws InputError for operations that cannot be machined yet and for missing tools.
Operation read_operation(const Node& operation, const Tools& tools, Context& context);

}  // namespace clearcut::read::stepnc
