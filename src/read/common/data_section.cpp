#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "read/common/data_value.h"
#include "read/common/text.h"

namespace clearcut::read {
namespace {

/// Insertions, deletions and changes from one word to the other.
std::size_t edits_between(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t k = 0; k <= b.size(); ++k) row[k] = k;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const std::size_t change = diagonal + (a[i - 1] == b[k - 1] ? 0 : 1);
      diagonal = row[k];
      row[k] = std::min({row[k] + 1, row[k - 1] + 1, change});
    }
  }
  return row.back();
}

bool is_pair(const DataValue& value) {
  if (!value.is_array() || value.items.size() != 2) return false;
  return std::all_of(value.items.begin(), value.items.end(),
                     [](const DataValue& item) { return item.is_number() && std::isfinite(item.number); });
}

}  // namespace

const DataValue* DataValue::find(std::string_view key) const {
  for (auto member = members.rbegin(); member != members.rend(); ++member) {
    if (member->key == key) return &member->value;
  }
  return nullptr;
}

DataSection::DataSection(const DataValue& table, std::string file, std::string name)
    : table_(&table), file_(std::move(file)), name_(std::move(name)) {
  if (!table.is_object()) fail("must be a table of keys and values");
}

void DataSection::fail(const std::string& what) const {
  throw InputError(file_ + ":" + std::to_string(table_->line), name_ + (name_.empty() ? "" : ": ") + what);
}

void DataSection::fail_at(const std::string& key, const std::string& what) const {
  const DataValue* value = table_->find(key);
  throw InputError(file_ + ":" + std::to_string(value ? value->line : table_->line), key + " " + what);
}

const DataValue* DataSection::ask(const std::string& key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
  return table_->find(key);
}

std::string DataSection::place_of(const std::string& key) {
  const DataValue* value = ask(key);
  return file_ + ":" + std::to_string(value ? value->line : table_->line) + ": " + key;
}

std::optional<double> DataSection::number(const std::string& key) {
  const DataValue* value = ask(key);
  if (!value) return std::nullopt;
  if (!value->is_number() || !std::isfinite(value->number)) fail_at(key, "must be a number");
  return value->number;
}

std::optional<double> DataSection::positive(const std::string& key) {
  const auto value = number(key);
  if (value && !(*value > 0)) fail_at(key, "must be above 0");
  return value;
}

std::optional<double> DataSection::not_negative(const std::string& key) {
  const auto value = number(key);
  if (value && !(*value >= 0)) fail_at(key, "must not be below 0");
  return value;
}

std::optional<std::string> DataSection::text(const std::string& key) {
  const DataValue* value = ask(key);
  if (!value) return std::nullopt;
  if (!value->is_string()) fail_at(key, "must be text in quotes");
  return value->text;
}

std::optional<bool> DataSection::flag(const std::string& key) {
  const DataValue* value = ask(key);
  if (!value) return std::nullopt;
  if (value->kind != DataValue::Kind::kBoolean) fail_at(key, "must be true or false");
  return value->boolean;
}

std::optional<std::array<double, 2>> DataSection::range(const std::string& key) {
  const DataValue* value = ask(key);
  if (!value) return std::nullopt;
  if (!is_pair(*value) || !(value->items[0].number < value->items[1].number))
    fail_at(key, "must be [low, high] with low < high");
  return std::array<double, 2>{value->items[0].number, value->items[1].number};
}

std::optional<std::array<double, 2>> DataSection::pair(const std::string& key) {
  const DataValue* value = ask(key);
  if (!value) return std::nullopt;
  if (!is_pair(*value)) fail_at(key, "must be two numbers: [x, y]");
  return std::array<double, 2>{value->items[0].number, value->items[1].number};
}

std::vector<Vec2> DataSection::points(const std::string& key) {
  const DataValue* value = ask(key);
  if (!value) return {};
  std::vector<Vec2> out;
  if (!value->is_array()) fail_at(key, "must be a list of points: [[x, y], [x, y]]");
  for (const DataValue& item : value->items) {
    if (!is_pair(item)) fail_at(key, "must be a list of points: [[x, y], [x, y]]");
    out.push_back({item.items[0].number, item.items[1].number});
  }
  return out;
}

std::vector<std::string> DataSection::texts(const std::string& key) {
  const DataValue* value = ask(key);
  if (!value) return {};
  if (value->is_string()) return {value->text};
  std::vector<std::string> out;
  if (!value->is_array()) fail_at(key, "must be text or a list of texts");
  for (const DataValue& item : value->items) {
    if (!item.is_string()) fail_at(key, "must be text or a list of texts");
    out.push_back(item.text);
  }
  return out;
}

std::vector<double> DataSection::numbers(const std::string& key) {
  const DataValue* value = ask(key);
  if (!value) return {};
  std::vector<double> out;
  if (!value->is_array()) fail_at(key, "must be a list of numbers");
  for (const DataValue& item : value->items) {
    if (!item.is_number() || !std::isfinite(item.number)) fail_at(key, "must be a list of numbers");
    out.push_back(item.number);
  }
  return out;
}

bool DataSection::is_list(const std::string& key) {
  const DataValue* value = ask(key);
  return value && value->is_array();
}

bool DataSection::is_number(const std::string& key) {
  const DataValue* value = ask(key);
  return value && value->is_number();
}

bool DataSection::is_flag(const std::string& key) {
  const DataValue* value = ask(key);
  return value && value->kind == DataValue::Kind::kBoolean;
}

std::optional<DataSection> DataSection::section(const std::string& key) {
  const DataValue* value = ask(key);
  if (!value) return std::nullopt;
  return DataSection(*value, file_, "[" + key + "]");
}

std::vector<DataSection> DataSection::sections(const std::string& key) {
  const DataValue* value = ask(key);
  std::vector<DataSection> out;
  if (!value) return out;
  if (!value->is_array()) fail_at(key, "must be a list of tables: [[" + key + "]]");
  for (const DataValue& item : value->items) out.emplace_back(item, file_, "[[" + key + "]]");
  return out;
}

std::optional<std::size_t> DataSection::choice(const std::string& key,
                                               const std::vector<std::string>& names) {
  const auto chosen = text(key);
  if (!chosen) return std::nullopt;
  const auto found = std::find(names.begin(), names.end(), *chosen);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  fail_at(key, "'" + printable(*chosen) + "' is unknown; use one of " + all);
}

void DataSection::refuse_unknown() const {
  for (const DataMember& member : table_->members) {
    const std::string& key = member.key;
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    const auto nearest = std::min_element(known_.begin(), known_.end(), [&](const auto& a, const auto& b) {
      return edits_between(key.substr(0, 40), a) < edits_between(key.substr(0, 40), b);
    });
    const bool close = nearest != known_.end() && edits_between(key.substr(0, 40), *nearest) <= 3;
    throw InputError(file_ + ":" + std::to_string(member.value.line),
                     "unknown key '" + printable(key) + "'" + (name_.empty() ? "" : " in " + name_) + "; " +
                         (close ? "did you mean '" + *nearest + "'?" : "remove it"));
  }
}

}  // namespace clearcut::read
