// Clearcut's programs: the one that runs, and those beside it.
#pragma once

#include <string>
#include <vector>

namespace clearcut::inline base {

/// The path of the program that runs.
std::string own_program();

/// The name of a program's file: "clearcut-check", on Windows "clearcut-check.exe".
std::string program_file(const std::string& name);

/// The path of the program `name`: beside this one, else the first of these folders that contains the program. Empty
/// if none does.
std::string companion(const std::string& name, const std::string& place = "",
                      const std::string& other_place = "");

/// The words as the one line that Windows gives to a program, whose C library takes it apart: words with spaces or
/// quotation marks are quoted, and backslashes before a quotation mark doubled.
std::string command_line(const std::vector<std::string>& words);

}  // namespace clearcut::inline base
