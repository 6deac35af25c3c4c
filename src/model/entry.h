// Names of the ways into the material.
#pragma once

#include "model/part.h"

namespace clearcut::inline model {

/// "helix", as on the command line.
const char* name_of(EntryKind entry);

}  // namespace clearcut::inline model
