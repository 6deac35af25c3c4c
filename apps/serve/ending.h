// How the server ends, and what it may take of the machine: what differs between systems.
#pragma once

#include <memory>

namespace clearcut::serve {

/// Memory limit of this process for small requests; plans have their own limits.
void limit_memory();

/// Ctrl-C and the signals that ask this process to end. Must be made before the first thread.
class EndSignals {
 public:
  EndSignals();
  ~EndSignals();
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  /// Returns once the process is asked to end, or after release() by another thread.
  void wait();
  void release();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace clearcut::serve
