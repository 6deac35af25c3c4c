#include "terminal/terminal.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <string_view>

namespace clearcut::cli {

bool output_is_terminal() {
  return ::isatty(STDOUT_FILENO) != 0;
}

bool errors_are_for_terminal() {
  return ::isatty(STDERR_FILENO) != 0;
}

std::optional<std::size_t> terminal_columns() {
  winsize size{};
  if (output_is_terminal() && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    return size.ws_col;
  return std::nullopt;
}

namespace {

/// Only async-signal-safe calls. The temporary files of an output are held back from this (base/file.h).
void interrupted(int signal) {
  constexpr std::string_view kOnTerminal = "\r\x1b[Kclearcut: stopped\n", kElsewhere = "clearcut: stopped\n";
  const auto text = ::isatty(STDERR_FILENO) != 0 ? kOnTerminal : kElsewhere;
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

void say_when_interrupted() {
  struct sigaction stop {};
  stop.sa_handler = interrupted;
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction before {};
    // Work started with the signal ignored (nohup, a script's background) continues.
    const bool is_ignored = ::sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN;
    if (!is_ignored) ::sigaction(signal, &stop, nullptr);
  }
}

namespace {

constexpr std::array<int, 3> kSignals{SIGINT, SIGTERM, SIGHUP};

/// Several threads may write files at once, each under a guard of its own.
std::atomic<int> caught = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a handler may store to it");

}  // namespace

struct SignalsHeld::Before {
  std::array<struct sigaction, kSignals.size()> actions{};
};

SignalsHeld::SignalsHeld() : before_(std::make_unique<Before>()), earlier_(caught) {
  caught = 0;
  struct sigaction hold {};
  hold.sa_handler = [](int signal) { caught = signal; };
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    struct sigaction& before = before_->actions[i];
    ::sigaction(kSignals[i], &hold, &before);
    if (before.sa_handler == SIG_IGN) ::sigaction(kSignals[i], &before, nullptr);
  }
}

SignalsHeld::~SignalsHeld() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) ::sigaction(kSignals[i], &before_->actions[i], nullptr);
  const int last = caught.exchange(0), now = last != 0 ? last : earlier_;
  if (now != 0) ::raise(now);
}

bool SignalsHeld::any() {
  return caught != 0;
}

}  // namespace clearcut::cli
