// The terminal and the signals that end a program: what differs between systems.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

namespace clearcut::cli {

/// Whether standard output, or standard error, is a terminal.
bool output_is_terminal();
bool errors_are_for_terminal();

/// Columns of the terminal that standard output is; nothing if it is none.
std::optional<std::size_t> terminal_columns();

/// From now on Ctrl-C and SIGTERM clear the line of progress, report that the work was stopped, and end the process
/// by the same signal (exit code 130 or 143 in a shell; on Windows by this code).
void say_when_interrupted();

/// Ctrl-C, SIGTERM and SIGHUP are held until this object ends, and then have their former effect; ignored ones stay
/// ignored.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

  /// Whether a signal has arrived; work under this object may take it as a request to end.
  static bool any();

 private:
  struct Before;
  std::unique_ptr<Before> before_;  ///< what the signals did
  int earlier_;                     ///< signal that arrived while an outer object held them
};

}  // namespace clearcut::cli
