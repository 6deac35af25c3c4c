// Design elements as a user types them on the command line, and job files of design elements.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/design_element.h"

namespace clearcut::read {

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

/// The job in the options' order. Only the form is checked here, as for job files. Throws InputError naming the
/// option.
ElementJob elements_of_options(const std::vector<ElementOption>& options, const ElementDefaults& defaults);

/// TOML: name, resolution (mm), middle_row = "keep" or "strict", [stock] with x, y, z = [low, high],
/// [[tool]] and [[element]]; docs/grid.md lists every key. Only the form is checked here; whether the
/// elements can be made is checked by the planner, all faults at once. Throws InputError "file:line: ...".
/// Cost O(length).
ElementJob read_elements(const std::filesystem::path& file);
ElementJob read_elements_text(std::string_view text, const std::string& file_name);

}  // namespace clearcut::read
