#include "read/gcode/words/block.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "base/error.h"

namespace clearcut::read::gcode {

namespace {

constexpr double kLargestNumber = 1e9;
constexpr const char* kNoParameters =
    "parameters and expressions are no words of the control; post the program with plain numbers";
constexpr const char* kNoFlow =
    "jumps, loops and calls are no words of the control; post the program without them";

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}
bool is_number_part(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == '+' || c == '-';
}

/// "1e-05", as some scripts write it, is no number to a control, but an E word to others.
bool has_exponent(std::string_view line, std::size_t at) {
  if (at + 1 >= line.size() || (line[at] != 'e' && line[at] != 'E') || is_blank(line[at - 1])) return false;
  return is_number_part(line[at + 1]);
}

/// Words of several letters with which Fanuc and Haas jump, loop and print.
bool is_flow(std::string_view rest) {
  constexpr std::string_view kWords[] = {"IF[",  "IF#",  "GOTO", "WHILE", "DO1",   "DO2",   "DO3",
                                         "END1", "END2", "END3", "POPEN", "PCLOS", "DPRNT", "BPRNT"};
  std::size_t second = 1;
  while (second < rest.size() && is_blank(rest[second])) ++second;
  if (second >= rest.size() || (!is_letter(rest[second]) && rest[second] != '#' && rest[second] != '['))
    return false;
  std::string word;
  for (const char c : rest.substr(0, 12)) {
    if (!is_blank(c)) word += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  for (const std::string_view one : kWords)
    if (word.rfind(one, 0) == 0) return true;
  return false;
}

/// The word of several letters at the beginning of `rest` by which OSP calls, repeats and leaves out, or the name of its variable
/// (VC1, VZOFX[1]); "" for others.
std::string_view osp_word(std::string_view rest) {
  constexpr std::string_view kWords[] = {"CALL", "RTS", "MODIN", "MODOUT", "NCYL", "NOEX"};
  for (const std::string_view one : kWords) {
    const bool is_there =
        std::equal(one.begin(), one.end(), rest.begin(), rest.begin() + std::min(one.size(), rest.size()),
                   [](char a, char b) { return a == std::toupper(static_cast<unsigned char>(b)); });
    if (is_there) return rest.substr(0, one.size());
  }
  const bool is_variable =
      rest.size() > 1 && std::toupper(static_cast<unsigned char>(rest[0])) == 'V' && is_letter(rest[1]);
  return is_variable ? rest.substr(0, std::min(rest.find_first_of(" \t[="), rest.size()))
                     : std::string_view{};
}

/// Letters and a bracket, as in SIN[30].
bool is_function(std::string_view rest) {
  std::size_t at = 0;
  while (at < rest.size() && is_letter(rest[at])) ++at;
  return at > 1 && at < rest.size() && rest[at] == '[';
}

/// Two letters are no word.
bool is_text(std::string_view rest) {
  return rest.size() > 1 && is_letter(rest[0]) && is_letter(rest[1]);
}

std::string shown(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (std::isprint(byte)) return std::string("'") + c + "'";
  return "byte " + std::to_string(byte);
}

int tenths(double value, char letter, const std::string& place) {
  const double scaled = std::round(value * 10);
  if (value < 0 || value > 10000 || std::abs(value * 10 - scaled) > 1e-6) {
    throw InputError(place, std::string(1, letter) + " word with an impossible number; correct it");
  }
  return static_cast<int>(scaled);
}

}  // namespace

void Block::clear() {
  line = delete_level = 0;
  optional = percent = names_file = names_program = has_text = false;
  g.clear();
  m.clear();
  comments.clear();
  polar_radius = polar_angle = std::nullopt;
  corner.reset();
  present_ = whole_ = 0;
}

void Block::set(char letter, double value, bool has_point) {
  values_[static_cast<std::size_t>(letter - 'A')] = value;
  present_ |= 1U << (letter - 'A');
  if (!has_point) whole_ |= 1U << (letter - 'A');
}

bool BlockReader::next(Block& block) {
  block.clear();
  std::string_view line;
  if (!lines_.next(line)) return false;
  block.line = lines_.number();
  parse(line, block);
  return true;
}

void BlockReader::parse(std::string_view line, Block& block) const {
  bool first = true;
  for (std::size_t at = 0; at < line.size();) {
    const char c = line[at];
    if (is_blank(c)) {
      ++at;
      continue;
    }
    if (c == ';' || c == '*') {  // the rest is a comment, or Marlin's checksum
      if (c == ';') block.comments.push_back(line.substr(at + 1));
      return;
    }
    if (c == '(') {
      parse_comment(line, at, block);
    } else if (c == '%') {
      block.percent = true;
      return;
    } else if (c == '$' && first && line.substr(0, line.find_last_not_of(" \t") + 1).ends_with('%')) {
      block.names_file = true;
      return;
    } else if (c == '/' && first) {
      block.optional = true;
      ++at;
      if (at < line.size() && line[at] >= '1' && line[at] <= '9') block.delete_level = line[at++] - '0';
    } else {
      parse_word(line, at, block);
    }
    first = false;
  }
}

/// The first ')' ends a comment for every control; what follows an inner one would be read as words.
void BlockReader::parse_comment(std::string_view line, std::size_t& at, Block& block) const {
  const std::size_t close = line.find(')', at);
  if (close == std::string_view::npos)
    throw InputError(place(block.line), "comment without its closing ')'; close it");
  const std::string_view comment = line.substr(at + 1, close - at - 1);
  at = close + 1;
  if (comment.find('(') != std::string_view::npos && line.find(')', at) != std::string_view::npos)
    throw InputError(place(block.line),
                     "comment within a comment, which ends at its first ')'; take the inner ones out");
  block.comments.push_back(comment);
}

void BlockReader::parse_word(std::string_view line, std::size_t& at, Block& block) const {
  const char c = line[at];
  if (c == '#' || c == '[' || c == '=') throw MacroError(place(block.line), kNoParameters);
  if (c == '@' || c == '^') {
    ++at;
    (c == '@' ? block.polar_radius : block.polar_angle) = parse_number(line, at, c, block.line);
    return;
  }
  if (c == ',') {
    while (++at < line.size() && is_blank(line[at])) {
    }
    if (at == line.size() || !is_letter(line[at]))
      throw InputError(place(block.line), "a comma without a letter behind it; write numbers with a point");
    const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(line[at++])));
    return set_corner(block, letter, parse_number(line, at, letter, block.line), place(block.line));
  }
  if (!is_letter(c) && c != ':') {
    throw InputError(place(block.line), "unexpected " + shown(c) + "; this is no G-code word");
  }
  const char letter = c == ':' ? 'O' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (is_flow(line.substr(at))) throw MacroError(place(block.line), kNoFlow);
  if (const std::string_view word = osp_word(line.substr(at)); !word.empty())
    throw MacroError(place(block.line),
                     "'" + std::string(word) +
                         "' is a word of OSP's macros and calls, which are not read; post the "
                         "moves themselves");
  if (c != ':' && letter == 'O' && at + 1 < line.size() && is_letter(line[at + 1])) {
    while (++at < line.size() && std::isalnum(static_cast<unsigned char>(line[at])) != 0) {
    }
    block.names_program = true;
    return;
  }
  const std::size_t begin = ++at;
  const double number = parse_number(line, at, letter, block.line);
  if (letter == 'O' && at < line.size() && is_letter(line[at])) throw MacroError(place(block.line), kNoFlow);
  if (letter == 'G') {
    block.g.push_back(tenths(number, letter, place(block.line)));
  } else if (letter == 'M') {
    block.m.push_back(tenths(number, letter, place(block.line)));
    if (block.m.back() == 1170 || block.m.back() == 1180) at = line.size();  // Marlin's messages
    if ((block.m.back() == 0 || block.m.back() == 10) && is_text(line.substr(at))) {
      block.has_text = true;
      at = line.size();
    }
  } else {
    if (block.has(letter)) {
      const bool calls_macro = std::find(block.g.begin(), block.g.end(), 650) != block.g.end();
      if (calls_macro) throw MacroError(place(block.line), kNoFlow);  // arguments may come twice
      throw InputError(place(block.line), std::string("two ") + letter + " words in one block; split it");
    }
    block.set(letter, number, line.substr(begin, at - begin).find('.') != std::string_view::npos);
  }
}

