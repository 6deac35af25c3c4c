// Outline JSON: the plainest way to say what to mill; see docs/input.md.
#pragma once

#include <string>
#include <string_view>

#include "part/part.h"
#include "read/read_options.h"

namespace clearcut {

/// Reads `{"name", "units", "outer": [[x, y, bulge], ...], "islands": [[[x, y, bulge], ...], ...], "top",
/// "depth", "slope_rad"}` or `{"units", "pockets": [...]}` with several of them. The bulge may be left out.
///
/// Shape   a Part without stock (solid everywhere outside), one closed pocket per outline and one roughing
///         workingstep per pocket. `tools` stays empty: the caller supplies tools and Operation::tool.
/// Units   those of "units" (mm when absent), result in mm.
/// Throws  InputError "file:line: ..." for bad JSON, missing or impossible values, outlines beyond repair.
Part read_outline_json(std::string_view text, const std::string& file_name, const ReadOptions& options);
Part read_outline_json(std::string_view text, const std::string& file_name, const Tolerances& tol);

}  // namespace clearcut
