#include "serve/ending.h"

#include <malloc.h>
#include <pthread.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

namespace clearcut::serve {

void limit_memory() {
  constexpr rlim_t kMost = rlim_t{6} << 30;
  rlimit both{};
  getrlimit(RLIMIT_AS, &both);
  both.rlim_cur = std::min(kMost, both.rlim_max);
  setrlimit(RLIMIT_AS, &both);
  mallopt(M_ARENA_MAX, 4);
}

struct EndSignals::State {
  sigset_t signals{};
};

EndSignals::EndSignals() : state_(std::make_unique<State>()) {
  sigemptyset(&state_->signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&state_->signals, signal);
  pthread_sigmask(SIG_BLOCK, &state_->signals, nullptr);
}

EndSignals::~EndSignals() = default;

void EndSignals::wait() {
  int signal = 0;
  sigwait(&state_->signals, &signal);
}

void EndSignals::release() {
  kill(getpid(), SIGTERM);
}

}  // namespace clearcut::serve
