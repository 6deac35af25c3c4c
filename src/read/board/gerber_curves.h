// Curves of Gerber's operations.
#pragma once

#include <optional>

#include "geometry/edge.h"
#include "read/common/affine.h"

namespace clearcut::read {

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
