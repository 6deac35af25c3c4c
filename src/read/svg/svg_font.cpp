#include "read/svg/svg_font.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/text.h"
#include "read/common/text.h"
#include "read/svg/svg_numbers.h"

namespace clearcut::read {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 7> kSizes{{{"xx-small", 9},
                                                                     {"x-small", 10},
                                                                     {"small", 13},
                                                                     {"medium", 16},
                                                                     {"large", 18},
                                                                     {"x-large", 24},
                                                                     {"xx-large", 32}}};
constexpr double kLarger = 1.2;

/// "1.5em", "50%", "12px", "large", in user units.
std::optional<double> font_size(std::string_view text, double outer) {
  for (const auto& [name, size] : kSizes)
    if (text == name) return size;
  if (text == "larger") return outer * kLarger;
  if (text == "smaller") return outer / kLarger;
  const std::vector<double> sizes = svg_lengths(text, outer, outer);
  return sizes.size() == 1 && sizes[0] >= 0 ? std::optional(sizes[0]) : std::nullopt;
}

bool is_bold(std::string_view weight) {
  constexpr double kSemibold = 600;
  return weight == "bold" || weight == "bolder" || SvgScanner(weight).number().value_or(0) >= kSemibold;
}

bool is_italic(std::string_view style) {
  return style.starts_with("italic") || style.starts_with("oblique");
}

/// Values that do not change letters.
bool says_nothing(std::string_view value) {
  constexpr std::array<std::string_view, 14> kNothing = {
      "normal", "auto", "baseline",  "alphabetic", "0",          "0px",        "0%",
      "100%",   "ltr",  "no-change", "reset-size", "use-script", "horizontal", "0em"};
  return value.starts_with("none") || std::find(kNothing.begin(), kNothing.end(), value) != kNothing.end();
}

/// `font: italic bold 12px/30px Georgia, serif`.
void set_all(SvgFont& font, std::string_view value) {
  font.bold = font.italic = false;
  while (!value.empty()) {
    const std::size_t end = std::min(value.find(' '), value.size());
    std::string_view word = value.substr(0, end);
    value = stripped(value.substr(end));
    if (is_italic(word)) {
      font.italic = true;
    } else if (is_bold(word)) {
      font.bold = true;
    } else if (const auto size = font_size(word.substr(0, word.find('/')), font.outer_size);
               size && !(SvgScanner(word).number() && word.find_first_not_of("0123456789") == word.npos)) {
      font.size = *size;
      return font.set("font-family", value);
    }
  }
}

}  // namespace

std::vector<double> svg_lengths(std::string_view text, double whole, double em) {
  std::vector<double> lengths;
  constexpr std::string_view kBetween = " ,\t\r\n";
  while (!(text = stripped(text, kBetween)).empty()) {
    const std::size_t end = std::min(text.find_first_of(kBetween), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    const auto value = SvgScanner(word).number();
    const bool of_em = word.ends_with("em"), of_ex = word.ends_with("ex");
    const auto length =
        value && (of_em || of_ex) ? std::optional(*value * em * (of_ex ? 0.5 : 1)) : svg_length(word, whole);
    if (!length) break;
    lengths.push_back(*length);
  }
  return lengths;
}

void SvgFont::set(std::string_view property, std::string_view value) {
  if (value.empty() || value == "inherit") return;
  if (property == "font") return set_all(*this, value);
  if (property == "font-family") {
    families.clear();
    for (const std::string& one : split(std::string(value), ',')) {
      const std::string_view name = stripped(one, " \t\r\n\"'");
      if (!name.empty()) families.emplace_back(name);
    }
  } else if (property == "font-size") {
    const auto found = font_size(value, outer_size);
    problem = found ? "" : "font-size '" + printable(value) + "' is not understood; write it in px or mm";
    size = found.value_or(size);
  } else if (property == "font-weight") {
    bold = is_bold(value);
  } else if (property == "font-style") {
    italic = is_italic(value);
  } else if (property == "text-anchor") {
    anchor = value;
  } else if (property == "letter-spacing") {
    spacing = value;
  } else if (property == "writing-mode") {
    vertical = value.starts_with("tb") || value.starts_with("vertical");
  } else if (property == "white-space" || property == "xml:space") {
    keeps_space = value.starts_with("pre") || value == "break-spaces";
  } else if (std::find(std::begin(kSvgFontProperties), std::end(kSvgFontProperties), property) !=
             std::end(kSvgFontProperties)) {
    if (says_nothing(value)) {
      not_applied.erase(std::string(property));
    } else {
      not_applied.emplace(property);
    }
  }
}

}  // namespace clearcut::read
