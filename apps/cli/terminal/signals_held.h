// Signals that would end the program wait until something is whole.
#pragma once

#include <array>
#include <csignal>
#include <cstddef>

namespace clearcut::cli {

/// Ctrl-C, SIGTERM and SIGHUP are kept until this ends, and then do what they did before; those that were ignored stay so.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

  /// Whether one has come, which whoever works under this may take for a wish to end.
  static bool any();

 private:
  static constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> before_{};
  int earlier_;  ///< that came while an outer one held them
};

}  // namespace clearcut::cli
