#include "read/gcode/macros/expression.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "base/elementary.h"
#include "base/error.h"
#include "base/units.h"

namespace clearcut::read::gcode {

namespace {

/// Brackets, signs and parameters of parameters within each other; more exhaust the stack.
constexpr int kMostNested = 60;
/// LinuxCNC takes numbers for equal, and for whole, that differ by less.
constexpr double kAlike = 1e-4;

enum OperatorKind : int {
  kPower,
  kTimes,
  kOver,
  kModulo,
  kPlus,
  kMinus,
  kEqual,
  kNotEqual,
  kGreater,
  kGreaterEqual,
  kLess,
  kLessEqual,
  kAnd,
  kOr,
  kXor
};

/// `linuxcnc`, `fanuc`: how strongly the operator binds on that control, the strongest greatest; 0 where the control lacks the operator.
struct OperatorRow {
  std::string_view text;
  OperatorKind kind;
  int linuxcnc, fanuc;
};
constexpr int kCompares = 3;
constexpr OperatorRow kOperators[] = {
    {"**", kPower, 6, 0},   {"*", kTimes, 5, 5},         {"/", kOver, 5, 5},   {"MOD", kModulo, 5, 5},
    {"+", kPlus, 4, 4},     {"-", kMinus, 4, 4},         {"EQ", kEqual, 3, 3}, {"NE", kNotEqual, 3, 3},
    {"GT", kGreater, 3, 3}, {"GE", kGreaterEqual, 3, 3}, {"LT", kLess, 3, 3},  {"LE", kLessEqual, 3, 3},
    {"AND", kAnd, 2, 5},    {"OR", kOr, 2, 4},           {"XOR", kXor, 2, 4}};

enum FunctionKind : int {
  kAbs,
  kAcos,
  kAsin,
  kAtan,
  kCos,
  kExp,
  kFix,
  kFup,
  kLn,
  kRound,
  kSin,
  kSqrt,
  kTan,
  kExists
};

struct FunctionRow {
  std::string_view text;
  FunctionKind kind;
  bool on_linuxcnc;
};
constexpr FunctionRow kFunctions[] = {
    {"ABS", kAbs, true}, {"ACOS", kAcos, true},     {"ASIN", kAsin, true},  {"ATAN", kAtan, true},
    {"COS", kCos, true}, {"EXP", kExp, true},       {"FIX", kFix, true},    {"FUP", kFup, true},
    {"LN", kLn, true},   {"ROUND", kRound, true},   {"SIN", kSin, true},    {"SQRT", kSqrt, true},
    {"TAN", kTan, true}, {"EXISTS", kExists, true}, {"RND", kRound, false}, {"SQR", kSqrt, false}};

/// Half away from zero, and zero without a sign, which ATAN would see.
double rounded(double number) {
  return (number < 0 ? -std::floor(0.5 - number) : std::floor(number + 0.5)) + 0.0;
}

double radians(double degrees) {
  return degrees * kPi / 180;
}
double degrees(double radians) {
  return radians * 180 / kPi;
}

/// The remainder of LinuxCNC is never below zero.
double remainder(double left, double right, MacroStyle style) {
  const double rest = std::fmod(left, right);
  return rest < 0 && style == MacroStyle::kLinuxCnc ? rest + std::abs(right) : rest;
}

/// Fanuc computes AND, OR and XOR bit by bit.
double of_bits(int kind, double left, double right) {
  const auto a = static_cast<std::int64_t>(std::clamp(rounded(left), -2147483648.0, 2147483647.0));
  const auto b = static_cast<std::int64_t>(std::clamp(rounded(right), -2147483648.0, 2147483647.0));
  return static_cast<double>(kind == kAnd ? (a & b) : kind == kOr ? (a | b) : (a ^ b));
}

double of_truth(int kind, double left, double right) {
  const bool a = left != 0, b = right != 0;
  return (kind == kAnd ? a && b : kind == kOr ? a || b : a != b) ? 1 : 0;
}

}  // namespace

int whole_number(double number, const std::string& what, const std::string& place) {
  const double whole = rounded(number);
  if (!(std::abs(number - whole) <= kAlike) || std::abs(whole) > 1e9)
    throw InputError(place, what + " is no whole number; correct it");
  return static_cast<int>(whole);
}

void Expression::refuse(const std::string& what) const {
  throw InputError(place_, what);
}

bool Expression::skip(std::string_view text) {
  if (line_.substr(std::min(at_, line_.size()), text.size()) != text) return false;
  at_ += text.size();
  return true;
}

double Expression::checked(double number) const {
  if (!std::isfinite(number)) refuse("the expression has no finite value; correct it");
  return number;
}

MacroValue Expression::value() {
  if (++depth_ > kMostNested) refuse("the expression nests too deep; split it over several parameters");
  MacroValue result;
  const char c = next();
  const char after = at_ + 1 < line_.size() ? line_[at_ + 1] : '\0';
  const bool is_sign_of_more =
      (c == '+' || c == '-') && after != '.' && !std::isdigit(static_cast<unsigned char>(after));
  if (c == '[') {
    result = bracket();
  } else if (c == '#') {
    ++at_;
    result = parameter();
  } else if (is_sign_of_more) {
    ++at_;
    result = value();
    if (c == '-') result.number = -result.number;
  } else if (c >= 'A' && c <= 'Z') {
    result = function();
  } else {
    result.number = plain_number();
  }
  --depth_;
  result.number = checked(result.number);
  return result;
}

double Expression::plain_number() {
  const std::size_t begin = at_;
  if (next() == '+' || next() == '-') ++at_;
  while (std::isdigit(static_cast<unsigned char>(next())) || next() == '.') ++at_;
  std::string_view digits = line_.substr(begin, at_ - begin);
  if (digits.substr(0, 1) == "+") digits.remove_prefix(1);
  double number = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::fixed);
  if (error != std::errc{} || end != digits.data() + digits.size())
    refuse(digits.empty() ? "a number is missing; correct the line"
                          : "'" + std::string(digits) + "' is no number; correct it");
  return number;
}

