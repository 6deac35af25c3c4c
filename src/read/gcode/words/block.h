// One block of a word-address program, taken apart into words, and its G words by what they have to do with each
// other. Codes are in tenths: 911 is G91.1.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "read/gcode/words/lines.h"

namespace clearcut::read::gcode {

/// What only a reader of macros understands: parameters, expressions, jumps, loops, calls of subprograms.
class MacroError : public InputError {
 public:
  using InputError::InputError;
};

/// ",R5." and ",C5." of Fanuc, RND=5, CHR=5 and CHF=5 (here R, C and L) of Siemens: what becomes of the corner at the end of the block's move.
struct CornerWord {
  char letter = 'R';
  double value = 0;
  std::optional<double> feed = {};  ///< along it, FRC=
};

struct Block {
  int line = 0;
  bool optional = false;       ///< begins with '/'
  int delete_level = 0;        ///< n of "/n", one of several switches; 0: none is said
  bool percent = false;        ///< a lone '%'
  bool names_file = false;     ///< "$PART.MIN%" in front of programs of Okuma's
  bool names_program = false;  ///< "OPART"
  bool has_text = false;       ///< behind M0 or M1, as Marlin shows it
  std::vector<int> g;          ///< G words in tenths: 911 is G91.1
  std::vector<int> m;          ///< M words in tenths
  std::vector<std::string_view> comments;
  /// '@' and '^' of LinuxCNC: a place by its distance from the zero and its angle in degrees.
  std::optional<double> polar_radius, polar_angle;
  std::optional<CornerWord> corner;

  bool has(char letter) const { return (present_ >> (letter - 'A')) & 1U; }
  double value(char letter) const { return values_[static_cast<std::size_t>(letter - 'A')]; }
  bool has_axis() const { return has('X') || has('Y') || has('Z'); }
  bool is_polar() const { return polar_radius || polar_angle; }
  bool has_words() const {
    return present_ != 0 || !g.empty() || !m.empty() || is_polar() || corner || names_program;
  }

  void clear();
  void set(char letter, double value, bool has_point = true);
  void unset(char letter) { present_ &= ~(1U << static_cast<unsigned>(letter - 'A')); }
  /// The number was written without a decimal point.
  bool is_whole(char letter) const { return (whole_ >> (letter - 'A')) & 1U; }

 private:
  std::array<double, 26> values_{};
  std::uint32_t present_ = 0;
  std::uint32_t whole_ = 0;
};

/// Takes ",R" or ",C" of a block. Throws InputError(place, ...) for other letters and for a second one.
void set_corner(Block& block, char letter, double value, const std::string& place);

/// Cuts a text into blocks: white space, letter case, comments and checksums are dealt with here. Throws
/// InputError("file:line", ...) for what is not a word.
class BlockReader {
 public:
  BlockReader(std::string_view text, std::string file_name)
      : lines_(text), file_name_(std::move(file_name)) {}
  /// False at the end of the text.
  bool next(Block& block);
  std::string place(int line) const { return file_name_ + ":" + std::to_string(line); }

 private:
  void parse(std::string_view line, Block& block) const;
  void parse_comment(std::string_view line, std::size_t& at, Block& block) const;
  void parse_word(std::string_view line, std::size_t& at, Block& block) const;
  double parse_number(std::string_view line, std::size_t& at, char letter, int number) const;

  Lines lines_;
  std::string file_name_;
};

/// Two words of one modal group contradict each other within a block.
enum class Group {
  kUnknown,
  kMotion,
  kPlane,
  kDistance,
  kCenters,
  kFeedMode,
  kUnits,
  kReturn,
  kOffset,
  kOnce,  ///< words that use the axis words for something else than motion
  kCompensation,
  kSilent  ///< no effect on the path that is checked
};
Group group_of(int code);
/// Modal groups, whose words exclude each other.
bool is_modal(Group group);

/// "G91.1".
std::string g_word(int code);
bool has_g(const Block& block, int code);
/// The block's motion word, -1 without one. G80 gives way to any other.
int motion_in(const Block& block);

}  // namespace clearcut::read::gcode
