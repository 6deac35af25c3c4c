// Design elements as a user types them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/design_element.h"
#include "model/tool.h"

namespace clearcut::inline options {

/// One option: numbers between commas, then words between colons.
///
///   line    X1,Y1,X2,Y2          arc   X1,Y1,X2,Y2,RADIUS,cw|ccw
///   pocket  X,Y,LENGTH,WIDTH     hole  X,Y,DIAMETER
///   slot    X1,Y1,X2,Y2,WIDTH
///   words   T2  depth=3  stepdown=1  feed=400  id=NAME  corner=upper-right (pocket)
struct ElementOption {
  std::string kind;  ///< "line", "arc", "pocket", "hole", "slot"
  std::string text;
};

/// Defaults of elements.
struct ElementDefaults {
  std::vector<Tool> tools;  ///< those without a number get their place, from 1
  std::optional<double> depth;
  std::optional<double> stepdown;
  CuttingData cutting;
  double resolution = 1;
  MiddleRow middle_row = MiddleRow::kKeep;
  /// "X0,X1,Y0,Y1,Z0,Z1"; absent: the box of the elements and the largest tool's diameter around it, on whole
  /// squares, from the deepest element up to 0.
  std::optional<std::string> stock;
};

}  // namespace clearcut::inline options
