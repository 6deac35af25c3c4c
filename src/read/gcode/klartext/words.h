// Klartext, cut into words: the words of path blocks, and Q parameters as values in them (FN functions).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/edge.h"
#include "read/gcode/motion/builder.h"

namespace clearcut::read::gcode {

inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// mm/min in the unit of F: millimetres, or in inch programs tenths of an inch. `unit`: mm in the program's unit of length.
inline double feed_unit(double unit) {
  return unit == 1 ? 1 : unit / 10;
}

/// A block without its number: upper-case words and the comment.
struct Words {
  std::vector<std::string> words;
  std::string_view comment;
};

/// The mark ~ of a block that goes on in the next line is no word.
Words words_of(std::string_view line);

/// Whether the text's first line that says anything is "BEGIN PGM".
bool is_klartext(std::string_view text);

/// What the words of a path block say. mm and degrees.
struct PathWords {
  Target absolute;
  Target incremental;
  std::optional<double> polar_angle, polar_step, polar_radius, radius, feed;
  std::optional<Turn> turn;
  /// R0, RL, RR: compensation ends or begins.
  enum class Radius : unsigned char { kNone, kLeft, kRight };
  std::optional<Radius> compensation;
  bool rapid = false;
  bool feed_of_tool = false;  ///< FAUTO: the feed that TOOL CALL states
  bool machine_frame = false;
  std::optional<double> retract;  ///< M140: mm up along the tool; infinite: to the end of the travel
  std::vector<int> m;
};

struct KlartextScale {
  double unit = 1;    ///< mm in the program's unit
  double longer = 0;  ///< mm, added to every absolute height (DL)
};

/// The words of a path block after the first. Throws InputError at the line for one that is not understood.
PathWords path_words(const std::vector<std::string>& words, const KlartextScale& scale,
                     const ToolpathBuilder& builder, int line);

/// A plain number with or without a sign. Throws InputError at the line for anything else.
double number_in(std::string_view text, const ToolpathBuilder& builder, int line);

/// What an FN block asks for besides a value.
struct FnBlock {
  std::optional<std::string> jump;  ///< label to go on at
};

class QParameters {
 public:
  /// Executes FN 0 to FN 13. Throws InputError(place, ...) for other functions, for parameters that nothing has set, and for FN 14,
  /// at which the control stops.
  FnBlock execute(const std::vector<std::string>& words, const std::string& place);
  /// Executes "Q1 = +5" and formulas, "Q1 = Q2 * 3"; false where the block sets a cycle's parameter, Q200 and on, or none.
  bool assign(const std::vector<std::string>& words, const std::string& place);
  /// Puts numbers in the place of Q parameters, "X+Q1" and "FQ2"; of "Q200=+Q5" behind the equals sign.
  void put_values(std::vector<std::string>& words, const std::string& place) const;

 private:
  double value_of(int parameter, const std::string& place) const;
  double operand(const std::string& text, std::size_t& at, const std::string& place) const;
  double computed(int function, const std::string& text, std::size_t& at, const std::string& place) const;

  std::map<int, double> values_;
};

}  // namespace clearcut::read::gcode
