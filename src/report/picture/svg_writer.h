// The text of SVG elements: numbers, attributes, nesting, and paths with real arcs; and the colours of all pictures,
// each with its meaning.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/region.h"

namespace clearcut::report::palette {

inline constexpr const char* kInk = "#1c2733";          // words, outlines
inline constexpr const char* kFaint = "#66727f";        // second-rank words
inline constexpr const char* kRule = "#d5dbe1";         // frames, rules
inline constexpr const char* kMaterial = "#dfdcd5";     // remaining stock and part
inline constexpr const char* kWall = "#c4ccd4";         // drafted walls
inline constexpr const char* kFloor = "#dcebf7";        // target swept by the cutter
inline constexpr const char* kUncut = "#e02b3c";        // target within the cutter's reach but not swept
inline constexpr const char* kUnreachable = "#f5b53d";  // target out of reach
inline constexpr const char* kLeftOut = "#8a5a00";      // hatch of the part's faces that no feature makes
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

namespace clearcut::report {

/// Three decimals, trailing zeros removed; "0" for non-finite numbers.
std::string svg_number(double value);

/// False for points outside of any picture: not finite, or farther than 10 km from the origin.
bool drawable(Vec2 p);
bool drawable(const Edge& edge);

/// Data of a <path>: lines and true arcs, in the frame of the edges (x right, y up).
class PathData {
 public:
  /// Continues the curve if `edge` begins at the end of the last one. Undrawable edges are left out.
  void add(const Edge& edge);
  void add(const Loop& closed);
  void add(const Region& region);
  void add(const Regions& regions);
  /// A point: a disc if stroked with round caps.
  void add(Vec2 point);
  const std::string& text() const { return text_; }
  bool empty() const { return text_.empty(); }

 private:
  void line_to(Vec2 p);
  void arc_to(const Edge& arc);
  std::string text_;
  Vec2 pen_;
  bool down_ = false;
};

/// Writes elements in order; every text and attribute value is escaped here and nowhere else.
class SvgWriter {
 public:
  using Attributes = std::vector<std::pair<std::string_view, std::string>>;
  void open(std::string_view element, const Attributes& attributes);
  void close();
  void leaf(std::string_view element, const Attributes& attributes);
  void text(Vec2 at, std::string_view content, const Attributes& attributes);
  /// An element with text content, such as <title>.
  void words(std::string_view element, std::string_view content, const Attributes& attributes = {});
  /// Appends elements written by another writer.
  void raw(const std::string& elements) { text_ += elements; }
  /// A unique name.
  std::string new_id(std::string_view stem);
  const std::string& str() const { return text_; }

 private:
  void begin(std::string_view element, const Attributes& attributes);
  std::string text_;
  std::vector<std::string> open_;
  int ids_ = 0;
};

/// Page units: lines that show faces that are left out.
inline constexpr double kHatchStep = 7, kHatchWidth = 2.4;

/// Defines slanting lines, `step` apart, `width` wide, both in units of the element they are for; returns the fill.
std::string hatch(SvgWriter& svg, const std::string& color, double step, double width);

/// "M0 0L40 0A5 5 0 0 1 45 5Z": mm in the frame of the curve (y up), lines and true arcs of less than half a turn
/// each.
std::string svg_path(const Loop& loop);

}  // namespace clearcut::report
