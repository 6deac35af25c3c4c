// Speeds and feeds of the cutters that are compared.
#pragma once

#include <optional>
#include <vector>

namespace clearcut::inline options {

/// Cutting data of cutters; absent values come from the part or the defaults of prepare().
struct ToolSpeeds {
  std::optional<double> cutting_speed;
  /// Feed of each tool in the given order; the last one applies to the rest.
  std::vector<double> feeds_per_tooth;
  double tool_change_s = 10;  ///< between the tools of a sequence
};

}  // namespace clearcut::inline options
