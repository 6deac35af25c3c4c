// One function for each format of tool library; see tool_library.h.
#pragma once

#include <string>
#include <string_view>

#include "read/tools/tool_library.h"

namespace clearcut::read {

/// Degrees between the flanks of cones, and of each side of tapered end mills.
inline constexpr double kSharpestCone = 5, kBluntestCone = 170;
inline constexpr double kLeastTaper = 0.1, kMostTaper = 45;

/// A text among the values of `object`; empty if there is none of this name.
std::string text_of(const DataValue& object, const char* key);

/// A FreeCAD tool bit. Nothing, with a report, if it is no cutter for pockets.
std::optional<LibraryTool> read_freecad_bit(std::string_view text, const std::string& file_name,
                                            Diagnostics& diagnostics);
ToolLibrary read_freecad_library(std::string_view text, const std::string& file_name);
ToolLibrary read_linuxcnc_table(std::string_view text, const std::string& file_name,
                                const ToolOptions& options);
ToolLibrary read_fusion_library(std::string_view text, const std::string& file_name);
ToolLibrary read_own_library(std::string_view text, const std::string& file_name);

}  // namespace clearcut::read
