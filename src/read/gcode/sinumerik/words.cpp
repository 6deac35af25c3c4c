#include "read/gcode/sinumerik/words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {
namespace {

constexpr double kLargestNumber = 1e9;
constexpr std::size_t kMostDigits = 40;
constexpr const char* kComputes =
    "R parameters or an expression where none is read; post plain numbers there";

char upper(char c) {
  return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}
bool begins_name(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}
bool is_decimal(char c) {
  return c >= '0' && c <= '9';
}
bool begins_value(char c) {
  return is_decimal(c) || c == '.' || c == '+' || c == '-';
}

class LineWords {
 public:
  LineWords(std::string_view line, const RefuseBlock& refuse, const RefuseBlock& computes)
      : line_(line), refuse_(refuse), computes_(computes) {}

  SinumerikBlock read() {
    SinumerikBlock block;
    skip_blanks();
    if (peek() == '%') return block;  // %_N_NAME_MPF names the file
    if (take('/')) {
      block.optional = true;
      if (is_decimal(peek())) ++at_;  // which of ten skip levels
    }
    skip_number_and_label();
    if (begins_language_block()) computes_(kComputes);
    while (skip_blanks(), at_ < line_.size()) {
      if (take(';')) {
        block.comment = line_.substr(at_);
        return block;
      }
      block.words.push_back(word());
    }
    return block;
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < line_.size() ? line_[at_ + ahead] : '\0'; }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  void skip_blanks() {
    while (is_blank(peek())) ++at_;
  }
  void skip_digits() {
    while (is_decimal(peek())) ++at_;
  }

  /// "N10", ":10", "LABEL:".
  void skip_number_and_label() {
    skip_blanks();
    if ((upper(peek()) == 'N' || peek() == ':') && is_decimal(peek(1))) {
      ++at_;
      skip_digits();
    }
    skip_blanks();
    std::size_t end = at_;
    while (end < line_.size() && (begins_name(line_[end]) || is_decimal(line_[end]))) ++end;
    if (end > at_ + 1 && end < line_.size() && line_[end] == ':' && begins_name(peek())) at_ = end + 1;
  }

  /// Whether the first word is one whose block is no row of words.
  bool begins_language_block() {
    constexpr std::string_view kWords[] = {
        "DEF",   "PROC",    "IF",     "ELSE",  "ENDIF",   "WHILE",   "ENDWHILE", "FOR",   "ENDFOR",
        "LOOP",  "ENDLOOP", "CASE",   "CALL",  "EXTCALL", "GOTO",    "GOTOF",    "GOTOB", "GOTOC",
        "GOTOS", "SETAL",   "EXTERN", "UNTIL", "REPEAT",  "REPEATB", "DEFINE",   "PCALL"};
    skip_blanks();
    std::string name;
    for (std::size_t k = 0; begins_name(peek(k)); ++k) name += upper(peek(k));
    return std::find(std::begin(kWords), std::end(kWords), name) != std::end(kWords);
  }

  SinumerikWord word() {
    if (peek() == '$' || peek() == '=') computes_(kComputes);
    if (peek() == '(') refuse_("text in parentheses is no comment on a Sinumerik; put it behind ';'");
    if (!begins_name(peek())) {
      const auto byte = static_cast<unsigned char>(peek());
      refuse_("unexpected " +
              (std::isprint(byte) ? std::string("'") + peek() + "'" : "byte " + std::to_string(byte)) +
              "; this is no word of a Sinumerik");
    }
    SinumerikWord found;
    found.name += upper(line_[at_++]);
    const bool is_letter = !begins_name(peek());
    if (is_letter) return letter_word(std::move(found));
    while (begins_name(peek()) || is_decimal(peek())) found.name += upper(line_[at_++]);
    skip_blanks();
    if (peek() == '[') computes_(kComputes);
    if (take('(')) {
      found.kind = SinumerikValue::kArguments;
      found.arguments = arguments();
      if (found.name.starts_with("CYCLE"))
        for (const std::string& one : found.arguments)
          if (!one.empty() && one[0] != '"' && one[0] != '_' &&
              !std::all_of(one.begin(), one.end(), begins_value))
            computes_(kComputes);
    } else if (take('=')) {
      assign(found);
    }
    return found;
  }

  /// "X10", "X=10", "S1=500": digits that an '=' follows belong to the name.
  SinumerikWord letter_word(SinumerikWord found) {
    std::size_t end = at_;
    while (end < line_.size() && is_decimal(line_[end])) ++end;
    std::size_t sign = end;
    while (sign < line_.size() && is_blank(line_[sign])) ++sign;
    if (sign < line_.size() && line_[sign] == '=') {
      found.name.append(line_.substr(at_, end - at_));
      at_ = sign + 1;
      assign(found);
      return found;
    }
    if (peek() == '[' || peek() == '(') computes_(kComputes);
    found.kind = SinumerikValue::kNumber;
    found.number = number(found.name);
    return found;
  }

  void assign(SinumerikWord& found) {
    if (found.name.size() > 1 && found.name[0] == 'R' && is_decimal(found.name[1])) computes_(kComputes);
    skip_blanks();
    if (take('"')) {
      const std::size_t end = line_.find('"', at_);
      if (end == std::string_view::npos) refuse_("text without its closing '\"'; close it");
      found.kind = SinumerikValue::kText;
      found.text = std::string(line_.substr(at_, end - at_));
      at_ = end + 1;
      return;
    }
    found.kind = SinumerikValue::kNumber;
    for (const auto& [name, kind] :
         {std::pair("AC(", SinumerikValue::kAbsolute), std::pair("IC(", SinumerikValue::kIncremental)}) {
      if (upper(peek()) != name[0] || upper(peek(1)) != name[1] || peek(2) != name[2]) continue;
      at_ += 3;
      found.kind = kind;
    }
    skip_blanks();
    if (begins_name(peek()) || peek() == '$' || peek() == '(') computes_(kComputes);
    found.number = number(found.name);
    skip_blanks();
    if (found.kind != SinumerikValue::kNumber && !take(')')) computes_(kComputes);
  }

