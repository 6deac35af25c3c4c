#include "model/coolant.h"

#include <algorithm>

namespace clearcut::inline model {

const std::vector<std::string>& coolant_names() {
  static const std::vector<std::string> names{"off", "flood", "mist", "both"};
  return names;
}

const std::string& name_of(Coolant coolant) {
  return coolant_names()[static_cast<std::size_t>(coolant)];
}

std::optional<Coolant> coolant_named(const std::string& name) {
  const auto& names = coolant_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Coolant>(found - names.begin());
}

}  // namespace clearcut::inline model
