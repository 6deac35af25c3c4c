#include "support/independent/grbl.h"

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

namespace clearcut::test_support {
namespace {

// Error codes.
constexpr int kOk = 0, kExpectedLetter = 1, kBadNumber = 2, kNegative = 4, kOverflow = 11, kUnsupported = 20,
              kModalGroup = 21, kNoFeed = 22, kNotInteger = 23, kTwoAxisCommands = 24, kRepeated = 25,
              kNoAxisWords = 26, kLineNumber = 27, kMissingValue = 28, kAxisWordsUnused = 31,
              kNoAxisInPlane = 32, kInvalidTarget = 33, kArcRadius = 34, kNoOffsets = 35, kUnusedWords = 36,
              kToolNumber = 38;
constexpr std::size_t kLineBuffer = 80;

struct Word {
  char letter = 0;
  float value = 0;
};

class Grbl {
 public:
  explicit Grbl(bool has_mist) : has_mist_(has_mist) {}

  int execute(const std::string& raw) {
    std::string line;
    if (const int error = strip(raw, line)) return error;
    std::vector<Word> words;
    if (const int error = split(line, words)) return error;
    block_ = {};
    for (const Word& word : words) {
      if (const int error = take(word)) return error;
    }
    return check_block();
  }

 private:
  struct Block {
    std::set<int> groups;
    std::map<char, float> values;
    int motion = -1;
    bool dwell = false;
    bool other_axis_use = false;  ///< G10, G28, G30, G92 take the axis words
  };

  /// What its serial reader keeps: no blanks, no comments, upper case.
  static int strip(const std::string& raw, std::string& line) {
    bool comment = false;
    for (const char c : raw) {
      if (c == '(') comment = true;
      if (c == ';') break;
      if (!comment && !std::isspace(static_cast<unsigned char>(c)) && c != ')') {
        line += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
      }
      if (c == ')') comment = false;
    }
    return line.size() >= kLineBuffer ? kOverflow : kOk;
  }

  static int split(const std::string& line, std::vector<Word>& words) {
    for (std::size_t at = 0; at < line.size();) {
      if (line[at] < 'A' || line[at] > 'Z') return kExpectedLetter;
      const char letter = line[at++];
      const std::size_t begin = at;
      while (at < line.size() && (std::isdigit(static_cast<unsigned char>(line[at])) || line[at] == '.' ||
                                  ((line[at] == '-' || line[at] == '+') && at == begin))) {
        ++at;
      }
      const std::string number = line.substr(begin, at - begin);
      if (number.find_first_of("0123456789") == std::string::npos) return kBadNumber;
      words.push_back({letter, std::strtof(number.c_str(), nullptr)});
    }
    return kOk;
  }

  int take(const Word& word) {
    if (word.letter == 'G') return take_g(word.value);
    if (word.letter == 'M') return take_m(word.value);
    if (std::string("FIJKLNPRSTXYZ").find(word.letter) == std::string::npos) return kUnsupported;
    if (block_.values.count(word.letter)) return kRepeated;
    if (std::string("FNPTS").find(word.letter) != std::string::npos && word.value < 0) return kNegative;
    if (word.letter == 'N' && word.value > 9999999) return kLineNumber;
    if (word.letter == 'T' && word.value > 255) return kToolNumber;
    block_.values[word.letter] = word.value;
    return kOk;
  }

  int enter(int group) { return block_.groups.insert(group).second ? kOk : kModalGroup; }

  /// Modal groups of the G words it knows, in tenths; 0: those that hold for their block alone.
  static inline const std::map<int, int> kGroups{
      {0, 1},    {10, 1},   {20, 1},   {30, 1},   {800, 1},  {40, 0},   {100, 0}, {280, 0}, {300, 0},
      {920, 0},  {281, 0},  {301, 0},  {921, 0},  {530, 0},  {170, 2},  {180, 2}, {190, 2}, {900, 3},
      {910, 3},  {911, 4},  {930, 5},  {940, 5},  {200, 6},  {210, 6},  {400, 7}, {431, 8}, {490, 8},
      {540, 12}, {550, 12}, {560, 12}, {570, 12}, {580, 12}, {590, 12}, {610, 13}};

