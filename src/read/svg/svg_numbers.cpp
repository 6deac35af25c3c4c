#include "read/svg/svg_numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "base/elementary.h"
#include "base/units.h"
#include "read/common/text.h"

namespace clearcut::read {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// One function of a transform list; nothing when the name or the count of numbers is wrong.
std::optional<Affine> transform_named(std::string_view name, const std::vector<double>& n) {
  const double degree = kPi / 180;
  if (name == "matrix" && n.size() == 6) return Affine{n[0], n[1], n[2], n[3], n[4], n[5]};
  if (name == "translate" && n.size() == 1) return Affine::translation({n[0], 0});
  if (name == "translate" && n.size() == 2) return Affine::translation({n[0], n[1]});
  if (name == "translateX" && n.size() == 1) return Affine::translation({n[0], 0});
  if (name == "translateY" && n.size() == 1) return Affine::translation({0, n[0]});
  if (name == "scaleX" && n.size() == 1) return Affine::scaling(n[0], 1);
  if (name == "scaleY" && n.size() == 1) return Affine::scaling(1, n[0]);
  if (name == "scale" && n.size() == 1) return Affine::scaling(n[0], n[0]);
  if (name == "scale" && n.size() == 2) return Affine::scaling(n[0], n[1]);
  if (name == "rotate" && n.size() == 1) return Affine::rotation(n[0] * degree);
  if (name == "rotate" && n.size() == 3) {
    return Affine::translation({n[1], n[2]}) * Affine::rotation(n[0] * degree) *
           Affine::translation({-n[1], -n[2]});
  }
  if (name == "skewX" && n.size() == 1) return Affine{1, 0, base::tan(n[0] * degree), 1, 0, 0};
  if (name == "skewY" && n.size() == 1) return Affine{1, base::tan(n[0] * degree), 0, 1, 0, 0};
  return std::nullopt;
}

/// Degrees or user units for a unit in a transform.
std::optional<double> transform_unit(std::string_view unit) {
  if (unit == "deg") return 1;
  if (unit == "rad") return 180 / kPi;
  if (unit == "grad") return 0.9;
  if (unit == "turn") return 360;
  return px_per_unit(unit);
}

/// Powers of ten beyond are no double: only zeros are written with such.
constexpr int kGreatestPower = 400;

/// How `number`, which is a valid one, was written.
Written written_as(std::string_view number) {
  const std::size_t exponent_at = number.find_first_of("eE");
  int last_power = 0;
  if (exponent_at != std::string_view::npos) {
    std::string_view exponent = number.substr(exponent_at + 1);
    if (exponent.front() == '+') exponent.remove_prefix(1);
    std::from_chars(exponent.data(), exponent.data() + exponent.size(), last_power);
    last_power = std::clamp(last_power, -kGreatestPower, kGreatestPower);
  }
  Written written;
  bool behind_point = false;
  for (const char c : number.substr(0, exponent_at)) {
    if (c == '.') behind_point = true;
    if (c < '0' || c > '9') continue;
    if (behind_point) --last_power;
    if (c != '0' || written.significant_digits > 0) ++written.significant_digits;
  }
  written.place = base::pow(10.0, last_power);
  return written;
}

}  // namespace

void SvgScanner::skip_space() {
  bool comma = false;
  while (at_ < text_.size() && (is_space(text_[at_]) || (text_[at_] == ',' && !comma))) {
    comma = comma || text_[at_] == ',';
    ++at_;
  }
}

bool SvgScanner::at_end() {
  skip_space();
  return at_ >= text_.size();
}

char SvgScanner::peek() {
  return at_end() ? '\0' : text_[at_];
}

std::optional<double> SvgScanner::number() {
  if (at_end()) return std::nullopt;
  const std::size_t start = at_ + (text_[at_] == '+' ? 1 : 0);
  const char first = start < text_.size() ? text_[start] : '\0';
  // Only digits, sign and point begin a number: from_chars would also take "inf" and "nan".
  if (!(first >= '0' && first <= '9') && first != '.' && !(first == '-' && start == at_)) return std::nullopt;
  if (first == '-' && (start + 1 >= text_.size() || is_letter(text_[start + 1]))) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(text_.data() + start, text_.data() + text_.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  at_ = static_cast<std::size_t>(end - text_.data());
  written_ = written_as(text_.substr(start, at_ - start));
  return value;
}

std::optional<bool> SvgScanner::flag() {
  const char c = peek();
  if (c != '0' && c != '1') return std::nullopt;
  ++at_;
  return c == '1';
}

std::string_view SvgScanner::word() {
  if (at_end()) return {};
  const std::size_t start = at_;
  while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
  return text_.substr(start, at_ - start);
}

std::optional<double> px_per_unit(std::string_view unit) {
  if (unit.empty()) return 1;
  const auto mm = mm_per_unit(unit);
  if (!mm) return std::nullopt;
  return *mm / (25.4 / 96);
}

std::optional<double> svg_length(std::string_view text, double whole) {
  SvgScanner scanner(text);
  const auto value = scanner.number();
  if (!value) return std::nullopt;
  if (scanner.peek() == '%') return *value * whole / 100;
  const auto unit = px_per_unit(scanner.word());
  if (!unit || !scanner.at_end()) return std::nullopt;
  return *value * *unit;
}

std::optional<double> svg_plain_length(std::string_view text) {
  if (text.find('%') != std::string_view::npos) return std::nullopt;
  if (SvgScanner(text).at_end()) return 0;
  return svg_length(text, 0);
}

std::optional<Affine> svg_transform(std::string_view text) {
  Affine whole;
  SvgScanner scanner(text);
  while (!scanner.at_end()) {
    const std::string_view name = scanner.word();
    if (name == "none" && scanner.at_end()) return whole;
    if (scanner.peek() != '(') return std::nullopt;
    scanner.skip();
    std::vector<double> numbers;
    while (const auto number = scanner.number()) {
      const auto unit = transform_unit(scanner.word());
      if (!unit) return std::nullopt;
      numbers.push_back(*number * *unit);
    }
    if (scanner.peek() != ')') return std::nullopt;
    scanner.skip();
    const auto one = transform_named(name, numbers);
    if (!one) return std::nullopt;
    whole = whole * *one;
  }
  return whole;
}

}  // namespace clearcut::read
