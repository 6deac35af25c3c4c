// Outlines by lengths of edges and interior angles: a small text format for the input of the papers; see
// docs/input.md.
#pragma once

#include <string>
#include <string_view>

#include "model/part.h"
#include "read/common/read_options.h"

namespace clearcut::read {

/// Reads one closed outline: lines "LENGTH ANGLE [RADIUS]", one per edge, and lines "KEY VALUE" (name, unit, start,
/// orientation, lengths, top, depth, closing). The angle is the interior one at the edge's end, in degrees; the
/// radius is that of the arc rounding this corner.
///
/// Shape   a Part without stock, one closed pocket and its roughing workingstep; see read_outline_json.
/// Units   those of "unit" (mm if absent), result in mm.
/// Error   the closing error of the outline is noted, and distributed along it up to "closing" (0.05 mm).
/// Throws  InputError "file:line: ..." for unreadable or implausible lines, and for outlines with a greater closing
///         error.
/// Source  CPO-kappa section II and algorithm 1, CPO-rho appendix A; geometry/side_list.h has the symbols.
Part read_edges(std::string_view text, const std::string& file_name, const ReadOptions& options);

}  // namespace clearcut::read
