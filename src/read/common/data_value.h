// JSON and TOML with the line of every value, for messages with a place.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/vec2.h"

namespace clearcut::read {

struct DataMember;

/// One value of a JSON or TOML text; members and items keep the order of the text.
struct DataValue {
  enum class Kind { kNull, kBoolean, kNumber, kString, kArray, kObject };
  Kind kind = Kind::kNull;
  int line = 0;
  bool boolean = false;
  double number = 0;
  std::string text;
  std::vector<DataValue> items;
  std::vector<DataMember> members;

  bool is_array() const { return kind == Kind::kArray; }
  bool is_object() const { return kind == Kind::kObject; }
  bool is_number() const { return kind == Kind::kNumber; }
  bool is_string() const { return kind == Kind::kString; }
  /// The member called `key`, or null. Of several members the last one.
  const DataValue* find(std::string_view key) const;
};

/// A value and its key.
struct DataMember {
  std::string key;
  DataValue value;
};

/// Throws  InputError "file:line: ..." for text that is not JSON, or nested deeper than 64.
/// Cost    O(length).
DataValue parse_json(std::string_view text, const std::string& file_name);
/// The same for TOML. Dates and times are refused.
DataValue parse_toml(std::string_view text, const std::string& file_name);

/// A table in which every key must be used: unused keys are spelling mistakes.
class DataSection {
 public:
  /// `name` is used in messages: "[stock]". Throws InputError unless `table` is an object.
  DataSection(const DataValue& table, std::string file, std::string name);

  bool has(const std::string& key) { return ask(key) != nullptr; }
  /// The value unchanged, null if there is none.
  const DataValue* value(const std::string& key) { return ask(key); }
  /// "file:line: key", if the key has a value.
  std::string place_of(const std::string& key);
  std::optional<double> number(const std::string& key);
  /// A number above zero.
  std::optional<double> positive(const std::string& key);
  /// A number of zero or more.
  std::optional<double> not_negative(const std::string& key);
  std::optional<std::string> text(const std::string& key);
  std::optional<bool> flag(const std::string& key);
  /// [low, high] with low < high.
  std::optional<std::array<double, 2>> range(const std::string& key);
  /// [x, y].
  std::optional<std::array<double, 2>> pair(const std::string& key);
  /// [[x, y], ...].
  std::vector<Vec2> points(const std::string& key);
  std::vector<std::string> texts(const std::string& key);
  std::vector<double> numbers(const std::string& key);
  bool is_number(const std::string& key);
  bool is_flag(const std::string& key);
  bool is_list(const std::string& key);
  std::optional<DataSection> section(const std::string& key);
  std::vector<DataSection> sections(const std::string& key);
  /// One of `names`, by its place; throws listing them.
  std::optional<std::size_t> choice(const std::string& key, const std::vector<std::string>& names);

  /// Throws  InputError for the first unused key, with the nearest used one.
  void refuse_unknown() const;
  [[noreturn]] void fail(const std::string& what) const;
  [[noreturn]] void fail_at(const std::string& key, const std::string& what) const;
  int line() const { return table_->line; }

 private:
  const DataValue* ask(const std::string& key);
  const DataValue* table_;
  std::string file_;
  std::string name_;
  std::vector<std::string> known_;
};

}  // namespace clearcut::read