void set_corner(Block& block, char letter, double value, const std::string& place) {
  if (letter == 'A')
    throw InputError(place,
                     "',A' states a line by its angle, which is not read; post both of its coordinates");
  if (letter != 'R' && letter != 'C')
    throw InputError(place,
                     std::string("',") + letter + "' is no word; ',R' rounds a corner and ',C' chamfers it");
  if (block.corner) throw InputError(place, "two of ',R' and ',C' in one block; keep one");
  block.corner = CornerWord{letter, value};
}

/// White space is allowed anywhere, also between digits.
double BlockReader::parse_number(std::string_view line, std::size_t& at, char letter, int number) const {
  char digits[48];
  std::size_t count = 0;
  for (; at < line.size() && (is_blank(line[at]) || is_number_part(line[at])); ++at) {
    if (is_blank(line[at])) continue;
    if (count == 0 && line[at] == '+') {
      digits[count++] = '0';
      continue;
    }
    if (count == sizeof digits) throw InputError(place(number), "number with too many digits; shorten it");
    digits[count++] = line[at];
  }
  if (at < line.size() && (line[at] == '#' || line[at] == '[' || line[at] == '<' || line[at] == '='))
    throw MacroError(place(number), kNoParameters);
  if (count == 0 && is_function(line.substr(at))) throw MacroError(place(number), kNoParameters);
  if (count > 0 && has_exponent(line, at)) {
    throw InputError(place(number), std::string(1, letter) + " word with an exponent; post plain decimals");
  }
  double value = 0;
  const auto [end, error] = std::from_chars(digits, digits + count, value, std::chars_format::fixed);
  if (count == 0 || error != std::errc{} || end != digits + count) {
    const std::string text(digits, count);
    throw InputError(place(number), std::string(1, letter) + " word " +
                                        (count == 0 ? "without a number" : "with '" + text + "'") +
                                        "; correct it");
  }
  if (!(std::abs(value) <= kLargestNumber)) {
    throw InputError(place(number),
                     std::string(1, letter) + " word with a number no machine takes; correct it");
  }
  return value;
}

