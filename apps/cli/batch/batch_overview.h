// Results of the parts of a batch, as CSV, JSON and a page.
#pragma once

#include <string>
#include <vector>

namespace clearcut::cli {

/// One part. Figures are those of its certificate; "" and 0 if there is none.
struct BatchRow {
  std::string name;
  std::string part;     ///< its file
  std::string verdict;  ///< CLEAN, CONDITIONAL, FAULTY; UNUSABLE (exit 2), CRASHED, TIMED OUT
  double time_s = 0, feed_mm = 0, rapid_mm = 0, uncut_mm = 0, gouge_mm = 0;
  std::size_t faults = 0;
  std::string message;  ///< message of the command, or the worst fault
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

}  // namespace clearcut::cli
