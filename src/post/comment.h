// Comments every control can take.
#pragma once

#include <string>
#include <string_view>

#include "model/part.h"

namespace clearcut::post {

/// Says that a program ends where the control has no word for it.
inline constexpr std::string_view kEndComment = "END OF PROGRAM";

/// Upper-case letters, digits and plain punctuation only: no parentheses (they nest), no '%' (ends a tape),
/// no
/// '!', '?', '~' (Grbl acts on them even inside comments), no leading word LinuxCNC would execute ("MSG,").
std::string plain_comment(std::string_view text);

/// The comment that opens a section: "OPERATION 3: POCKET1", without the number when the workingstep is
/// unknown. `workingstep` counts from 0, the comment from 1.
std::string operation_comment(int workingstep, std::string_view label);

/// Of taps and thread mills what their diameter does not tell: " PITCH 1 LEFT HAND FLOATING HOLDER"; "" of other tools.
std::string thread_words(const Tool& tool);

/// "TOOL CHANGE T2: ENDMILL D6 MM", the tool as the part knows it.
std::string tool_change_comment(const Part& part, int number);

/// Number of a program named "1234" or "O1234"; 1 for any other name.
int program_number(std::string_view name);

}  // namespace clearcut::post
