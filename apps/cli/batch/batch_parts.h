// The parts of a batch, files, names of results, and keys of their dependencies, and their results as CSV, JSON and a
// page.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace clearcut::cli {

struct BatchPart {
  std::string file;                  ///< as given to `plan`
  std::vector<std::string> options;  ///< its own options, from its line of the list
  std::string name;                  ///< unique name of its results, below the output folder
};

/// The parts in a folder and the folders below it, by name, except in `output`; or those of a list: one part per
/// line, followed by its own options; '#' begins a comment; names are relative to the list. Throws InputError if
/// there are none.
std::vector<BatchPart> batch_parts(const std::string& folder_or_list, const std::string& output);

/// Key of all dependencies of a part's results: this program's version, the options, and the bytes of the part and of
/// every file named in options or a job.
std::string batch_key(const BatchPart& part, const std::vector<std::string>& options);

/// One part. Figures are those of its certificate; "" and 0 if there is none.
struct BatchRow {
  std::string name;
  std::string part;     ///< its file
  std::string verdict;  ///< CLEAN, CONDITIONAL, FAULTY; UNUSABLE (exit 2), CRASHED, TIMED OUT
  double time_s = 0, feed_mm = 0, rapid_mm = 0, uncut_mm = 0, gouge_mm = 0;
  std::size_t faults = 0;
  std::string message;  ///< message of the command, or the worst fault
  /// Share of its life that each cutter is used up by, by tool number; empty without --material of a metal.
  std::map<int, double> wear = {};
};

/// With or without a program.
bool has_program(const BatchRow& row);

std::string batch_csv(const std::vector<BatchRow>& rows);
std::string batch_json(const std::vector<BatchRow>& rows);
/// One page with a thumbnail of each part; program, certificate and picture are beside it, linked by name.
std::string batch_page(const std::vector<BatchRow>& rows, const std::string& title);
/// A row as texts, and back, the same to the last digit.
std::vector<std::string> row_fields(const BatchRow& row);
BatchRow row_of_fields(const std::vector<std::string>& fields);
/// "998 of 1000 CLEAN, 1 CRASHED, 1 TIMED OUT"
std::string batch_line(const std::vector<BatchRow>& rows);
/// For each cutter with a known wear, one line: its wear over all programs in their order, and the programs in which a
/// cutter of this number is used up; the next program has a fresh one.
/// "T1: 235 % of a cutter's life, used up in a (no. 3), b (no. 5)"
std::vector<std::string> tool_life_lines(const std::vector<BatchRow>& rows);

}  // namespace clearcut::cli
