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
const ProgressClock::time_point kStart = ProgressClock::now();

double now_s() {
  return std::chrono::duration<double>(ProgressClock::now() - kStart).count();
}

std::string described(const Progress& at, double spent_s) {
  if (at.stage == Stage::kCertifying) return "certifying the program";
  std::string text = fmt::format("planning: {} of at most {} candidates", at.done, at.most);
  if (at.done > 0 && at.most > at.done) {
    const double share = static_cast<double>(at.done) / static_cast<double>(at.most);
    text += fmt::format(", at most {:.0f} s left", spent_s * (1 - share) / share);
  }
  return text;
}

}  // namespace

ProgressLine::ProgressLine(std::string hint)
    : hint_(std::move(hint)),
      terminal_(::isatty(STDERR_FILENO) != 0),
      began_s_(now_s()),
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

ProgressCallback ProgressLine::callback() {
  return [this](const Progress& at) { hear(at); };
}

void ProgressLine::hear(const Progress& at) {
  const std::lock_guard lock(mutex_);
  if (!at_ || at.stage != at_->stage) began_s_ = now_s();
  at_ = at;
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
  const std::string line =
      fmt::format("{} ({:.0f} s)", at_ ? described(*at_, now_s() - began_s_) : "preparing", elapsed_s);
  std::fprintf(stderr, terminal_ ? "\r\x1b[K%s" : "%s\n", line.c_str());
  std::fflush(stderr);
}

}  // namespace clearcut::cli
