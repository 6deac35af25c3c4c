#include "read/gcode/klartext/path_words.h"

#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "read/gcode/klartext/words.h"

namespace clearcut::read::gcode {
namespace {

constexpr double kLargestNumber = 1e6;

class Collector {
 public:
  Collector(const KlartextScale& scale, const ToolpathBuilder& builder, int line)
      : scale_(scale), builder_(builder), line_(line) {}

  void add(const std::string& word) {
    const auto rest = [&](std::size_t skip) { return number(std::string_view(word).substr(skip)); };
    if (word == "R0" || word == "RL" || word == "RR") {
      found_.compensation = word == "R0"   ? PathWords::Radius::kNone
                            : word == "RL" ? PathWords::Radius::kLeft
                                           : PathWords::Radius::kRight;
      return;
    }
    if (word == "FMAX") {
      found_.rapid = true;
    } else if (word == "FAUTO") {
      found_.feed_of_tool = true;
    } else if (word == "DR+" || word == "DR-") {
      found_.turn = word == "DR+" ? Turn::kCounterClockwise : Turn::kClockwise;
    } else if (word.rfind("IPA", 0) == 0) {
      found_.polar_step = rest(3);
    } else if (word.rfind("PA", 0) == 0) {
      found_.polar_angle = rest(2);
    } else if (word.rfind("PR", 0) == 0) {
      found_.polar_radius = rest(2) * scale_.unit;
    } else if (word[0] >= 'X' && word[0] <= 'Z') {
      found_.absolute[static_cast<std::size_t>(word[0] - 'X')] =
          rest(1) * scale_.unit + (word[0] == 'Z' ? scale_.longer : 0);
    } else if (word.size() > 1 && word[0] == 'I' && word[1] >= 'X' && word[1] <= 'Z') {
      found_.incremental[static_cast<std::size_t>(word[1] - 'X')] = rest(2) * scale_.unit;
    } else if (word[0] == 'R') {
      found_.radius = rest(1) * scale_.unit;
    } else if (word[0] == 'F') {
      found_.feed = rest(1) * feed_unit(scale_.unit);
    } else if (found_.retract && (word.rfind("MB", 0) == 0 || word == "MAX")) {
      if (word.size() > 2 && word.find("MAX") == std::string::npos) found_.retract = rest(2) * scale_.unit;
    } else if (word[0] == 'M') {
      const int m = static_cast<int>(rest(1));
      found_.machine_frame = found_.machine_frame || m == 91 || m == 92;
      if (m == 140) {
        found_.retract = HUGE_VAL;
      } else {
        found_.m.push_back(m);
      }
    } else {
      refuse("word '" + word.substr(0, 20) + "' is not read; post the program without it");
    }
  }

  PathWords take() { return std::move(found_); }

 private:
  double number(std::string_view text) const { return number_in(text, builder_, line_); }
  [[noreturn]] void refuse(const std::string& what) const { throw InputError(builder_.place(line_), what); }

  KlartextScale scale_;
  const ToolpathBuilder& builder_;
  int line_;
  PathWords found_;
};

}  // namespace

double number_in(std::string_view text, const ToolpathBuilder& builder, int line) {
  std::string_view digits = text;
  if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
  const bool plain = !digits.empty() && (is_digit(digits.back()) || digits.back() == '.') &&
                     (is_digit(digits.front()) || digits.front() == '-' || digits.front() == '.');
  double value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed);
  const auto refuse = [&](const std::string& what) { throw InputError(builder.place(line), what); };
  if (!plain || error != std::errc{} || end != digits.data() + digits.size()) {
    refuse("'" + std::string(text.substr(0, 20)) +
           "' is no plain number (Q parameters are not read); correct it");
  }
  if (!(std::abs(value) <= kLargestNumber)) refuse("number no machine takes; correct it");
  return value;
}

PathWords path_words(const std::vector<std::string>& words, const KlartextScale& scale,
                     const ToolpathBuilder& builder, int line) {
  Collector collector(scale, builder, line);
  for (std::size_t k = 1; k < words.size(); ++k) collector.add(words[k]);
  return collector.take();
}

}  // namespace clearcut::read::gcode
