// A file that describes a part by itself: any format, by extension and content. Jobs, which name such a file, are read on top of it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "model/part.h"
#include "model/setup_place.h"
#include "read/common/read_options.h"

namespace clearcut::read {

/// Bytes; larger files are refused.
inline constexpr std::size_t kLargestPart = std::size_t{256} << 20;

/// Whether the name is that of a job (.toml).
bool is_job_file(const std::string& file_name);

/// Throws InputError for text that is empty, binary, UTF-16 or a file of another program, whatever its name says.
void refuse_what_is_no_part(std::string_view text, const std::string& file_name);

/// The options with what follows from them: how far ends are joined, the block as the stock of solids.
ReadOptions completed(ReadOptions options);

/// The part with the block of the options, profiles through the stock a little below it, and numbers without the last digits
/// that formats add. `options` are completed.
Part as_asked(Part part, const ReadOptions& options, const std::string& file_name);

/// As read_part_text() for every file but jobs, which are refused as files of an unknown kind.
Part read_part_file(std::string_view text, const std::string& file_name, const ReadOptions& options);

/// In how many set-ups a STEP-NC program is cut where there are several; 0 for all other files, and for those that cannot be read.
int setups_of_program(const std::filesystem::path& file);

/// The part of one set-up (from 1) of such a program, in the axes of that set-up with the workpiece's origin as zero. `place`: from the
/// coordinates of the workpiece to those. Throws as read_part(), and where there is no such set-up.
Part read_part_of_setup(const std::filesystem::path& file, int number, const ReadOptions& options,
                        SetupPlace& place);

}  // namespace clearcut::read
