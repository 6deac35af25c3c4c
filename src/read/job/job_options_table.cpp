#include "read/job/job_options_table.h"

#include <fmt/format.h>

#include <utility>

#include "base/error.h"
#include "base/text/format.h"

namespace clearcut::read {
namespace {

/// A number as typed: the shortest text that reads back equal.
std::string typed(double number) {
  return fmt::format("{}", number);
}

/// "1,2,3" of [1, 2, 3], "0.4" of 0.4; nothing for other values.
std::optional<std::string> text_of(const DataValue& value) {
  if (value.is_string()) return value.text;
  if (value.is_number()) return typed(value.number);
  if (!value.is_array() || value.items.empty()) return std::nullopt;
  std::string text;
  for (const DataValue& item : value.items) {
    if (!item.is_number()) return std::nullopt;
    text += (text.empty() ? "" : ",") + typed(item.number);
  }
  return text;
}

std::optional<std::vector<std::string>> texts_of(const DataValue& value) {
  std::vector<std::string> texts;
  if (!value.is_array()) return std::nullopt;
  for (const DataValue& item : value.items) {
    const auto text = text_of(item);
    if (!text) return std::nullopt;
    texts.push_back(*text);
  }
  return texts;
}

const char* expected(ValueKind kind) {
  if (kind == ValueKind::kFlag) return "must be true or false";
  if (takes_several(kind)) return "must be a list, as [\"one\", \"two\"]; of points [[x, y], ...]";
  if (kind == ValueKind::kPoint) return "must be a point, [x, y]";
  return is_number(kind) ? "must be a number" : "must be a text in quotes";
}

Value value_of(const Row& row, const DataValue& value, const std::string& place) {
  if (row.kind == ValueKind::kFlag) {
    if (value.kind == DataValue::Kind::kBoolean) return value.boolean != row.key_is_opposite;
  } else if (!row.flag_names.empty() && value.kind == DataValue::Kind::kBoolean) {
    return row.flag_names[value.boolean ? 1 : 0];
  } else if (takes_several(row.kind)) {
    if (const auto texts = texts_of(value)) return value_of_texts(row, *texts, place);
  } else if (is_number(row.kind) && value.is_number()) {
    check_value(row, value.number, place);
    return value.number;
  } else if (row.kind == ValueKind::kFeed || row.kind == ValueKind::kLength || !is_number(row.kind)) {
    if (const auto text = text_of(value)) return value_of_text(row, *text, place);
  }
  throw InputError(place, expected(row.kind));
}

}  // namespace

void take_options(DataSection& section, JobTable table, OptionsOf which, Asked& asked) {
  for (const Row& row : rows()) {
    if (row.table != table || row.is_of_operations != (which == OptionsOf::kOperations)) continue;
    const std::string key = row.job_key();
    const DataValue* value = section.value(key);
    if (value) row.field.set(asked, value_of(row, *value, section.place_of(key)), row.names);
  }
}

}  // namespace clearcut::read
