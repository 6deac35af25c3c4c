#include "terminal/signals_held.h"

#include <atomic>

namespace clearcut::cli {
namespace {

/// Several threads may write files at once, each under a guard of its own.
std::atomic<int> caught = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a handler may store to it");

}  // namespace

SignalsHeld::SignalsHeld() : earlier_(caught) {
  caught = 0;
  struct sigaction hold {};
  hold.sa_handler = [](int signal) { caught = signal; };
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    ::sigaction(kSignals[i], &hold, &before_[i]);
    if (before_[i].sa_handler == SIG_IGN) ::sigaction(kSignals[i], &before_[i], nullptr);
  }
}

SignalsHeld::~SignalsHeld() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &before_[i], nullptr);
  const int last = caught.exchange(0), now = last != 0 ? last : earlier_;
  if (now != 0) ::raise(now);
}

bool SignalsHeld::any() {
  return caught != 0;
}

}  // namespace clearcut::cli
