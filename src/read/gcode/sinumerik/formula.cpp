#include "read/gcode/sinumerik/formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/elementary.h"
#include "base/units.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {
namespace {

/// Parentheses, functions and signs within each other.
constexpr int kDeepest = 60;
constexpr double kLargestValue = 1e15;
/// Smaller results are what rounding leaves of 0.
constexpr double kLeftOfNothing = 1e-12;
/// R parameters that a control can have.
constexpr int kMostParameters = 32000;
/// Comparisons take numbers as equal that differ by this share.
constexpr double kSameShare = 1e-12;

enum FormulaOperator {
  kSame = 1,
  kOther,
  kGreater,
  kGreaterOrSame,
  kLess,
  kLessOrSame,
  kOr,
  kXor,
  kAnd,
  kBitsOr,
  kBitsXor,
  kBitsAnd,
  kPlus,
  kMinus,
  kTimes,
  kOver,
  kWholeOver,
  kModulo
};

struct OperatorRow {
  std::string_view text;
  int kind;
  int strength;
};
/// Longer texts before those that they begin with.
constexpr OperatorRow kOperators[] = {
    {"==", kSame, 1},       {"<>", kOther, 1},      {">=", kGreaterOrSame, 1},
    {"<=", kLessOrSame, 1}, {">", kGreater, 1},     {"<", kLess, 1},
    {"OR", kOr, 2},         {"XOR", kXor, 3},       {"AND", kAnd, 4},
    {"B_OR", kBitsOr, 5},   {"B_XOR", kBitsXor, 6}, {"B_AND", kBitsAnd, 7},
    {"+", kPlus, 8},        {"-", kMinus, 8},       {"*", kTimes, 9},
    {"/", kOver, 9},        {"DIV", kWholeOver, 9}, {"MOD", kModulo, 9}};

enum class FormulaFunction : unsigned char {
  kSin,
  kCos,
  kTan,
  kAsin,
  kAcos,
  kAtan2,
  kSqrt,
  kAbs,
  kPot,
  kTrunc,
  kRound,
  kRoundUp,
  kLn,
  kExp,
  kMinVal,
  kMaxVal,
  kBound
};

struct FunctionRowOfFormula {
  std::string_view name;
  FormulaFunction kind;
  std::size_t arguments;
};
constexpr FunctionRowOfFormula kFormulaFunctions[] = {
    {"SIN", FormulaFunction::kSin, 1},       {"COS", FormulaFunction::kCos, 1},
    {"TAN", FormulaFunction::kTan, 1},       {"ASIN", FormulaFunction::kAsin, 1},
    {"ACOS", FormulaFunction::kAcos, 1},     {"ATAN2", FormulaFunction::kAtan2, 2},
    {"SQRT", FormulaFunction::kSqrt, 1},     {"ABS", FormulaFunction::kAbs, 1},
    {"POT", FormulaFunction::kPot, 1},       {"TRUNC", FormulaFunction::kTrunc, 1},
    {"ROUND", FormulaFunction::kRound, 1},   {"ROUNDUP", FormulaFunction::kRoundUp, 1},
    {"LN", FormulaFunction::kLn, 1},         {"EXP", FormulaFunction::kExp, 1},
    {"MINVAL", FormulaFunction::kMinVal, 2}, {"MAXVAL", FormulaFunction::kMaxVal, 2},
    {"BOUND", FormulaFunction::kBound, 3}};

bool is_name_start(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
}
bool is_digit_of(char c) {
  return c >= '0' && c <= '9';
}
bool is_name_part(char c) {
  return is_name_start(c) || is_digit_of(c);
}

double in_degrees(double radians) {
  return radians * 180 / kPi;
}

long long bits_of(double value) {
  return static_cast<long long>(std::trunc(std::clamp(value, -1e15, 1e15)));
}

bool is_same(double a, double b) {
  return std::abs(a - b) <= kSameShare * std::max({1.0, std::abs(a), std::abs(b)});
}

}  // namespace

SinumerikVariable* SinumerikMemory::named(const std::string& name) {
  auto& own = variables.back();
  const auto found = own.find(name);
  return found == own.end() ? nullptr : &found->second;
}

SinumerikResult as_type(SinumerikType type, SinumerikResult value, const RefuseBlock& refuse) {
  if (value.is_text != (type == SinumerikType::kText))
    refuse(value.is_text ? "a text where a number belongs; correct it"
                         : "a number where a text belongs; correct it");
  if (type == SinumerikType::kInt) value.number = std::floor(value.number + 0.5);
  if (type == SinumerikType::kBool) value.number = value.number != 0 ? 1 : 0;
  return value;
}

