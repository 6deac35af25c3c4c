#include "model/options/post_options.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "base/text.h"

namespace clearcut::inline model {

std::optional<EndPosition> end_position_named(std::string_view text) {
  if (text == "home") return EndPosition{EndPosition::Kind::kHome, {}};
  if (text == "none") return EndPosition{EndPosition::Kind::kStay, {}};
  const std::size_t comma = std::min(text.find(','), text.size());
  const auto x = plain_number(text.substr(0, comma)),
             y = plain_number(text.substr(std::min(comma + 1, text.size())));
  if (!x || !y) return std::nullopt;
  return EndPosition{EndPosition::Kind::kPlace, {*x, *y}};
}

std::string name_of(const EndPosition& end) {
  if (end.kind == EndPosition::Kind::kHome) return "home";
  if (end.kind == EndPosition::Kind::kStay) return "none";
  if (end.kind == EndPosition::Kind::kUsual) return "";
  return trimmed(end.place.x, 6) + "," + trimmed(end.place.y, 6);
}

namespace {

struct Named {
  std::string_view word;
  int code;
};

constexpr std::array kPlain{Named{"G54", 540},   Named{"G55", 550},   Named{"G56", 560},
                            Named{"G57", 570},   Named{"G58", 580},   Named{"G59", 590},
                            Named{"G59.1", 591}, Named{"G59.2", 592}, Named{"G59.3", 593}};
/// Before a number.
constexpr std::array kNumbered{Named{"G54.1P", 541}, Named{"G59P", 590}, Named{"G154P", 1540},
                               Named{"G15H", kOkumaOffset}};

std::string g_word(int code) {
  const std::string whole = "G" + std::to_string(code / 10);
  return code % 10 == 0 ? whole : whole + "." + std::to_string(code % 10);
}

}  // namespace

std::string words_of(const WorkOffset& offset) {
  const char* const letter = offset.code == kOkumaOffset ? " H" : " P";
  return g_word(offset.code) + (offset.number > 0 ? letter + std::to_string(offset.number) : "");
}

std::string condition_of(const WorkOffset& offset) {
  std::string name = "g" + g_word(offset.code).substr(1);
  if (offset.number > 0) name += (offset.code == kOkumaOffset ? "-h" : "-p") + std::to_string(offset.number);
  return name;
}

std::optional<WorkOffset> work_offset_named(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (!std::isspace(byte)) plain += static_cast<char>(std::toupper(byte));
  }
  for (const Named& one : kPlain)
    if (plain == one.word) return WorkOffset{one.code, 0};
  if (plain.size() == 4 && plain.starts_with("G5")) {
    int number = 0;
    const char* const end = plain.data() + plain.size();
    const auto [stopped, error] = std::from_chars(plain.data() + 1, end, number);
    const bool is_settable = number * 10 >= kFirstSettable && number * 10 <= kLastSettable;
    if (error == std::errc{} && stopped == end && is_settable) return WorkOffset{number * 10, 0};
  }
  for (const Named& one : kNumbered) {
    if (!plain.starts_with(one.word)) continue;
    WorkOffset offset{one.code, 0};
    const char* const end = plain.data() + plain.size();
    const auto [stopped, error] = std::from_chars(plain.data() + one.word.size(), end, offset.number);
    if (error == std::errc{} && stopped == end && offset.number > 0) return offset;
  }
  return std::nullopt;
}

}  // namespace clearcut::inline model