  double number(const std::string& name) {
    std::string digits;
    skip_blanks();
    while (begins_value(peek()) && digits.size() < kMostDigits) {
      if ((peek() == '+' || peek() == '-') && !digits.empty()) computes_(kComputes);
      digits += line_[at_++];
    }
    if (digits.empty()) refuse_(name + " without a number; correct it");
    if (upper(peek()) == 'E' && upper(peek(1)) == 'X')
      refuse_(name + " with an exponent; post plain decimals");
    if (peek() == '*' || peek() == '/') computes_(kComputes);
    const std::string_view plain = std::string_view(digits).substr(digits[0] == '+' ? 1 : 0);
    double value = 0;
    const auto [end, error] =
        std::from_chars(plain.data(), plain.data() + plain.size(), value, std::chars_format::fixed);
    if (error != std::errc{} || end != plain.data() + plain.size())
      refuse_(name + " with '" + digits + "'; correct it");
    if (!(std::abs(value) <= kLargestNumber)) refuse_(name + " with a number no machine takes; correct it");
    return value;
  }

  /// Behind the opening parenthesis, up to the one that closes it.
  std::vector<std::string> arguments() {
    std::vector<std::string> found(1);
    bool in_text = false;
    for (; at_ < line_.size(); ++at_) {
      const char c = line_[at_];
      if (c == '"') in_text = !in_text;
      if (!in_text && c == ')') {
        ++at_;
        if (found.size() == 1 && found[0].empty()) found.clear();
        return found;
      }
      if (!in_text && (c == '(' || c == '[')) computes_(kComputes);
      if (!in_text && c == ',') {
        found.emplace_back();
      } else if (in_text || !is_blank(c)) {
        found.back() += in_text ? c : upper(c);
      }
    }
    refuse_("call without its closing ')'; close it");
    return found;
  }

  std::string_view line_;
  const RefuseBlock& refuse_;
  const RefuseBlock& computes_;
  std::size_t at_ = 0;
};

/// A line in capitals without what stands behind ';' or within parentheses.
std::string bare_code(std::string_view line) {
  std::string code;
  int depth = 0;
  for (const char c : line.substr(0, line.find(';'))) {
    if (c == '(') {
      code += c;
      ++depth;
    } else if (c == ')') {
      depth = std::max(depth - 1, 0);
    } else if (depth == 0) {
      code += upper(c);
    }
  }
  return code;
}

/// Whether `code` has the word, and it is neither the end of another word nor the beginning of a longer number.
bool has_word(const std::string& code, std::string_view word) {
  for (std::size_t at = code.find(word); at != std::string::npos; at = code.find(word, at + 1)) {
    const bool begins = at == 0 || !begins_name(code[at - 1]);
    const std::size_t end = at + word.size();
    const bool is_open = word.back() == '=' || word.back() == '"' || word.back() == '(' || end >= code.size();
    if (begins && (is_open || (!begins_value(code[end]) && !begins_name(code[end])))) return true;
  }
  return false;
}

constexpr std::array<std::string_view, 27> kOwnWords{
    "MCALL",    "SUPA",     "CR=",      "CTOL=",    "TURN=",     "T=\"",       "G700",
    "G710",     "G641",     "G642",     "G645",     "MSG(",      "WORKPIECE(", "CYCLE81(",
    "CYCLE82(", "CYCLE83(", "CYCLE84(", "CYCLE85(", "CYCLE800(", "CYCLE832(",  "CYCLE840(",
    "GOTOF",    "GOTOB",    "DEF REAL", "DEF INT",  "ATRANS",    "RPL="};

}  // namespace

SinumerikBlock sinumerik_block(std::string_view line, const RefuseBlock& refuse,
                               const RefuseBlock& computes) {
  return LineWords(line, refuse, computes).read();
}

int first_language_line(std::string_view text) {
  bool computes = false;
  const RefuseBlock stop = [](const std::string& why) { throw InputError("", why); };
  const RefuseBlock found = [&](const std::string& why) {
    computes = true;
    throw InputError("", why);
  };
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    try {
      sinumerik_block(line, stop, found);
    } catch (const InputError&) {
      return computes ? lines.number() : 0;
    }
  }
  return 0;
}

std::string tool_comment(const std::string& name, int number) {
  return "T=\"" + name + "\" IS T" + std::to_string(number);
}

std::optional<std::pair<std::string, int>> named_tool_in(std::string_view comment) {
  constexpr std::string_view kBegin = "T=\"", kMiddle = "\" IS T";
  comment = stripped(comment);
  const std::size_t middle = comment.find(kMiddle);
  if (!comment.starts_with(kBegin) || middle == std::string_view::npos) return std::nullopt;
  const std::string_view digits = comment.substr(middle + kMiddle.size());
  int number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{} || end != digits.data() + digits.size() || number < 1) return std::nullopt;
  return std::pair{std::string(comment.substr(kBegin.size(), middle - kBegin.size())), number};
}

bool is_sinumerik(std::string_view text) {
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    const std::string code = bare_code(line);
    if (code.starts_with("%_N_")) return true;
    for (const std::string_view word : kOwnWords)
      if (has_word(code, word)) return true;
  }
  return false;
}

}  // namespace clearcut::read::gcode