std::string sinumerik_number(double value) {
  if (std::abs(value) < kLeftOfNothing) return "0";
  char text[64];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  const std::string shortest(text, error == std::errc{} ? end : text);
  if (!shortest.empty() && shortest.find('e') == std::string::npos) return shortest;
  return fmt::format("{:.15f}", value);  // words of a program have no exponent
}

void SinumerikFormula::skip_blanks() {
  while (is_blank(peek())) ++at_;
}

bool SinumerikFormula::take(char c) {
  skip_blanks();
  if (peek() != c) return false;
  ++at_;
  return true;
}

void SinumerikFormula::expect(char c, const char* what) {
  if (!take(c)) refuse_(std::string(what) + " lacks its '" + c + "'; add it");
}

std::string SinumerikFormula::name() {
  const std::size_t begin = at_;
  while (is_name_part(peek())) ++at_;
  return std::string(line_.substr(begin, at_ - begin));
}

double SinumerikFormula::checked(double value) const {
  if (!(std::abs(value) <= kLargestValue))
    refuse_("the expression has no result that a control holds; correct it");
  return value;
}

int SinumerikFormula::whole(double value, const char* what) const {
  const double nearest = std::round(value);
  if (!(std::abs(value) <= 1e9) || std::abs(value - nearest) > 1e-6)
    refuse_(std::string(what) + " is " + sinumerik_number(std::clamp(value, -1e12, 1e12)) +
            ", no whole number; correct it");
  return static_cast<int>(nearest);
}

SinumerikFormula::Operator SinumerikFormula::next_operator() const {
  std::size_t at = at_;
  while (at < line_.size() && is_blank(line_[at])) ++at;
  const std::string_view rest = line_.substr(std::min(at, line_.size()));
  for (const OperatorRow& row : kOperators) {
    if (rest.substr(0, row.text.size()) != row.text) continue;
    const bool is_word = is_name_start(row.text[0]);
    if (is_word && rest.size() > row.text.size() && is_name_part(rest[row.text.size()])) continue;
    if (rest.substr(0, 2) == "<<" || rest.substr(0, 2) == ">>") break;
    return {row.kind, row.strength, at - at_ + row.text.size()};
  }
  return {};
}

SinumerikResult SinumerikFormula::value() {
  if (++depth_ > kDeepest) refuse_("expression with too many parentheses; simplify it");
  bool compares = false, joins = false;
  SinumerikResult result = terms(1, compares, joins);
  if (compares && joins)
    refuse_(
        "AND, OR or XOR beside a comparison without parentheses, which the control joins first; put each "
        "comparison in parentheses");
  --depth_;
  return result;
}

double SinumerikFormula::number() {
  const SinumerikResult result = value();
  if (result.is_text) refuse_("a text where a number belongs; correct it");
  return result.number;
}

SinumerikResult SinumerikFormula::terms(int weakest, bool& compares, bool& joins) {
  SinumerikResult left = operand();
  for (Operator next = next_operator(); next.kind != 0 && next.strength >= weakest; next = next_operator()) {
    at_ += next.length;
    compares = compares || next.strength == 1;
    joins = joins || (next.strength >= 2 && next.strength <= 4);
    const SinumerikResult right = terms(next.strength + 1, compares, joins);
    if (left.is_text || right.is_text) {
      if (!left.is_text || !right.is_text || (next.kind != kSame && next.kind != kOther))
        refuse_("texts are compared with == and <> alone; correct the expression");
      left = {(left.text == right.text) == (next.kind == kSame) ? 1.0 : 0.0, "", false};
      continue;
    }
    left = {checked(computed(next.kind, left.number, right.number)), "", false};
  }
  return left;
}

