// The units that a file states for its lengths and angles.
#pragma once

#include <optional>

#include "base/diagnostics.h"
#include "read/part21/part21.h"

namespace clearcut::read::stepnc {

struct FileUnits {
  double mm_per_length = 1;
  std::optional<double> radians_per_angle;  ///< absent: not stated
};

/// What the GLOBAL_UNIT_ASSIGNED_CONTEXTs of a file assign: SI units with their prefixes, and units converted from them (inch, degree).
/// Without any, lengths are mm. Noted where it is another unit; warned of where a unit is defined and no context assigns it. Throws
/// InputError for units that cannot be read, and where two contexts assign different ones.
FileUnits file_units(const P21File& file, Diagnostics& diagnostics);

}  // namespace clearcut::read::stepnc
