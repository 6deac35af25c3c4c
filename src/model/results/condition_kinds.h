// Names of all conditions on which a verdict may depend.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace clearcut::inline model {

/// One kind of condition. `#` in a name represents the number of an offset, a word or a length: "g#-p#" is g54.1-p2.
struct ConditionRow {
  std::string_view name = {};
  std::string_view example = {};  ///< an example of a full name, if it differs from `name`
};

/// In the order of docs/conditions.md, which explains each condition.
std::span<const ConditionRow> condition_rows();

/// Whether there is a condition of this name.
bool is_condition(const std::string& name);

}  // namespace clearcut::inline model