double SinumerikFormula::computed(int kind, double a, double b) const {
  const auto truth = [](bool holds) { return holds ? 1.0 : 0.0; };
  switch (kind) {
    case kSame:
      return truth(is_same(a, b));
    case kOther:
      return truth(!is_same(a, b));
    case kGreater:
      return truth(a > b && !is_same(a, b));
    case kGreaterOrSame:
      return truth(a > b || is_same(a, b));
    case kLess:
      return truth(a < b && !is_same(a, b));
    case kLessOrSame:
      return truth(a < b || is_same(a, b));
    case kOr:
      return truth(a != 0 || b != 0);
    case kXor:
      return truth((a != 0) != (b != 0));
    case kAnd:
      return truth(a != 0 && b != 0);
    case kBitsOr:
      return static_cast<double>(bits_of(a) | bits_of(b));
    case kBitsXor:
      return static_cast<double>(bits_of(a) ^ bits_of(b));
    case kBitsAnd:
      return static_cast<double>(bits_of(a) & bits_of(b));
    case kPlus:
      return a + b;
    case kMinus:
      return a - b;
    case kTimes:
      return a * b;
    default:
      break;
  }
  if (b == 0) refuse_("division by zero; correct the expression, or the parameter that it takes");
  if (kind == kOver) return a / b;
  const double quotient = std::trunc(a / b);
  return kind == kWholeOver ? quotient : a - b * quotient;
}

SinumerikResult SinumerikFormula::operand() {
  if (++depth_ > kDeepest) refuse_("expression with too many parentheses; simplify it");
  skip_blanks();
  SinumerikResult result;
  if (take('(')) {
    result = value();
    expect(')', "an expression");
  } else if (peek() == '+' || peek() == '-') {
    const bool negative = line_[at_++] == '-';
    result = operand();
    if (result.is_text) refuse_("a sign before a text; correct it");
    if (negative) result.number = -result.number;
  } else if (is_name_start(peek())) {
    result = named(name());
  } else {
    result = literal();
  }
  --depth_;
  return result;
}

SinumerikResult SinumerikFormula::literal() {
  if (peek() == '"') {
    const std::size_t end = line_.find('"', at_ + 1);
    if (end == std::string_view::npos) refuse_("text without its closing '\"'; close it");
    SinumerikResult text{0, std::string(line_.substr(at_ + 1, end - at_ - 1)), true};
    at_ = end + 1;
    return text;
  }
  const std::size_t begin = at_;
  while (is_digit_of(peek()) || peek() == '.') ++at_;
  const std::string_view digits = line_.substr(begin, at_ - begin);
  double number = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::fixed);
  if (digits.empty() || error != std::errc{} || end != digits.data() + digits.size())
    refuse_("an expression lacks a number at '" + std::string(line_.substr(begin, 8)) + "'; correct it");
  if (peek() == 'E' && peek(1) == 'X') {
    at_ += 2;
    const bool negative = peek() == '-';
    if (peek() == '-' || peek() == '+') ++at_;
    int exponent = 0;
    if (!is_digit_of(peek())) refuse_("EX without its number; correct it");
    while (is_digit_of(peek()) && exponent < 1000) exponent = exponent * 10 + (line_[at_++] - '0');
    number *= base::pow(10, negative ? -exponent : exponent);
  }
  return {checked(number), "", false};
}

/// The number of "R12", or of "R[...]", behind its letter.
int SinumerikFormula::r_number(const std::string& name) {
  int number = 0;
  if (name.size() > 1) {
    for (const char c : name.substr(1)) number = std::min(number * 10 + (c - '0'), kMostParameters + 1);
  } else {
    expect('[', "R");
    number = whole(this->number(), "the number of an R parameter");
    expect(']', "R[");
  }
  if (number < 0 || number > kMostParameters)
    refuse_("R" + std::to_string(number) + " is no parameter of the control; correct its number");
  return number;
}

std::size_t SinumerikFormula::index_in(const SinumerikVariable& variable, const std::string& name) {
  if (!take('[')) {
    if (variable.values.size() > 1)
      refuse_(name + " is an array; give the place in it, as in " + name + "[0]");
    return 0;
  }
  const int index = whole(number(), "the place in an array");
  expect(']', "an array's place");
  if (index < 0 || index >= static_cast<int>(variable.values.size()))
    refuse_(name + "[" + std::to_string(index) + "] is outside the array; correct it");
  return static_cast<std::size_t>(index);
}

namespace {

bool is_r_parameter(const std::string& name) {
  return name[0] == 'R' && std::all_of(name.begin() + 1, name.end(), is_digit_of);
}

}  // namespace