  int take_g(float value) {
    const int tenths = static_cast<int>(std::lround(value * 10));
    if (tenths % 10 != 0 && tenths != 911 && tenths != 431 && tenths != 921 && tenths != 281 &&
        tenths != 301) {
      return tenths == 901 ? kUnsupported : kNotInteger;
    }
    if (tenths <= 30 || tenths == 800) block_.motion = tenths / 10;
    if (tenths == 40) block_.dwell = true;
    if (tenths == 100 || tenths == 280 || tenths == 300 || tenths == 920) block_.other_axis_use = true;
    if (tenths == 900 || tenths == 910) absolute_ = tenths == 900;
    if (tenths == 200 || tenths == 210) unit_ = tenths == 200 ? 25.4F : 1.0F;
    const auto group = kGroups.find(tenths);
    return group == kGroups.end() ? kUnsupported : enter(group->second);
  }

  int take_m(float value) {
    if (value != std::floor(value)) return kNotInteger;
    switch (static_cast<int>(value)) {
      case 0:
      case 1:
      case 2:
      case 30:
        return enter(104);
      case 3:
      case 4:
      case 5:
        return enter(107);
      case 7:
        return has_mist_ ? enter(108) : kUnsupported;
      case 8:
      case 9:
        return enter(108);
      default:
        return kUnsupported;
    }
  }

  bool has(char letter) const { return block_.values.count(letter) > 0; }
  float use(char letter) {
    const auto found = block_.values.find(letter);
    if (found == block_.values.end()) return 0;
    const float value = found->second;
    block_.values.erase(found);
    return value;
  }

  int check_block() {
    const bool axis_words = has('X') || has('Y') || has('Z');
    if (block_.motion >= 0 && block_.other_axis_use) return kTwoAxisCommands;
    if (block_.motion >= 0) motion_ = block_.motion;
    if (has('F')) feed_ = use('F') * unit_;
    use('S');
    use('T');
    use('N');
    if (block_.dwell) {
      if (!has('P')) return kMissingValue;
      use('P');
    }
    if (!block_.other_axis_use) {
      if (const int error = move(axis_words)) return error;
    } else {
      for (const char letter : {'X', 'Y', 'Z', 'L', 'P'}) use(letter);
    }
    return block_.values.empty() ? kOk : kUnusedWords;
  }

  int move(bool axis_words) {
    const bool asked = axis_words || block_.motion >= 0;
    if (!asked) return kOk;
    if (motion_ == 80) return axis_words ? kAxisWordsUnused : kOk;
    if (motion_ != 0 && feed_ == 0) return kNoFeed;
    const bool in_plane = has('X') || has('Y');
    float target[3];
    for (int axis = 0; axis < 3; ++axis) {
      const char letter = "XYZ"[axis];
      target[axis] = !has(letter) ? at_[axis] : use(letter) * unit_ + (absolute_ ? 0.0F : at_[axis]);
    }
    if (motion_ == 2 || motion_ == 3) {
      if (!axis_words) return kNoAxisWords;
      if (!in_plane) return kNoAxisInPlane;
      if (const int error = check_arc(target)) return error;
    }
    for (int axis = 0; axis < 3; ++axis) at_[axis] = target[axis];
    return kOk;
  }

  int check_arc(const float* target) {
    float x = target[0] - at_[0], y = target[1] - at_[1];
    if (has('R')) {
      const float radius = use('R') * unit_;
      if (x == 0 && y == 0) return kInvalidTarget;
      return 4.0F * radius * radius - x * x - y * y < 0 ? kArcRadius : kOk;
    }
    if (!has('I') && !has('J')) return kNoOffsets;
    const float i = use('I') * unit_, j = use('J') * unit_;
    x -= i;
    y -= j;
    const float end = std::sqrt(x * x + y * y), start = std::sqrt(i * i + j * j);
    const float difference = std::fabs(end - start);
    if (difference > 0.005F && (difference > 0.5F || difference > 0.001F * start)) return kInvalidTarget;
    return kOk;
  }

  bool has_mist_;
  Block block_;
  int motion_ = 0;
  bool absolute_ = true;
  float unit_ = 1;
  float feed_ = 0;
  float at_[3] = {0, 0, 0};
};

}  // namespace

std::vector<GrblFault> grbl_faults(const std::string& program, bool has_mist) {
  std::vector<GrblFault> faults;
  Grbl grbl(has_mist);
  std::istringstream lines(program);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (const int error = grbl.execute(line)) faults.push_back({number, error, line});
  }
  return faults;
}

}  // namespace clearcut::test_support
