// For tests: jobs of design elements.
#pragma once

#include <string>

#include "model/design_element.h"

namespace clearcut::test_support {

inline const std::string kExample = std::string(CLEARCUT_SOURCE_DIR) + "/examples/five_pockets.toml";

inline std::string square_pocket(double side, double radius, const std::string& rule) {
  return "middle_row = \"" + rule +
         "\"\n[stock]\nx = [0, 60]\ny = [0, 60]\nz = [-10, 0]\n[[tool]]\ndiameter = " +
         std::to_string(2 * radius) +
         "\n[[element]]\nkind = \"rectangle\"\nbase = [5, 5]\nlength = " + std::to_string(side) +
         "\nwidth = " + std::to_string(side) + "\ndepth = 1\n";
}

inline DesignElement rectangle(Vec2 base, double length, double width, Corner corner = Corner::kLowerLeft) {
  DesignElement element;
  element.from = base;
  element.length = length;
  element.width = width;
  element.base = corner;
  return element;
}

}  // namespace clearcut::test_support
