// Tabs holding the pieces that profiles cut free.
#pragma once

#include <optional>
#include <vector>

#include "geometry/vec2.h"

namespace clearcut::inline model {

/// Seen along the kerf: with upright sides, or rising evenly to a ridge in the middle.
enum class TabShape : unsigned char { kSquare, kTriangular };

/// Tabs holding the pieces that profiles cut free. Only one of `count`, `spacing` and `at` may be given.
struct TabOptions {
  int count = 0;                  ///< number of tabs of every profile; 0: none
  std::optional<double> spacing;  ///< mm along every profile from one tab to the next, at most
  std::vector<Vec2> at;           ///< mm; requested places of tabs, on or beside outlines
  TabShape shape = TabShape::kSquare;
  /// mm; width along the outline, for triangular tabs at the material's underside.
  double width = 4;
  std::optional<double> height;  ///< mm above the material's underside; absent: half the depth, 2 mm at most
  std::optional<double> skin;    ///< mm of material left below profiles instead of tabs

  bool any() const { return count > 0 || spacing || !at.empty(); }
};

}  // namespace clearcut::inline model
