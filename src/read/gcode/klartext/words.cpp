#include "read/gcode/klartext/words.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "base/elementary.h"
#include "base/error.h"
#include "base/text.h"
#include "base/units.h"
#include "read/gcode/klartext/formula.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {
namespace {

bool is_number(const std::string& word) {
  return std::all_of(word.begin(), word.end(), is_digit);
}

}  // namespace

Words words_of(std::string_view line) {
  Words found;
  const std::size_t mark = line.find(';');
  if (mark != std::string_view::npos) found.comment = line.substr(mark + 1);
  std::string word;
  for (const char c : line.substr(0, mark)) {
    if (!is_blank(c) && c != '~') {
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    } else if (!word.empty()) {
      found.words.push_back(std::move(word));
      word.clear();
    }
  }
  if (!word.empty()) found.words.push_back(std::move(word));
  if (!found.words.empty() && is_number(found.words[0])) found.words.erase(found.words.begin());
  return found;
}

bool is_klartext(std::string_view text) {
  Lines lines(text);
  std::string_view line;
  while (lines.next(line)) {
    const Words found = words_of(line);
    if (!found.words.empty())
      return found.words.size() > 1 && found.words[0] == "BEGIN" && found.words[1] == "PGM";
  }
  return false;
}

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
    if (word == "R" || word == "M") return;  // asked for and left empty, as older controls write blocks
    if (word == "FMAX") {
      found_.rapid = true;
    } else if (word.rfind("FU", 0) == 0 || word.rfind("FZ", 0) == 0) {
      refuse(word.substr(0, 2) +
             " states the feed for a turn or a tooth, which is not read; post it in mm/min");
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
  for (std::size_t k = 1; k < words.size(); ++k) {
    const bool is_apart = words[k] == "F" && k + 1 < words.size() && words[k + 1] == "MAX";
    collector.add(is_apart ? "FMAX" : words[k]);
    if (is_apart) ++k;
  }
  return collector.take();
}

namespace {

constexpr int kDigitsOfValues = 9;

[[noreturn]] void refuse_fn(const std::string& place, const std::string& what) {
  throw InputError(place, what);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word;
  return text;
}

int count_at(const std::string& text, std::size_t& at, const std::string& place) {
  const std::size_t begin = at;
  while (at < text.size() && is_digit(text[at])) ++at;
  if (at == begin || at - begin > 6) refuse_fn(place, "a number is missing in an FN block; correct it");
  return std::atoi(text.substr(begin, at - begin).c_str());
}

bool skip_text(const std::string& text, std::size_t& at, std::string_view word) {
  if (text.compare(at, word.size(), word) != 0) return false;
  at += word.size();
  return true;
}

/// degrees, from 0 to below 360.
double angle_of_sides(double opposite, double adjacent) {
  const double angle = base::atan2(opposite, adjacent) * 180 / kPi;
  return angle < 0 ? angle + 360 : angle;
}

bool compared(int function, double left, double right) {
  switch (function) {
    case 9:
      return left == right;
    case 10:
      return left != right;
    case 11:
      return left > right;
    default:
      return left < right;
  }
}

}  // namespace

double QParameters::value_of(int parameter, const std::string& place) const {
  const auto found = values_.find(parameter);
  if (found == values_.end())
    refuse_fn(place,
              "Q" + std::to_string(parameter) +
                  " is read before the program sets it, and the control keeps old values; set it before");
  return found->second;
}

/// "+Q1", "-3.5", "Q2"
double QParameters::operand(const std::string& text, std::size_t& at, const std::string& place) const {
  double sign = 1;
  while (at < text.size() && (text[at] == '+' || text[at] == '-')) sign = text[at++] == '-' ? -sign : sign;
  if (skip_text(text, at, "Q")) return sign * value_of(count_at(text, at, place), place);
  const std::size_t begin = at;
  while (at < text.size() && (is_digit(text[at]) || text[at] == '.')) ++at;
  if (at == begin || at - begin > 30) refuse_fn(place, "a value is missing in an FN block; correct it");
  return sign * std::strtod(text.substr(begin, at - begin).c_str(), nullptr);
}

