// What AP238 files hold, for those who are told that these are not read.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "read/part21/part21.h"

namespace clearcut::read::stepnc {

bool is_ap238(const P21File& file);

/// The workplans with what they are made of, in order, one line an element: "workplan MAIN (#10)", "  1  workingstep POCKET (#12)".
std::vector<std::string> ap238_lines(const P21File& file);

/// The same of a text; nothing where it is no AP238 file.
std::vector<std::string> ap238_lines(std::string_view text, const std::string& file_name);

}  // namespace clearcut::read::stepnc
