// Comments every control can take.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "model/part.h"

namespace clearcut::post {

/// Comment for the end of a program if the control has no word for it.
inline constexpr std::string_view kEndComment = "END OF PROGRAM";

/// Upper-case letters, digits and plain punctuation only: no parentheses (they nest), no '%' (ends a tape),
/// no
/// '!', '?', '~' (Grbl acts on them even inside comments), no leading word LinuxCNC would execute ("MSG,"), and one
/// blank between words.
std::string plain_comment(std::string_view text);

/// The same in pieces of at most `room` characters, broken between words if there is a blank; one empty piece of "".
std::vector<std::string> comment_pieces(std::string_view text, std::size_t room);

/// The comment at the beginning of a section: "OPERATION 3: POCKET1", without the number if `place`, its place in the
/// program, is 0.
std::string operation_comment(int place, std::string_view label);

/// A length in the program's unit: "6 MM", "0.25 IN"; "0.2362 IN = 6 MM" if inches are not exact.
std::string size_text(double mm, bool inch);

/// Shape of a cutter in addition to its diameter: " 60 DEG TIP 0.4 MM" of a cone, " R 1 MM" of a rounded corner, "
/// PITCH 1 LEFT HAND FLOATING HOLDER" of taps and thread mills.
std::string shape_words(const Tool& tool, bool inch);

/// "TOOL CHANGE T2: ENDMILL D6 MM", the tool as described in the part.
std::string tool_change_comment(const Part& part, int number, bool inch);

/// Number of a program named "1234" or "O1234"; 1 for any other name.
int program_number(std::string_view name);

}  // namespace clearcut::post
