// JSON with the line of every value, so that a message can say where.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace clearcut {

/// One JSON value; members and items keep the order of the text.
struct JsonValue {
  enum class Kind { kNull, kBoolean, kNumber, kString, kArray, kObject };
  Kind kind = Kind::kNull;
  int line = 0;
  bool boolean = false;
  double number = 0;
  std::string text;
  std::vector<JsonValue> items;
  std::vector<std::pair<std::string, JsonValue>> members;

  bool is_array() const { return kind == Kind::kArray; }
  bool is_object() const { return kind == Kind::kObject; }
  bool is_number() const { return kind == Kind::kNumber; }
  bool is_string() const { return kind == Kind::kString; }
  /// The member called `key`, or null. Of several the last, as everywhere.
  const JsonValue* find(std::string_view key) const;
};

/// Throws InputError "file:line: ..." for text that is not JSON, or nested deeper than 64.
/// Cost O(length).
JsonValue parse_json(std::string_view text, const std::string& file_name);

}  // namespace clearcut
