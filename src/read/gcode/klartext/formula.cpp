#include "read/gcode/klartext/formula.h"

#include <cmath>
#include <cstdlib>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"

namespace clearcut::read::gcode {
namespace {

constexpr double kDegree = kPi / 180;
constexpr double kLargestValue = 1e9;
constexpr int kMostNested = 50;

struct FunctionRow {
  std::string_view name;
  double (*of)(double);
};
/// Longer names before those that they begin with. Values outside of a function's range become no number, which is refused.
constexpr FunctionRow kFunctions[] = {{"SQRT", [](double x) { return std::sqrt(x); }},
                                      {"SQ", [](double x) { return x * x; }},
                                      {"SIN", [](double x) { return base::sin(x * kDegree); }},
                                      {"COS", [](double x) { return base::cos(x * kDegree); }},
                                      {"TAN", [](double x) { return base::tan(x * kDegree); }},
                                      {"ASIN", [](double x) { return base::asin(x) / kDegree; }},
                                      {"ACOS", [](double x) { return base::acos(x) / kDegree; }},
                                      {"ATAN", [](double x) { return base::atan(x) / kDegree; }},
                                      {"LN", [](double x) { return base::log(x); }},
                                      {"LOG", [](double x) { return base::log10(x); }},
                                      {"EXP", [](double x) { return base::exp(x); }},
                                      {"NEG", [](double x) { return -x; }},
                                      {"INT", [](double x) { return std::trunc(x); }},
                                      {"ABS", [](double x) { return std::abs(x); }},
                                      {"FRAC", [](double x) { return x - std::trunc(x); }}};

class Formula {
 public:
  Formula(std::string_view text, const std::function<double(int)>& value_of, const std::string& place)
      : text_(text), value_of_(value_of), place_(place) {}

  double value() {
    const double found = sum();
    if (at_ != text_.size()) refuse();
    return found;
  }

 private:
  bool skip(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }

  double sum() {
    double value = product();
    for (;;) {
      if (skip("+"))
        value += product();
      else if (skip("-"))
        value -= product();
      else
        return value;
    }
  }

  double product() {
    double value = power();
    for (;;) {
      if (skip("*"))
        value = held(value * power());
      else if (skip("/"))
        value = held(value / power());
      else
        return value;
    }
  }

  double power() {
    const std::size_t begin = at_;
    double value = operand();
    // Controls' manuals do not say whether "-2 ^ 2" and "SIN 30 ^ 2" are powers of the sign and the function, too.
    const bool is_plain = begin < text_.size() &&
                          std::string_view("(Q.0123456789").find(text_[begin]) != std::string_view::npos;
    if (!is_plain && at_ < text_.size() && text_[at_] == '^')
      throw InputError(place_, "a power of a sign or a function is not clear; put its base in parentheses");
    while (skip("^")) value = held(base::pow(value, operand()));
    return value;
  }

  double operand() {
    if (++nested_ > kMostNested) throw InputError(place_, "a formula nests too deep; split it");
    const double value = operand_within();
    --nested_;
    return value;
  }

  double operand_within() {
    if (skip("+")) return operand();
    if (skip("-")) return -operand();
    if (skip("(")) {
      const double value = sum();
      if (!skip(")")) throw InputError(place_, "a formula lacks its ')'; close it");
      return value;
    }
    if (skip("PI")) return kPi;
    for (const FunctionRow& row : kFunctions)
      if (skip(row.name)) return held(row.of(operand()));
    if (skip("Q")) return value_of_(static_cast<int>(digits(false)));
    return digits(true);
  }

  double digits(bool point) {
    constexpr std::size_t kMostDigits = 30;
    const std::size_t begin = at_;
    while (at_ < text_.size() && ((text_[at_] >= '0' && text_[at_] <= '9') || (point && text_[at_] == '.')))
      ++at_;
    if (at_ == begin || at_ - begin > (point ? kMostDigits : 6U)) refuse();
    return std::strtod(std::string(text_.substr(begin, at_ - begin)).c_str(), nullptr);
  }

  double held(double value) const {
    if (!(std::abs(value) <= kLargestValue))
      throw InputError(
          place_,
          "a formula has a value that no control holds (a division by zero, a root below zero); correct it");
    return value;
  }

  [[noreturn]] void refuse() const {
    throw InputError(place_,
                     "'" + std::string(text_.substr(at_, 12)) + "' is not read in a formula; use FN blocks");
  }

  std::string_view text_;
  const std::function<double(int)>& value_of_;
  const std::string& place_;
  std::size_t at_ = 0;
  int nested_ = 0;
};

}  // namespace

double formula_value(std::string_view text, const std::function<double(int)>& value_of,
                     const std::string& place) {
  return Formula(text, value_of, place).value();
}

}  // namespace clearcut::read::gcode
