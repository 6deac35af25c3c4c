// Reads any file describing a part, by extension and content.
#pragma once

#include <filesystem>
#include <string_view>

#include "model/part.h"
#include "read/formats/part_file.h"

namespace clearcut::read {

/// .p21 .stp .step .stpnc .238 (STEP-NC or a solid, by its schema), .dxf, .svg, .json (outline), .edges
/// (lengths and angles), .toml (job); files of other names by their first bytes. See docs/input.md.
///
/// Throws  InputError, one line, for a file that is missing, empty, unreadable, of another kind, or larger
///         than 256 MB, and all exceptions of its reader.
Part read_part(const std::filesystem::path& file, const ReadOptions& options);

/// The same as read_part() for text already read; `file_name` gives the extension and the name in messages. Other
/// files named in job files are searched beside `file_name`.
Part read_part_text(std::string_view text, const std::string& file_name, const ReadOptions& options);

}  // namespace clearcut::read
