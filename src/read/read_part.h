// Any file that describes a part, by extension and content.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "model/part.h"
#include "model/setup_place.h"
#include "read/read_options.h"

namespace clearcut::read {

/// Bytes; larger files are refused.
inline constexpr std::size_t kLargestPart = std::size_t{256} << 20;

/// .p21 .stp .step .stpnc .238 (STEP-NC or a solid, by its schema), .dxf, .svg, .json (outline), .edges
/// (lengths and angles), .toml (job); files of other names by their first bytes. See docs/input.md.
///
/// Throws  InputError, one line, for a file that is missing, empty, unreadable, of another kind, or larger
///         than 256 MB, and whatever its reader throws.
Part read_part(const std::filesystem::path& file, const ReadOptions& options);

/// In how many set-ups a STEP-NC program is cut where there are several; 0 for all other files, and for those that cannot be read.
int setups_of_program(const std::filesystem::path& file);

/// The part of one set-up (from 1) of such a program, in the axes of that set-up with the workpiece's origin as zero. `place`: from the
/// coordinates of the workpiece to those. Throws as read_part(), and where there is no such set-up.
Part read_part_of_setup(const std::filesystem::path& file, int number, const ReadOptions& options,
                        SetupPlace& place);

/// The same as read_part() for text already read; `file_name` gives the extension and stands in messages. Job files name
/// other files, which are looked for beside `file_name`.
Part read_part_text(std::string_view text, const std::string& file_name, const ReadOptions& options);

/// What "pocket", "PROFILE_D6", ... say of outlines: their role, and a depth where there is one. Throws InputError at
/// `place` for words that say no role.
LayerRule rule_named(const std::string& kind, const std::string& place);

/// "KIND:SELECTION", as in "profile:outer", "drill_d6:HOLES", "inside:2,5". Throws InputError at `place`.
LayerRule rule_of_option(const std::string& text, const std::string& place);

}  // namespace clearcut::read
