// Reads any file describing a part, by extension and content: jobs, and files that describe a part by themselves.
// Jobs, which name such a file, use this reader.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "model/part.h"
#include "model/setup_place.h"
#include "options/read_options.h"

namespace clearcut::read {

/// Bytes; larger files are refused.
inline constexpr std::size_t kLargestPart = std::size_t{256} << 20;

/// Whether the name is a job's (.toml).
bool is_job_file(const std::string& file_name);

/// Throws InputError for empty or binary text, UTF-16 or a file of another program, with any name.
void refuse_what_is_no_part(std::string_view text, const std::string& file_name);

/// The options with derived values: the gap up to which ends are joined, the block as the stock of solids.
ReadOptions completed(ReadOptions options);

/// The part with the block of the options, profiles through the stock a little below it, and numbers without the last
/// digits added by formats. `options` must be completed.
Part as_asked(Part part, const ReadOptions& options, const std::string& file_name);

/// The same as read_part_text() for every file except jobs; they are refused as files of an unknown kind.
Part read_part_file(std::string_view text, const std::string& file_name, const ReadOptions& options);

/// Number of set-ups of a STEP-NC program if there are several; 0 for all other files, and for unreadable ones.
int setups_of_program(const std::filesystem::path& file);

/// The part of one set-up (from 1) of such a program, in the axes of this set-up with the workpiece's origin as zero.
/// `place`: transform from the coordinates of the workpiece. Throws as read_part(), and if the set-up does not exist.
Part read_part_of_setup(const std::filesystem::path& file, int number, const ReadOptions& options,
                        SetupPlace& place);

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