/// Behind the equals sign of FN 0 to FN 8 and FN 13.
double QParameters::computed(int function, const std::string& text, std::size_t& at,
                             const std::string& place) const {
  constexpr std::string_view kOf[] = {"SQRT", "SIN", "COS"};
  if (function >= 5 && function <= 7) {
    if (!skip_text(text, at, kOf[function - 5]))
      refuse_fn(place, "FN block without its function; correct it");
    const double of = operand(text, at, place);
    if (function == 5 && of < 0) refuse_fn(place, "the root of a number below zero; correct it");
    return function == 5   ? std::sqrt(of)
           : function == 6 ? base::sin(of * kPi / 180)
                           : base::cos(of * kPi / 180);
  }
  const double first = operand(text, at, place);
  if (function == 0) return first;
  constexpr std::string_view kBetween[] = {"", "+",   "-", "*", "DIV", "", "",
                                           "", "LEN", "",  "",  "",    "", "ANG"};
  if (!skip_text(text, at, kBetween[function])) refuse_fn(place, "FN block without its sign; correct it");
  const double second = operand(text, at, place);
  if (function == 4 && second == 0) refuse_fn(place, "division by zero; correct it");
  switch (function) {
    case 1:
      return first + second;
    case 2:
      return first - second;
    case 3:
      return first * second;
    case 4:
      return first / second;
    case 8:
      return base::hypot(first, second);
    default:
      return angle_of_sides(first, second);
  }
}

FnBlock QParameters::execute(const std::vector<std::string>& words, const std::string& place) {
  const std::string text = joined(words);
  std::size_t at = 2;  // behind FN
  const int function = count_at(text, at, place);
  if (!skip_text(text, at, ":")) refuse_fn(place, "FN block without its ':'; correct it");
  if (function == 14)
    refuse_fn(place,
              "the program stops here with an error of its own (FN 14); what it asks for does not hold");
  if (function > 13)
    refuse_fn(place, "FN " + std::to_string(function) + " is not read; post the program without it");
  if (function < 9 || function == 13) {
    if (!skip_text(text, at, "Q")) refuse_fn(place, "FN block without its Q parameter; correct it");
    const int parameter = count_at(text, at, place);
    if (!skip_text(text, at, "=")) refuse_fn(place, "FN block without its '='; correct it");
    const double value = computed(function, text, at, place);
    if (!(std::abs(value) <= 1e9)) refuse_fn(place, "a value that no control holds; correct it");
    values_[parameter] = value;
    return {};
  }
  constexpr std::string_view kSigns[] = {"EQU", "NE", "GT", "LT"};
  if (!skip_text(text, at, "IF")) refuse_fn(place, "FN block without IF; correct it");
  const double left = operand(text, at, place);
  if (!skip_text(text, at, kSigns[function - 9]))
    refuse_fn(place, "FN block without its comparison; correct it");
  const double right = operand(text, at, place);
  if (!skip_text(text, at, "GOTOLBL")) refuse_fn(place, "FN block without GOTO LBL; correct it");
  FnBlock block;
  if (compared(function, left, right)) block.jump = text.substr(at);
  return block;
}

bool QParameters::assign(const std::vector<std::string>& words, const std::string& place) {
  constexpr int kFirstOfCycleParameters = 200;
  const std::string text = joined(words);
  if (text.size() < 2 || text[0] != 'Q' || !is_digit(text[1])) return false;
  std::size_t at = 1;
  const int parameter = count_at(text, at, place);
  if (parameter >= kFirstOfCycleParameters || !skip_text(text, at, "=")) return false;
  const auto value_in = [&](int number) { return value_of(number, place); };
  const double value = formula_value(std::string_view(text).substr(at), value_in, place);
  if (!(std::abs(value) <= 1e9)) refuse_fn(place, "a value that no control holds; correct it");
  values_[parameter] = value;
  return true;
}

void QParameters::put_values(std::vector<std::string>& words, const std::string& place) const {
  for (std::string& word : words) {
    const std::size_t from = word[0] == 'Q' && word.find('=') != std::string::npos ? word.find('=') : 0;
    const std::size_t q = word.find('Q', from);
    if (q == std::string::npos || q + 1 >= word.size() || !is_digit(word[q + 1])) continue;
    // The name of a cycle's parameter, whose sign of equality stands in the next word.
    const bool is_name = q == 0 && &word != &words.back() && (*(&word + 1))[0] == '=';
    if (is_name) continue;
    std::size_t end = q + 1;
    const double value = value_of(count_at(word, end, place), place);
    if (end != word.size()) refuse_fn(place, "formulas of Q parameters are not read; use FN blocks");
    const bool minus = q > 0 && word[q - 1] == '-';
    const bool has_sign = q > 0 && (minus || word[q - 1] == '+');
    word = word.substr(0, has_sign ? q - 1 : q) + trimmed(minus ? -value : value, kDigitsOfValues);
  }
}

}  // namespace clearcut::read::gcode
