// The names of all conditions that a verdict may depend on.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace clearcut::inline model {

/// One kind of condition. `#` in a name stands for the number of an offset, a word or a length: "g#-p#" is g54.1-p2.
struct ConditionRow {
  std::string_view name = {};
  std::string_view example = {};  ///< a name that it stands for, where that is not its own
};

/// In the order of docs/conditions.md, which says what must hold for each.
std::span<const ConditionRow> condition_rows();

/// Whether some program or part can depend on a condition of that name.
bool is_condition(const std::string& name);

}  // namespace clearcut::inline model
