// The colours of all pictures, each with its meaning.
#pragma once

#include <string>

namespace clearcut::report::palette {

inline constexpr const char* kInk = "#1c2733";          // words, outlines
inline constexpr const char* kFaint = "#66727f";        // second-rank words
inline constexpr const char* kRule = "#d5dbe1";         // frames, rules
inline constexpr const char* kMaterial = "#dfdcd5";     // remaining stock and part
inline constexpr const char* kWall = "#c4ccd4";         // drafted walls
inline constexpr const char* kFloor = "#dcebf7";        // target swept by the cutter
inline constexpr const char* kUncut = "#e02b3c";        // target within the cutter's reach but not swept
inline constexpr const char* kUnreachable = "#f5b53d";  // target out of reach
inline constexpr const char* kGouge = "#c2139b";        // swept, and not allowed
inline constexpr const char* kImpact = "#4a90d0";       // swept outside the target, in the permitted area
inline constexpr const char* kCut = "#0b57a8";
inline constexpr const char* kLink = "#17915a";
inline constexpr const char* kEntry = "#e8760c";
inline constexpr const char* kRapid = "#7a6a8e";
inline constexpr const char* kGood = "#178a4c";
inline constexpr const char* kWarn = "#8a5a00";
inline constexpr const char* kBad = "#d11f31";

/// Shade of a floor: 0 at the top of the work (pale), 1 at its deepest (dark blue). Clamped.
std::string depth_color(double fraction);
/// Shade of a material of the work as it looks, 0 at the top, darker to 1 at its deepest; of none, and of one without a colour
/// of its own, depth_color().
std::string material_color(const std::string& material, double fraction);
/// Lines that stand out on depth_color(fraction).
std::string line_color_on_depth(double fraction);
/// Cutting lines of the i-th tool.
std::string tool_color(int i);

}  // namespace clearcut::report::palette
