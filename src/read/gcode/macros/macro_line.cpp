#include "read/gcode/macros/macro_line.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "base/error.h"
#include "read/gcode/words/block.h"

namespace clearcut::read::gcode {

namespace {

constexpr double kLargestWord = 1e9;

/// The digits of a word's number, where it is no expression.
bool is_plain(std::string_view number) {
  return !number.empty() && number.find_first_not_of("0123456789.+-") == std::string_view::npos;
}

int tenths_of(double value, char letter, const std::string& place) {
  const double scaled = std::round(value * 10);
  if (!(value >= 0 && value <= 10000) || std::abs(value * 10 - scaled) > 1e-3)
    throw InputError(place, std::string(1, letter) + " word with an impossible number; correct it");
  return static_cast<int>(scaled);
}

void take_block_number(CleanLine& line) {
  if (line.text.empty() || line.text[0] != 'N') return;
  std::size_t end = 1;
  int number = 0;
  while (end < line.text.size() && std::isdigit(static_cast<unsigned char>(line.text[end])) && end < 10)
    number = number * 10 + (line.text[end++] - '0');
  if (end == 1) return;
  if (end < line.text.size() && line.text[end] == '.') return;
  line.number = number;
  line.text.erase(0, end);
}

/// Reads words one after another into a block.
class WordReader {
 public:
  WordReader(MacroStyle style, MacroStore& store, const std::string& place, Block& block,
             std::vector<ArgumentWord>* words)
      : style_(style), store_(store), place_(place), block_(block), words_(words) {}

  void read(std::string_view text, std::size_t at) {
    while (at < text.size()) {
      if (text[at] == '%') {
        block_.percent = true;
        break;
      }
      if (text[at] == '*') break;  // a checksum
      Expression expression(text, at, style_, store_, place_);
      if (text[at] == '#')
        assign(expression);
      else
        word(text, at, expression);
    }
    for (const Assignment& one : late_) store_.assign(one);
  }

 private:
  void assign(Expression& expression) {
    expression.skip("#");
    Assignment one;
    if (style_ == MacroStyle::kLinuxCnc && expression.next() == '<')
      one.name = expression.name();
    else
      one.number = expression.parameter_number();
    if (!expression.skip("="))
      throw InputError(place_, "a parameter stands alone; a letter before it, or '=' behind it, is missing");
    one.value = assigned(expression);
    if (style_ == MacroStyle::kLinuxCnc)
      late_.push_back(one);
    else
      store_.assign(one);
  }

  /// On Fanuc what is set may be a sum without brackets around it.
  MacroValue assigned(Expression& expression) {
    return style_ == MacroStyle::kLinuxCnc ? expression.value() : expression.sum();
  }

  void word(std::string_view text, std::size_t& at, Expression& expression) {
    const char letter = text[at] == ':' ? 'O' : text[at];
    if ((letter == '@' || letter == '^') && style_ == MacroStyle::kLinuxCnc) {
      ++at;
      (letter == '@' ? block_.polar_radius : block_.polar_angle) = expression.value().number;
      return;
    }
    if (letter == ',' && style_ == MacroStyle::kFanuc) return corner(text, at, expression);
    if (letter < 'A' || letter > 'Z')
      throw InputError(place_, std::string("unexpected '") + letter + "'; this is no G-code word");
    const std::size_t begin = ++at;
    const MacroValue value = expression.value();
    if (value.is_vacant) return;
    if (!(std::abs(value.number) <= kLargestWord))
      throw InputError(place_, std::string(1, letter) + " word with a number no machine takes; correct it");
    const std::string_view number = text.substr(begin, at - begin);
    const bool has_point = !is_plain(number) || number.find('.') != std::string_view::npos;
    if (words_) words_->push_back({letter, value.number});
    enter(letter, value.number, has_point);
  }

  void corner(std::string_view text, std::size_t& at, Expression& expression) {
    if (++at == text.size())
      throw InputError(place_, "a comma without a letter behind it; write numbers with a point");
    const char letter = text[at++];
    const MacroValue value = expression.value();
    if (!value.is_vacant) set_corner(block_, letter, value.number, place_);
  }

  void enter(char letter, double value, bool has_point) {
    if (letter == 'G') return block_.g.push_back(tenths_of(value, letter, place_));
    if (letter == 'M') return block_.m.push_back(tenths_of(value, letter, place_));
    if (block_.has(letter) && !words_)
      throw InputError(place_, std::string("two ") + letter + " words in one block; split it");
    block_.set(letter, value, has_point);
  }

  MacroStyle style_;
  MacroStore& store_;
  const std::string& place_;
  Block& block_;
  std::vector<ArgumentWord>* words_;
  std::vector<Assignment> late_;
};

}  // namespace

CleanLine cleaned(std::string_view line, const std::string& place) {
  CleanLine result;
  result.text.reserve(line.size());
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    if (is_blank(c)) continue;
    if (c == ';') {
      result.comments.push_back(line.substr(at + 1));
      break;
    }
    if (c == '(') {
      const std::size_t close = line.find(')', at);
      if (close == std::string_view::npos)
        throw InputError(place, "comment without its closing ')'; close it");
      result.comments.push_back(line.substr(at + 1, close - at - 1));
      at = close;
      continue;
    }
    if (c == '/' && result.text.empty() && !result.is_optional) {
      result.is_optional = true;
      if (at + 1 < line.size() && line[at + 1] >= '1' && line[at + 1] <= '9')
        result.delete_level = line[++at] - '0';
      continue;
    }
    result.text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  result.is_percent = result.text.substr(0, 1) == "%";
  take_block_number(result);
  return result;
}

void compute_words(const CleanLine& line, std::size_t at, MacroStyle style, MacroStore& store,
                   const std::string& place, Block& block, std::vector<ArgumentWord>* words) {
  for (const std::string_view comment : line.comments) block.comments.push_back(comment);
  block.optional = line.is_optional;
  block.delete_level = line.delete_level;
  WordReader(style, store, place, block, words).read(line.text, at);
}

int first_macro_line(std::string_view text) {
  BlockReader reader(text, "");
  Block block;
  try {
    while (reader.next(block)) {
      const bool calls = std::any_of(block.m.begin(), block.m.end(), [&](int m) {
        return m == 970 || ((m == 980 || m == 990) && block.has('P'));
      });
      if (calls || has_g(block, 650)) return block.line;
    }
  } catch (const MacroError&) {
    return block.line;
  } catch (const InputError&) {
    return 0;  // reported by the reader of the program
  }
  return 0;
}

}  // namespace clearcut::read::gcode
