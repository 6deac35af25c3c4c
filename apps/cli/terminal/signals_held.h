// Delays signals that would end the program until an output is complete.
#pragma once

#include <array>
#include <csignal>
#include <cstddef>

namespace clearcut::cli {

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
  static constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> before_{};
  int earlier_;  ///< signal that arrived while an outer object held them
};

}  // namespace clearcut::cli
