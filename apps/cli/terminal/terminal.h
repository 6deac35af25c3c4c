// The terminal: width, colours, and the effect of Ctrl-C.
#pragma once

#include <cstddef>
#include <string>

namespace clearcut::cli {

/// Columns for help: those of the terminal, else COLUMNS, else 80; never below 40.
std::size_t text_width();

/// Columns for tables: the terminal's, else COLUMNS; in a file or a pipe tables are not broken, so that programs find
/// each row on one line.
std::size_t table_width();

/// Whether standard output shows colours: a terminal that is not "dumb", and NO_COLOR is unset or empty.
bool shows_colours();

/// The text with its verdicts in green, yellow or red if colours are shown.
std::string with_colours(const std::string& text);

/// From now on Ctrl-C and SIGTERM clear the line of progress, report that the work was stopped, and end the process
/// by the same signal (exit code 130 or 143 in a shell).
void say_when_interrupted();

}  // namespace clearcut::cli
