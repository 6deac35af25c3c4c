#include "terminal/progress.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "terminal/output.h"
#include "terminal/progress_text.h"

namespace clearcut::cli {
namespace {

using ProgressClock = std::chrono::steady_clock;
constexpr double kQuiet = 1;  // s before the first output on a terminal
constexpr double kQuietElsewhere = 3;
constexpr double kLong = 10;         // s before advice for faster work is printed
constexpr double kLineEvery = 3;     // s between lines without a terminal
constexpr double kRenewEvery = 0.2;  // s between renewals on a terminal
const ProgressClock::time_point kStart = ProgressClock::now();

double now_s() {
  return std::chrono::duration<double>(ProgressClock::now() - kStart).count();
}

bool is_for_programs() {
  const char* wish = std::getenv("CLEARCUT_PROGRESS");
  return wish != nullptr && std::string_view(wish) == "json";
}

}  // namespace

bool is_watched() {
  return errors_are_for_terminal();
}

ProgressLine::ProgressLine(std::string hint, std::string advice)
    : hint_(std::move(hint)),
      advice_(std::move(advice)),
      json_(is_for_programs()),
      terminal_(!json_ && is_watched()),
      began_s_(now_s()),
      watcher_([this] { watch(); }) {}

ProgressLine::~ProgressLine() {
  end();
}

void ProgressLine::end() {
  if (!watcher_.joinable()) return;
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

void ProgressLine::search(const SearchProgress& at) {
  const std::lock_guard lock(mutex_);
  search_ = at;
}

void ProgressLine::count(std::size_t done, std::size_t of, const std::string& things) {
  const std::lock_guard lock(mutex_);
  if (!count_) began_s_ = now_s();
  if (!count_ || done != count_->done) counted_s_ = now_s();
  count_ = CountProgress{count_ ? count_->before : done, done, of, things};
}

void ProgressLine::expect(const std::string& work, double usual_s) {
  const std::lock_guard lock(mutex_);
  work_ = Work{work, usual_s};
}

void ProgressLine::row(const std::string& text) {
  // The line is renewed by another thread, which must not do so between its removal and the row.
  const std::lock_guard lock(mutex_);
  if (shown_ && terminal_) std::fputs("\r\x1b[K", stderr);
  print_line(text);
  std::fflush(stdout);
}

void ProgressLine::begin() {
  if (!shown_ && !hint_.empty()) std::fprintf(stderr, "%s\n", hint_.c_str());
  shown_ = true;
}

void ProgressLine::say(const std::string& line) {
  const std::lock_guard lock(mutex_);
  if (json_) return;
  begin();
  std::fprintf(stderr, "%s%s\n", terminal_ ? "\r\x1b[K" : "", line.c_str());
  std::fflush(stderr);
}

std::string ProgressLine::text() const {
  const double spent_s = now_s() - began_s_;
  if (work_ && !count_)
    return work_->name + (work_->usual_s > 0 ? fmt::format(", about {:g} s in all", work_->usual_s) : "");
  if (search_) return described(*search_, spent_s);
  if (!count_) return at_ ? described(*at_, spent_s) : "preparing";
  return (work_ ? work_->name + ": " : "") +
         described(*count_, time_left(*count_, spent_s, now_s() - counted_s_));
}

void ProgressLine::watch() {
  const double start = now_s();
  std::unique_lock lock(mutex_);
  double wait = json_ ? kRenewEvery : terminal_ ? kQuiet : kQuietElsewhere;
  while (!stop_.wait_for(lock, std::chrono::duration<double>(wait), [&] { return stopped_; })) {
    show(now_s() - start);
    wait = terminal_ || json_ ? kRenewEvery : kLineEvery;
  }
}

void ProgressLine::show(double elapsed_s) {
  if (json_) {
    const double spent_s = now_s() - began_s_;
    if (search_) std::fprintf(stderr, "%s\n", json_of(*search_, spent_s).c_str());
    if (at_) std::fprintf(stderr, "%s\n", json_of(*at_, spent_s).c_str());
    if (count_)
      std::fprintf(stderr, "%s\n",
                   json_of(*count_, time_left(*count_, spent_s, now_s() - counted_s_)).c_str());
    return;
  }
  begin();
  if (elapsed_s >= kLong && !advice_.empty()) {
    std::fprintf(stderr, terminal_ ? "\r\x1b[K%s\n" : "%s\n", advice_.c_str());
    advice_.clear();
  }
  const std::string line = fmt::format("{} ({:.0f} s)", text(), elapsed_s);
  std::fprintf(stderr, terminal_ ? "\r\x1b[K%s" : "%s\n", line.c_str());
  std::fflush(stderr);
}

}  // namespace clearcut::cli
