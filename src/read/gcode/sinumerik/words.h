// Words of a Sinumerik program, addresses of several letters, values behind '=', calls with arguments, and its cycles
// for holes, made into moves.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "read/gcode/control/control.h"

namespace clearcut::read::gcode {

/// What stands behind a word's name.
enum class SinumerikValue : unsigned char {
  kNone,         ///< SUPA
  kNumber,       ///< X10, CR=5
  kAbsolute,     ///< X=AC(5)
  kIncremental,  ///< X=IC(5)
  kText,         ///< T="MILL6", without the quotes
  kArguments     ///< CYCLE81(5,0,2,-3)
};

struct SinumerikWord {
  std::string name;  ///< in capitals, with the number that an '=' follows: "X", "CTOL", "S1"
  SinumerikValue kind = SinumerikValue::kNone;
  double number = 0;
  std::string text;
  std::vector<std::string> arguments;  ///< without blanks; texts keep their quotes
};

struct SinumerikBlock {
  bool optional = false;  ///< begins with '/'
  std::string_view comment;
  std::vector<SinumerikWord> words;
};

/// Refuses the block for that reason; does not return.
using RefuseBlock = std::function<void(const std::string& why)>;

/// Takes one line apart. At what computes (R parameters, expressions) `computes` is called, which does not return either.
SinumerikBlock sinumerik_block(std::string_view line, const RefuseBlock& refuse, const RefuseBlock& computes);

/// First line of a Sinumerik program that computes, jumps or loops; 0: none does.
int first_language_line(std::string_view text);

/// Whether a program has words that no other control reads: calls of cycles, G700 and G710, words of several letters with '='.
bool is_sinumerik(std::string_view text);

/// What a comment says of a tool that the program calls by its name, as programs begun anew do: `T="MILL" IS T2`.
std::string tool_comment(const std::string& name, int number);
/// Name and number in such a comment, absent in others.
std::optional<std::pair<std::string, int>> named_tool_in(std::string_view comment);

/// CYCLE81 to CYCLE85, CYCLE89 and CYCLE840.
bool is_sinumerik_hole(const std::string& name);

/// Refuses a call that cannot be understood, when it is met and not first at a hole.
void check_sinumerik_hole(Control& control, const SinumerikWord& call);

/// The hole where the tool stands: down to where feeding begins, to the bottom as the cycle says, and up to the return plane.
void make_sinumerik_hole(Control& control, const SinumerikWord& call);

}  // namespace clearcut::read::gcode
