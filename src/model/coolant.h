// Coolant: cools the cutter and removes the chips.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace clearcut::inline model {

enum class Coolant : unsigned char {
  kOff,
  kFlood,  ///< M8; through the tool likewise
  kMist,   ///< M7
  kBoth    ///< flood and mist at once
};

constexpr bool has_flood(Coolant coolant) {
  return coolant == Coolant::kFlood || coolant == Coolant::kBoth;
}
constexpr bool has_mist(Coolant coolant) {
  return coolant == Coolant::kMist || coolant == Coolant::kBoth;
}
constexpr Coolant coolant_of(bool flood, bool mist) {
  return flood ? (mist ? Coolant::kBoth : Coolant::kFlood) : (mist ? Coolant::kMist : Coolant::kOff);
}

/// "off", "flood", "mist", "both": as on the command line and in jobs.
const std::vector<std::string>& coolant_names();
const std::string& name_of(Coolant coolant);
std::optional<Coolant> coolant_named(const std::string& name);

}  // namespace clearcut::inline model
