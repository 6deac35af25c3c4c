// Outline JSON: the simplest format for shapes to be milled; see docs/input.md.
#pragma once

#include <string>
#include <string_view>

#include "model/part.h"
#include "read/common/read_options.h"

namespace clearcut::read {

/// Reads `{"name", "units", "outer": [[x, y, bulge], ...], "islands": [[[x, y, bulge], ...], ...], "top",
/// "depth", "slope_rad"}` or `{"units", "pockets": [...]}` with several of them. The bulge may be left out.
/// Additions of write_outline_json are read too: "kind", "allowed" (area permitted to the cutter, for open sides),
/// "through" and "stock".
///
/// Shape   a Part without stock (solid everywhere outside) unless the file has one, one feature per outline
///         and one roughing workingstep per feature. `tools` stays empty: the caller supplies tools and
///         Operation::tool.
/// Units   those of "units" (mm if absent), result in mm.
/// Throws  InputError "file:line: ..." for bad JSON, missing or impossible values, outlines beyond repair.
Part read_outline_json(std::string_view text, const std::string& file_name, const ReadOptions& options);
Part read_outline_json(std::string_view text, const std::string& file_name, const Tolerances& tol);

}  // namespace clearcut::read
