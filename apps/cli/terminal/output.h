// Output of the commands, printed and written; the width of texts, and colours.
#pragma once

#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/text.h>

#include <cstddef>
#include <string>
#include <vector>

#include "terminal/terminal.h"

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

/// Diagnostics as lines on standard error: "repair: place: text". Notes only when `verbose`.
void print(const Diagnostics& diagnostics, bool verbose);
/// The same for warnings only: printed with an error that ends the command.
void print_warnings(const Diagnostics& diagnostics);
void print_line(const std::string& text);
/// Prints why one of several set-ups has no program, and what of it is not machined.
void print_left_out(int setup, const NothingToMachine& why, bool verbose);
/// Prints a message on standard error with the program's name before it, as one line.
void complain(std::string message);
/// Prints a table as wide as the terminal, or for a Markdown page.
void print_table(const TextTable& table, bool as_markdown = false);

/// The name of a file without its folder.
std::string file_name(const std::string& path);

/// All of the files or (InputError) none; those named "-" go to standard output, last. None of `inputs` (files read
/// for them) is replaced. Signals that end the program are delayed meanwhile, so that no temporary file is left.
void write_outputs(const std::vector<OutputFile>& files, const std::vector<std::string>& inputs);

}  // namespace clearcut::cli
