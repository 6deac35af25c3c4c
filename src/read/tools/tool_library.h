// Tool libraries of other programs, and our own.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "model/library.h"
#include "model/tool.h"
#include "read/common/data_value.h"

namespace clearcut::read {

/// FreeCAD .fctb (one tool) and .fctl (a library, its tools beside it or in ../Bit), LinuxCNC .tbl, Fusion
/// .json, and our .toml ([[tool]]; see docs/input.md), by extension.
///
/// Units   mm, mm/min and rpm, for any unit of the file.
/// Throws  InputError, one line, for unreadable files and for libraries without a single usable tool. Tools other
///         than rotating cutters (probes, taps without a pitch, V-bits of other programs, ...) are dropped and
///         reported.
ToolLibrary read_tool_library(const std::filesystem::path& file, const ToolOptions& options);
/// The same for text already read. A .fctl has its tools searched beside `file_name`.
ToolLibrary read_tool_library_text(std::string_view text, const std::string& file_name,
                                   const ToolOptions& options);

/// The tool's preset of this name (* for anything, any case), or its first; null if it has none.
const CuttingPreset* preset_of(const LibraryTool& tool, const std::string& name);

/// One [[tool]] of our own format.
LibraryTool tool_of_section(DataSection section);

/// The key coolant: off, flood, mist or both; true is flood, false off.
std::optional<Coolant> coolant_in(DataSection& section);

/// Drops tools without a diameter and replaces numbers already in use, or not above 0; reports both.
void settle(ToolLibrary& library, const std::string& where);

}  // namespace clearcut::read