int Expression::parameter_number() {
  return whole_number(value().number, "the number of a parameter", place_);
}

std::string Expression::name() {
  const std::size_t close = line_.find('>', at_);
  if (next() != '<' || close == std::string_view::npos || close == at_ + 1)
    refuse("a name in '<' and '>' is missing; correct the line");
  std::string text(line_.substr(at_ + 1, close - at_ - 1));
  at_ = close + 1;
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

MacroValue Expression::parameter() {
  if (next() == '<') {
    if (style_ != MacroStyle::kLinuxCnc) refuse("named parameters are LinuxCNC's; name --dialect linuxcnc");
    return {variables_.named(name()), false};
  }
  return variables_.numbered(parameter_number());
}

MacroValue Expression::bracket() {
  ++at_;
  const MacroValue result = terms(1);
  if (!skip("]")) refuse("an expression lacks its ']'; close it");
  return result;
}

Expression::Operator Expression::peek(std::size_t& length) const {
  const std::string_view rest = line_.substr(std::min(at_, line_.size()));
  for (const OperatorRow& row : kOperators) {
    const int strength = style_ == MacroStyle::kLinuxCnc ? row.linuxcnc : row.fanuc;
    if (strength == 0 || rest.substr(0, row.text.size()) != row.text) continue;
    length = row.text.size();
    return {row.kind, strength};
  }
  return {};
}

/// Operators of one strength count from left to right, powers too.
MacroValue Expression::terms(int weakest) {
  MacroValue left = value();
  int comparisons = 0;
  for (;;) {
    std::size_t length = 0;
    const Operator found = peek(length);
    if (found.strength == 0 || found.strength < weakest) return left;
    if (found.strength == kCompares && style_ == MacroStyle::kFanuc && ++comparisons > 1)
      refuse("two comparisons in one bracket; put each into its own");
    at_ += length;
    if (++depth_ > kMostNested) refuse("the expression nests too deep; split it over several parameters");
    const MacroValue right = terms(found.strength + 1);
    --depth_;
    left = computed(found.kind, left, right);
  }
}

MacroValue Expression::computed(int kind, MacroValue left, MacroValue right) const {
  const double a = left.number, b = right.number;
  const double alike = style_ == MacroStyle::kLinuxCnc ? kAlike : 1e-9;
  switch (kind) {
    case kPower:
      if (a < 0 && std::floor(b) != b) refuse("a number below zero to a power that is no whole number");
      return {checked(base::pow(a, b)), false};
    case kTimes:
      return {checked(a * b), false};
    case kOver:
    case kModulo:
      if (b == 0) refuse("division by zero; correct the expression, or the parameter that it takes");
      return {checked(kind == kOver ? a / b : remainder(a, b, style_)), false};
    case kPlus:
      return {a + b, false};
    case kMinus:
      return {a - b, false};
    case kEqual:
    case kNotEqual: {
      const bool same =
          style_ == MacroStyle::kFanuc && left.is_vacant != right.is_vacant ? false : std::abs(a - b) < alike;
      return {same == (kind == kEqual) ? 1.0 : 0.0, false};
    }
    case kGreater:
      return {a > b ? 1.0 : 0.0, false};
    case kGreaterEqual:
      return {a >= b ? 1.0 : 0.0, false};
    case kLess:
      return {a < b ? 1.0 : 0.0, false};
    case kLessEqual:
      return {a <= b ? 1.0 : 0.0, false};
    default:
      return {style_ == MacroStyle::kLinuxCnc ? of_truth(kind, a, b) : of_bits(kind, a, b), false};
  }
}

MacroValue Expression::function() {
  for (const FunctionRow& row : kFunctions) {
    if (style_ == MacroStyle::kLinuxCnc && !row.on_linuxcnc) continue;
    const std::size_t begin = at_;
    if (!skip(row.text)) continue;
    if (next() != '[') {
      at_ = begin;
      continue;
    }
    if (row.kind == kExists) return existence();
    if (row.kind == kAtan) return {arc_tangent(), false};
    return {applied(row.kind, bracket().number), false};
  }
  refuse("'" + std::string(line_.substr(at_, 6)) + "' is no function of the control; correct it");
}

/// EXISTS[#<name>]
MacroValue Expression::existence() {
  if (!skip("[#")) refuse("EXISTS asks for a named parameter, as in EXISTS[#<name>]");
  const std::string asked = name();
  if (!skip("]")) refuse("EXISTS lacks its ']'; close it");
  return {variables_.exists(asked) ? 1.0 : 0.0, false};
}

/// ATAN[y]/[x], whichever quarter; on Fanuc also ATAN[y,x] and ATAN[slope].
double Expression::arc_tangent() {
  ++at_;
  const double first = terms(1).number;
  const bool has_comma = skip(",");
  if (has_comma && style_ == MacroStyle::kLinuxCnc) refuse("ATAN asks for two brackets, as in ATAN[y]/[x]");
  const double second = has_comma ? terms(1).number : 0;
  if (!skip("]")) refuse("an expression lacks its ']'; close it");
  if (has_comma) return angle_of_sides(first, second);
  if (!skip("/")) {
    if (style_ == MacroStyle::kLinuxCnc) refuse("ATAN asks for two numbers, as in ATAN[y]/[x]");
    return degrees(base::atan(first));
  }
  if (next() != '[') refuse("ATAN asks for two brackets, as in ATAN[y]/[x]");
  return angle_of_sides(first, bracket().number);
}

double Expression::angle_of_sides(double opposite, double adjacent) {
  const double angle = degrees(base::atan2(opposite, adjacent));
  return angle < 0 ? variables_.angle_below_zero(angle) : angle;
}

double Expression::applied(int function, double argument) const {
  const double toward_zero = std::trunc(argument);
  const bool is_linuxcnc = style_ == MacroStyle::kLinuxCnc;
  switch (function) {
    case kAbs:
      return std::abs(argument);
    case kAcos:
    case kAsin:
      if (std::abs(argument) > 1) refuse("no angle has a sine or cosine beyond 1; correct the expression");
      return degrees(function == kAcos ? base::acos(argument) : base::asin(argument));
    case kCos:
      return base::cos(radians(argument));
    case kSin:
      return base::sin(radians(argument));
    case kTan:
      return base::tan(radians(argument));
    case kExp:
      return checked(base::exp(argument));
    case kFix:
      return is_linuxcnc ? std::floor(argument) : toward_zero;
    case kFup:
      return is_linuxcnc || argument >= 0 ? std::ceil(argument) : std::floor(argument);
    case kLn:
      if (!(argument > 0)) refuse("the logarithm of a number that is not above zero; correct the expression");
      return base::log(argument);
    case kSqrt:
      if (argument < 0) refuse("the root of a number below zero; correct the expression");
      return std::sqrt(argument);
    default:
      return rounded(argument);
  }
}

}  // namespace clearcut::read::gcode
