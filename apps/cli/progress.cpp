#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <utility>

namespace clearcut::cli {
namespace {

using ProgressClock = std::chrono::steady_clock;
constexpr double kQuiet = 1;  // s before anything is said on a terminal
constexpr double kQuietElsewhere = 3;
constexpr double kLineEvery = 5;     // s between lines where no terminal shows them
constexpr double kRenewEvery = 0.2;  // s between renewals on a terminal
constexpr double kSettled = 0.02;    // share done from which the time left is worth saying

const ProgressClock::time_point kStart = ProgressClock::now();

double now_s() {
  return std::chrono::duration<double>(ProgressClock::now() - kStart).count();
}

std::string left(double share, double spent_s) {
  if (share < kSettled) return "";
  return fmt::format(", about {:.0f} s left of it", spent_s * (1 - share) / share);
}

}  // namespace

ProgressLine::ProgressLine(std::string hint)
    : hint_(std::move(hint)),
      terminal_(::isatty(STDERR_FILENO) != 0),
      began_s_(now_s()),
      listener_([this](const std::string& what, double share) { hear(what, share); }),
      watcher_([this] { watch(); }) {}

ProgressLine::~ProgressLine() {
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
  }
  stop_.notify_all();
  watcher_.join();
  if (shown_ && terminal_) std::fputs("\r\x1b[K", stderr);
}

void ProgressLine::hear(const std::string& what, double share) {
  const std::lock_guard lock(mutex_);
  if (what != what_) began_s_ = now_s();
  what_ = what;
  share_ = share;
}

void ProgressLine::watch() {
  const double start = now_s();
  std::unique_lock lock(mutex_);
  double wait = terminal_ ? kQuiet : kQuietElsewhere;
  while (!stop_.wait_for(lock, std::chrono::duration<double>(wait), [&] { return stopped_; })) {
    show(now_s() - start);
    wait = terminal_ ? kRenewEvery : kLineEvery;
  }
}

void ProgressLine::show(double elapsed_s) {
  if (!shown_ && !hint_.empty()) std::fprintf(stderr, "%s\n", hint_.c_str());
  shown_ = true;
  const std::string line = fmt::format("{}: {:.0f} % after {:.0f} s{}", what_.empty() ? "preparing" : what_,
                                       100 * share_, elapsed_s, left(share_, now_s() - began_s_));
  std::fprintf(stderr, terminal_ ? "\r\x1b[K%s" : "%s\n", line.c_str());
  std::fflush(stderr);
}

}  // namespace clearcut::cli
