// Outlines in two small formats, see docs/input.md: outline JSON, the simplest format for shapes to be milled, and
// lengths of edges with interior angles, for the input of the papers.
#pragma once

#include <string>
#include <string_view>

#include "model/part.h"
#include "options/read_options.h"
#include "read/common/data_value.h"

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

/// Reads `{"name", "units", "outer": [[x, y, bulge], ...], "islands": [[[x, y, bulge], ...], ...], "top",
/// "depth", "slope_rad"}` or `{"units", "pockets": [...]}` with several of them. The bulge may be left out.
/// Additions of write_outline_json are read too: "kind", "allowed" (area permitted to the cutter, for open sides),
/// "through", "floor_fillet" and "stock".
///
/// Shape   a Part without stock (solid everywhere outside) unless the file has one, one feature per outline
///         and one roughing workingstep per feature. `tools` stays empty: the caller supplies tools and
///         Operation::tool.
/// Units   those of "units" (mm if absent), result in mm.
/// Throws  InputError "file:line: ..." for bad JSON, missing or impossible values, outlines beyond repair.
Part read_outline_json(std::string_view text, const std::string& file_name, const ReadOptions& options);
Part read_outline_json(std::string_view text, const std::string& file_name, const Tolerances& tol);
/// The same for a value within another JSON text, whose name and lines stand in messages.
Part read_outline_value(const DataValue& root, const std::string& file_name, const ReadOptions& options);

}  // namespace clearcut::read
