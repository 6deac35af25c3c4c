#include "options/row.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>

#include "base/error.h"
#include "base/text.h"

namespace clearcut::inline options {
namespace {

constexpr int kDigits = 9;

[[noreturn]] void refuse(const std::string& place, const std::string& text, const std::string& expected) {
  throw InputError(place, "'" + text + "' is not " + expected);
}

double number_of_text(const Row& row, const std::string& text, const std::string& place) {
  if (row.kind == ValueKind::kLength) {
    if (const auto mm = length_in_mm(text)) return *mm;
    refuse(place, text, "a length; write 6, 6mm or 0.25in");
  }
  if (row.kind == ValueKind::kFeed) {
    if (const auto feed = feed_in_mm_per_min(text)) return *feed;
    refuse(place, text, "a feed; write 800, 800mm/min or 40in/min");
  }
  if (const auto number = plain_number(text)) return *number;
  refuse(place, text, row.kind == ValueKind::kWhole ? "a whole number" : "a number");
}

Vec2 point_of_text(const std::string& text, const std::string& place) {
  const auto words = split(text, ',');
  if (words.size() == 2) {
    const auto x = length_in_mm(words[0]), y = length_in_mm(words[1]);
    if (x && y && std::abs(*x) <= kLongestLength && std::abs(*y) <= kLongestLength) return {*x, *y};
  }
  refuse(place, text, "a point; write X,Y in mm");
}

/// One distance of passes: a fraction, a percentage, a length in mm or inches, or a name.
std::string stepover_of_text(const std::string& text) {
  if (!text.empty() && text.back() == '%') {
    const auto percent = plain_number(text.substr(0, text.size() - 1));
    if (percent) return trimmed(*percent / 100, kDigits);
  }
  if (text.ends_with("in") || text.ends_with("\"")) {
    const auto mm = length_in_mm(text);
    if (mm) return trimmed(*mm, kDigits) + "mm";
  }
  return text;
}

std::string stepovers_of_text(const std::string& text) {
  std::string all;
  for (const auto& one : split(text, ',')) all += (all.empty() ? "" : ",") + stepover_of_text(one);
  return all;
}

std::string seed_of_text(const std::string& text, const std::string& place) {
  std::uint64_t seed = 0;
  const char* end = text.data() + text.size();
  const auto [next, error] = std::from_chars(text.data(), end, seed);
  if (error == std::errc{} && next == end) return text;
  refuse(place, text, "a seed; write a whole number from 0 to 18446744073709551615");
}

void check_number(const Row& row, double value, const std::string& place) {
  if (!std::isfinite(value)) throw InputError(place, "must be a finite number");
  if (row.kind == ValueKind::kWhole && value != std::floor(value))
    throw InputError(place, fmt::format("must be a whole number; it is {}", value));
  const std::string reason = beyond_range(value, row.range, row.counted_in());
  if (!reason.empty()) throw InputError(place, fmt::format("{}; it is {}", reason, value));
}

void check_name(const Row& row, const std::string& name, const std::string& place) {
  if (std::find(row.names.begin(), row.names.end(), name) != row.names.end()) return;
  const std::string meant = nearest_name(name, row.names);
  throw InputError(
      place, fmt::format("'{}' is unknown; {}use one of {}", name,
                         meant.empty() ? "" : "did you mean '" + meant + "'? ", fmt::join(row.names, ", ")));
}

/// Checks a text of a row with a limited set of valid texts.
void check_text(const Row& row, const std::string& text, const std::string& place) {
  if (row.is_known(text)) return;
  constexpr std::size_t kShortWord = 4;  // all words of three letters are near to each other
  const std::string meant = text.size() < kShortWord ? "" : nearest_name(text, row.names);
  throw InputError(place, fmt::format("'{}' is unknown; {}use {}", text,
                                      meant.empty() ? "" : "did you mean '" + meant + "'? ", row.known));
}

}  // namespace

const char* name_of(Group group) {
  static constexpr const char* kNames[] = {
      "Input",           "Solids",           "Drawings",           "Tools",
      "Machine",         "Limits",           "Strategy",           "Entry",
      "Leads and links", "Feeds and speeds", "Rest and finishing", "Copies",
      "Controller",      "Search",           "Published solver"};
  return kNames[static_cast<std::size_t>(group)];
}

const char* name_of(JobTable table) {
  static constexpr const char* kNames[] = {"", "part", "tools", "plan", "machine", "output"};
  return kNames[static_cast<std::size_t>(table)];
}

std::string Row::counted_in() const {
  if (kind == ValueKind::kLength) return "mm";
  return kind == ValueKind::kFeed ? "mm/min" : unit;
}

std::string Row::described() const {
  const std::string counted = counted_in();
  std::string text = sentence;
  if (!counted.empty()) text += ", " + counted;
  return fallback.empty() ? text : text + " (default " + fallback + ")";
}

std::string Row::job_key() const {
  if (!key.empty()) return key;
  std::string out = name;
  std::replace(out.begin(), out.end(), '-', '_');
  return out;
}

std::string Row::shown_example() const {
  if (!example.empty()) return example;
  if (!names.empty()) return names.front();
  if (is_number(kind)) return trimmed(std::max(range.least, 1.0), kDigits);
  return kind == ValueKind::kSeed ? "1" : "";
}

const Row* row_named(const std::string& name) {
  static const std::map<std::string, const Row*> kByName = [] {
    std::map<std::string, const Row*> all;
    for (const Row& row : rows()) all[row.name] = &row;
    return all;
  }();
  const auto found = kByName.find(name);
  return found == kByName.end() ? nullptr : found->second;
}

Value value_of_text(const Row& row, const std::string& text, const std::string& place) {
  Value value;
  if (is_number(row.kind)) {
    value = number_of_text(row, text, place);
  } else if (row.kind == ValueKind::kPoint) {
    value = point_of_text(text, place);
  } else if (row.kind == ValueKind::kSeed) {
    value = seed_of_text(text, place);
  } else {
    value = row.kind == ValueKind::kStepover ? stepovers_of_text(text) : text;
  }
  check_value(row, value, place);
  return value;
}

Value value_of_texts(const Row& row, const std::vector<std::string>& texts, const std::string& place) {
  if (row.kind != ValueKind::kPoints) {
    check_value(row, texts, place);
    return texts;
  }
  std::vector<Vec2> points;
  for (const std::string& text : texts) points.push_back(point_of_text(text, place));
  return points;
}

void check_value(const Row& row, const Value& value, const std::string& place) {
  if (const double* number = std::get_if<double>(&value)) check_number(row, *number, place);
  if (row.kind == ValueKind::kChoice) check_name(row, std::get<std::string>(value), place);
  if (!row.is_known) return;
  if (const auto* texts = std::get_if<std::vector<std::string>>(&value)) {
    for (const std::string& text : *texts) check_text(row, text, place);
  } else {
    check_text(row, std::get<std::string>(value), place);
  }
}

void check_values(const Asked& asked, const std::string& prefix) {
  for (const Row& row : rows()) {
    if (!row.field.get) continue;
    const auto value = row.field.get(asked, row.names);
    if (value) check_value(row, *value, prefix + row.name);
  }
}

}  // namespace clearcut::inline options
