// Coordinates as the files of circuit boards write them, digits without a decimal point and zeros left out, curves of
// Gerber's operations, and items drawn on a layer one over the other, with the resulting dark area.
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/edge.h"
#include "geometry/region.h"
#include "read/common/affine.h"
#include "read/repair/repair.h"

namespace clearcut::read {

struct CoordinateFormat {
  int whole = 3;                  ///< digits before the point
  int decimals = 3;               ///< digits after the decimal point
  bool trailing_omitted = false;  ///< zeros at the end are left out; else those at the beginning
};

/// "-1250" as -1.25 if three digits follow the point; numbers with a point are taken as written. Nothing for text
/// other than numbers.
std::optional<double> coordinate(std::string_view text, const CoordinateFormat& format);

/// A number as written: "0.8", "-3", ".5".
std::optional<double> plain_number(std::string_view text);
/// Number of a code or a tool, 0 to below 1e9, without its decimals; nothing for anything else.
std::optional<int> code_number(std::string_view text);

/// "X100Y-5D01" as X 100, Y -5, D 01. Nothing for any other text.
using Words = std::vector<std::pair<char, std::string_view>>;
std::optional<Words> words_of(std::string_view text);

struct Drawn {
  bool dark = true;          ///< else the item clears earlier ones
  std::vector<Path> pieces;  ///< loops; their union by the nonzero rule is drawn
  Path line;                 ///< a stroke: path of the aperture's centre
};

/// Under a similarity or any other affine map; circles may become ellipses within kCurveTolerance.
Drawn mapped(const Drawn& drawn, const Affine& map);

/// Throws InputError as repair does. Cost O(n log n) and a boolean for each change between dark and clear.
Regions dark_area(const std::vector<Drawn>& drawn, const RepairOptions& options);

/// Coordinates of one operation, mm; absent ones are unchanged.
struct GerberMove {
  std::optional<double> x, y, i, j;

  /// Letters other than X, Y, I, J are not used.
  void set(char letter, double value);
  bool any() const { return x || y || i || j; }
  Vec2 end(Vec2 from, bool is_incremental) const;
  Vec2 center_offset() const { return {i.value_or(0), j.value_or(0)}; }
};

/// A line, or an arc about from + offset (with `single_quadrant`, of at most a quarter turn, and the offset has no
/// signs); a full circle if both ends are equal and the arc is no quadrant. Empty if the ends of a line are equal.
/// Nothing if no centre fits: the distances to the ends differ by more than a tenth. The centre is moved to make them
/// equal.
std::optional<Path> gerber_edge(Vec2 from, Vec2 to, Vec2 offset, Turn turn, bool single_quadrant);

/// The area swept by a rectangle under `map` (about the origin) along a line.
Path swept_rectangle(const Edge& line, Vec2 size, const Affine& map);

}  // namespace clearcut::read
