// Stores a row's value in its place in the options and loads it again.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "options/row.h"

namespace clearcut::inline options {

/// The position of `name` in `names`, which must contain the name.
inline std::size_t position_of(const std::string& name, const std::vector<std::string>& names) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

// One `store` and one `load` for each type of place. The row's names of choices are in the order of the enumeration.

inline void store(bool& place, const Value& value, const std::vector<std::string>& names) {
  place = std::holds_alternative<bool>(value) ? std::get<bool>(value)
                                              : position_of(std::get<std::string>(value), names) == 1;
}
inline void store(double& place, const Value& value, const std::vector<std::string>&) {
  place = std::get<double>(value);
}
inline void store(int& place, const Value& value, const std::vector<std::string>&) {
  place = static_cast<int>(std::get<double>(value));
}
inline void store(long long& place, const Value& value, const std::vector<std::string>&) {
  place = static_cast<long long>(std::get<double>(value));
}
inline void store(std::uint64_t& place, const Value& value, const std::vector<std::string>&) {
  const auto& text = std::get<std::string>(value);
  std::from_chars(text.data(), text.data() + text.size(), place);
}
inline void store(MmPerMin& place, const Value& value, const std::vector<std::string>&) {
  place = MmPerMin::of(std::get<double>(value));
}
inline void store(Seconds& place, const Value& value, const std::vector<std::string>&) {
  place = Seconds::of(std::get<double>(value));
}
inline void store(Radians& place, const Value& value, const std::vector<std::string>&) {
  place = Radians::of_degrees(std::get<double>(value));
}
inline void store(std::string& place, const Value& value, const std::vector<std::string>&) {
  place = std::get<std::string>(value);
}
inline void store(Vec2& place, const Value& value, const std::vector<std::string>&) {
  place = std::get<Vec2>(value);
}
inline void store(std::vector<Vec2>& place, const Value& value, const std::vector<std::string>&) {
  place = std::get<std::vector<Vec2>>(value);
}
/// Lists grow: the command's come after the job's.
inline void store(std::vector<std::string>& place, const Value& value, const std::vector<std::string>&) {
  const auto& more = std::get<std::vector<std::string>>(value);
  place.insert(place.end(), more.begin(), more.end());
}
template <typename Enum>
requires std::is_enum_v<Enum>
void store(Enum& place, const Value& value, const std::vector<std::string>& names) {
  place = static_cast<Enum>(position_of(std::get<std::string>(value), names));
}
template <typename Type>
void store(std::optional<Type>& place, const Value& value, const std::vector<std::string>& names) {
  store(place.emplace(), value, names);
}

inline std::optional<Value> load(bool place, const std::vector<std::string>& names) {
  return names.empty() ? Value(place) : Value(names[place ? 1 : 0]);
}
inline std::optional<Value> load(double place, const std::vector<std::string>&) {
  return Value(place);
}
inline std::optional<Value> load(int place, const std::vector<std::string>&) {
  return Value(static_cast<double>(place));
}
inline std::optional<Value> load(long long place, const std::vector<std::string>&) {
  return Value(static_cast<double>(place));
}
inline std::optional<Value> load(std::uint64_t place, const std::vector<std::string>&) {
  return Value(std::to_string(place));
}
inline std::optional<Value> load(MmPerMin place, const std::vector<std::string>&) {
  return Value(place.mm_per_min());
}
inline std::optional<Value> load(Seconds place, const std::vector<std::string>&) {
  return Value(place.seconds());
}
inline std::optional<Value> load(Radians place, const std::vector<std::string>&) {
  return Value(place.degrees());
}
inline std::optional<Value> load(const std::string& place, const std::vector<std::string>&) {
  return place.empty() ? std::nullopt : std::optional<Value>(place);
}
inline std::optional<Value> load(Vec2 place, const std::vector<std::string>&) {
  return Value(place);
}
inline std::optional<Value> load(const std::vector<Vec2>& place, const std::vector<std::string>&) {
  return place.empty() ? std::nullopt : std::optional<Value>(place);
}
inline std::optional<Value> load(const std::vector<std::string>& place, const std::vector<std::string>&) {
  return place.empty() ? std::nullopt : std::optional<Value>(place);
}
template <typename Enum>
requires std::is_enum_v<Enum> std::optional<Value> load(Enum place, const std::vector<std::string>& names) {
  return Value(names[static_cast<std::size_t>(place)]);
}
template <typename Type>
std::optional<Value> load(const std::optional<Type>& place, const std::vector<std::string>& names) {
  return place ? load(*place, names) : std::nullopt;
}

/// The field at the place in the options returned by `Get`, a lambda without captures.
template <typename Get>
Field field(Get, bool is_of_plan) {
  return {is_of_plan,
          [](Asked& asked, const Value& value, const std::vector<std::string>& names) {
            store(Get{}(asked), value, names);
          },
          [](const Asked& asked, const std::vector<std::string>& names) { return load(Get{}(asked), names); },
          [](Asked& asked) { Get{}(asked) = Get{}(Asked{}); }};
}

}  // namespace clearcut::inline options
