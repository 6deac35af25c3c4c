#include "arguments/quantities.h"

#include <clearcut/text.h>

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>

namespace clearcut::cli {
namespace {

constexpr int kDigits = 9;

/// What becomes of the text, or nothing where it is none of its kind.
template <typename Convert>
CLI::Validator converter(Convert convert, const char* expected) {
  return {[convert, expected](std::string& text) {
            const std::optional<std::string> converted = convert(text);
            if (!converted) return "'" + text + "' is not " + expected;
            text = *converted;
            return std::string();
          },
          ""};
}

std::optional<std::string> written(const std::optional<double>& value) {
  if (!value) return std::nullopt;
  return trimmed(*value, kDigits);
}

/// One distance of passes: a fraction, a percentage, a length in mm or inches, or a name.
std::string stepover_of(const std::string& text) {
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

}  // namespace

CLI::Validator as_length() {
  return converter([](const std::string& text) { return written(length_in_mm(text)); },
                   "a length; write 6, 6mm or 0.25in");
}

CLI::Validator as_feed() {
  return converter([](const std::string& text) { return written(feed_in_mm_per_min(text)); },
                   "a feed; write 800, 800mm/min or 40in/min");
}

CLI::Validator as_stepover() {
  return converter(
      [](const std::string& text) {
        std::string all;
        for (const auto& one : split(text, ',')) all += (all.empty() ? "" : ",") + stepover_of(one);
        return std::optional(all);
      },
      "a stepover");
}

CLI::Validator is_seed() {
  return {[](const std::string& text) {
            std::uint64_t seed = 0;
            const char* end = text.data() + text.size();
            const auto [next, error] = std::from_chars(text.data(), end, seed);
            if (error == std::errc{} && next == end) return std::string();
            return "'" + text + "' is not a seed; write a whole number from 0 to 18446744073709551615";
          },
          ""};
}

}  // namespace clearcut::cli