namespace {

constexpr std::size_t kCodes = 2000;  // up to G199.9

// The drilling cycles, and those motions that are refused when used: threading, probing, boring, back boring.
constexpr int kMotionWords[] = {0,   10,  20,  30,  330, 331, 382, 383, 384, 385, 730, 740,
                                760, 770, 810, 820, 830, 840, 850, 860, 870, 880, 890};
constexpr int kPlaneWords[] = {170, 180, 190};
constexpr int kDistanceWords[] = {900, 910};
constexpr int kCenterWords[] = {901, 911};
constexpr int kFeedModeWords[] = {930, 940, 950};
constexpr int kUnitWords[] = {200, 210};
constexpr int kReturnWords[] = {980, 990};
constexpr int kOffsetWords[] = {540,  541,  1540, 550,  560,  570,  580,  590,  591,  592,  593,
                                1100, 1110, 1120, 1130, 1140, 1150, 1160, 1170, 1180, 1190, 1200,
                                1210, 1220, 1230, 1240, 1250, 1260, 1270, 1280, 1290};
constexpr int kOnceWords[] = {100, 120, 130, 280, 281, 300, 301, 310, 501,
                              510, 511, 520, 680, 920, 921, 922, 923};
constexpr int kCompensationWords[] = {410, 411, 420, 421};
// Dwell, look-ahead, exact stop, polar and scaling and rotation off, lengths, machine frame (G53, see
// go_home), path control, cycle end, rpm, limit of look-ahead, smoothness.
constexpr int kSilentWords[] = {40,  80,  90,  150, 160, 400, 430, 431, 432,  490,
                                500, 530, 610, 611, 640, 690, 800, 970, 1030, 1870};

template <std::size_t n>
constexpr void enter(std::array<Group, kCodes>& table, const int (&codes)[n], Group group) {
  for (const int code : codes) table[static_cast<std::size_t>(code)] = group;
}

constexpr std::array<Group, kCodes> kGroups = [] {
  std::array<Group, kCodes> table{};
  enter(table, kMotionWords, Group::kMotion);
  enter(table, kPlaneWords, Group::kPlane);
  enter(table, kDistanceWords, Group::kDistance);
  enter(table, kCenterWords, Group::kCenters);
  enter(table, kFeedModeWords, Group::kFeedMode);
  enter(table, kUnitWords, Group::kUnits);
  enter(table, kReturnWords, Group::kReturn);
  enter(table, kOffsetWords, Group::kOffset);
  enter(table, kOnceWords, Group::kOnce);
  enter(table, kCompensationWords, Group::kCompensation);
  enter(table, kSilentWords, Group::kSilent);
  return table;
}();

}  // namespace

Group group_of(int code) {
  const auto index = static_cast<std::size_t>(code);
  return index < kCodes ? kGroups[index] : Group::kUnknown;
}

bool is_modal(Group group) {
  return group != Group::kUnknown && group != Group::kCompensation && group != Group::kSilent;
}

std::string g_word(int code) {
  const std::string whole = "G" + std::to_string(code / 10);
  return code % 10 == 0 ? whole : whole + "." + std::to_string(code % 10);
}

bool has_g(const Block& block, int code) {
  return std::find(block.g.begin(), block.g.end(), code) != block.g.end();
}

int motion_in(const Block& block) {
  int motion = -1;
  for (const int code : block.g) {
    if (group_of(code) == Group::kMotion || (code == 800 && motion < 0)) motion = code;
  }
  return motion;
}

}  // namespace clearcut::read::gcode