SinumerikResult SinumerikFormula::named(const std::string& name) {
  if (name == "TRUE") return {1, "", false};
  if (name == "FALSE") return {0, "", false};
  if (name == "$PI") return {kPi, "", false};
  if (name == "NOT") {
    const SinumerikResult of = operand();
    return {of.number == 0 ? 1.0 : 0.0, "", false};
  }
  if (name == "B_NOT") return {static_cast<double>(~bits_of(operand().number)), "", false};
  if (name[0] == '$')
    refuse_(name +
            " is a value of the control, which the program does not state; post the program without it");
  skip_blanks();
  if (is_r_parameter(name) && (name.size() > 1 || peek() == '[')) {
    const int number = r_number(name);
    const auto found = memory_.r.find(number);
    if (found == memory_.r.end())
      refuse_("R" + std::to_string(number) +
              " is taken before the program sets it; the control keeps what it was left with: set it before");
    return {found->second, "", false};
  }
  if (SinumerikVariable* const variable = memory_.named(name))
    return variable->values[index_in(*variable, name)];
  if (peek() == '(') return function(name);
  refuse_(name + " is no variable that the program defines; correct it, or define it by DEF");
  return {};
}

SinumerikResult SinumerikFormula::function(const std::string& name) {
  const auto* const row = std::find_if(std::begin(kFormulaFunctions), std::end(kFormulaFunctions),
                                       [&](const FunctionRowOfFormula& one) { return one.name == name; });
  if (row == std::end(kFormulaFunctions))
    refuse_(name + " is no function that is read; post the program without it");
  expect('(', name.c_str());
  std::vector<double> x;
  do x.push_back(number());
  while (take(','));
  expect(')', name.c_str());
  if (x.size() != row->arguments)
    refuse_(name + " takes " + std::to_string(row->arguments) + " numbers; correct it");
  const double angle = x[0] * kPi / 180;
  const auto result = [&]() -> double {
    switch (row->kind) {
      case FormulaFunction::kSin:
        return base::sin(angle);
      case FormulaFunction::kCos:
        return base::cos(angle);
      case FormulaFunction::kTan:
        return base::tan(angle);
      case FormulaFunction::kAsin:
      case FormulaFunction::kAcos:
        if (std::abs(x[0]) > 1) refuse_("no angle has a sine or cosine beyond 1; correct the expression");
        return in_degrees(row->kind == FormulaFunction::kAsin ? base::asin(x[0]) : base::acos(x[0]));
      case FormulaFunction::kAtan2:
        return in_degrees(base::atan2(x[0], x[1]));
      case FormulaFunction::kSqrt:
        if (x[0] < 0) refuse_("the root of a number below zero; correct the expression");
        return std::sqrt(x[0]);
      case FormulaFunction::kAbs:
        return std::abs(x[0]);
      case FormulaFunction::kPot:
        return x[0] * x[0];
      case FormulaFunction::kTrunc:
        return std::trunc(x[0]);
      case FormulaFunction::kRound:
        return std::floor(x[0] + 0.5);
      case FormulaFunction::kRoundUp:
        return x[0] < 0 ? std::floor(x[0]) : std::ceil(x[0]);
      case FormulaFunction::kLn:
        if (!(x[0] > 0)) refuse_("the logarithm of a number that is not above zero; correct the expression");
        return base::log(x[0]);
      case FormulaFunction::kExp:
        return base::exp(x[0]);
      case FormulaFunction::kMinVal:
        return std::min(x[0], x[1]);
      case FormulaFunction::kMaxVal:
        return std::max(x[0], x[1]);
      default:
        return std::min(std::max(x[2], x[0]), x[1]);
    }
  };
  return {checked(result()), "", false};
}

bool SinumerikFormula::assignment() {
  const std::size_t begin = at_;
  skip_blanks();
  const auto leave = [&] {
    at_ = begin;
    return false;
  };
  if (!is_name_start(peek()) || peek() == '$') return leave();
  const std::string what = name();
  SinumerikVariable* const variable = memory_.named(what);
  const bool is_r = is_r_parameter(what) && !variable;
  if (!variable && !is_r) return leave();
  skip_blanks();
  if (is_r && what.size() == 1 && peek() != '[') return leave();
  if (!variable && peek() != '[' && (peek() != '=' || peek(1) == '=')) return leave();
  const int number = is_r ? r_number(what) : 0;
  const std::size_t index = variable ? index_in(*variable, what) : 0;
  if (!take('=') || peek() == '=') refuse_(what + " stands alone; '=' and its value are missing");
  const SinumerikResult result = value();
  if (variable)
    variable->values[index] = as_type(variable->type, result, refuse_);
  else
    memory_.r[number] = as_type(SinumerikType::kReal, result, refuse_).number;
  return true;
}

}  // namespace clearcut::read::gcode
