// The two exceptions that leave the library. Undesired results (uncut corner, no tool fits) are data,
// not exceptions; broken promises inside are assertions (CLEARCUT_ASSERT).
#pragma once

#include <stdexcept>
#include <string>

namespace clearcut::inline base {

/// A bad file, bad arguments or an impossible job. One line for the user: "place: fault, and remedy".
/// Maps to exit code 2.
class InputError : public std::runtime_error {
 public:
  /// `place` is "file:line", "file: #123", an option name, or empty.
  InputError(const std::string& place, const std::string& what_and_what_to_do)
      : std::runtime_error(place.empty() ? what_and_what_to_do : place + ": " + what_and_what_to_do) {}
};

/// A promise inside was broken. Maps to exit code 3.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] inline void throw_broken_promise(const char* promise, const char* file, int line) {
  throw InternalError(std::string(file) + ":" + std::to_string(line) + ": broken promise: " + promise);
}

}  // namespace clearcut::inline base

#define CLEARCUT_ASSERT(promise)                                                    \
  do {                                                                              \
    if (!(promise)) ::clearcut::throw_broken_promise(#promise, __FILE__, __LINE__); \
  } while (false)
