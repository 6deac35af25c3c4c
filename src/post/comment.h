// Comments every control can take.
#pragma once

#include <string>
#include <string_view>

namespace clearcut {

/// Upper-case letters, digits and plain punctuation only: no parentheses (they nest), no '%' (ends a tape),
/// no
/// '!', '?', '~' (Grbl acts on them even inside comments), no leading word LinuxCNC would execute ("MSG,").
std::string plain_comment(std::string_view text);

/// The comment that opens a section: "OPERATION 3: POCKET1", without the number when the workingstep is
/// unknown. `workingstep` counts from 0, the comment from 1.
std::string operation_comment(int workingstep, std::string_view label);

}  // namespace clearcut
