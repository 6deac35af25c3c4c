// Every kind of entity that ISO 14649-10, -11 and -111 have for 2.5-D milling, and what becomes of it; the units that
// a file states for its lengths and angles.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "read/part21/part21.h"
#include "read/stepnc/file/node.h"

namespace clearcut::read::stepnc {

/// Throws what is listed for the kind of `node` where that is refused; returns where it is not.
void refuse_listed(const Node& node);

/// The tables of the documentation, as Markdown.
std::string entity_tables();

struct FileUnits {
  double mm_per_length = 1;
  std::optional<double> radians_per_angle;  ///< absent: not stated
};

/// What the GLOBAL_UNIT_ASSIGNED_CONTEXTs of a file assign: SI units with their prefixes, and units converted from them (inch, degree).
/// Without any, lengths are mm. Noted where it is another unit; warned of where a unit is defined and no context assigns it. Throws
/// InputError for units that cannot be read, and where two contexts assign different ones.
FileUnits file_units(const P21File& file, Diagnostics& diagnostics);

}  // namespace clearcut::read::stepnc
