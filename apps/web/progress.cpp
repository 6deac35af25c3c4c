// Progress of the web build, without a thread watching the work: lines of JSON from the work itself, five a second at
// most.
#include "terminal/progress.h"

#include <chrono>
#include <cstdio>
#include <utility>

#include "terminal/progress_text.h"

namespace clearcut::cli {
namespace {

constexpr double kRenewEvery = 0.2;  // s
double last_said_s = 0;              // one command runs in a process of the page

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

ProgressLine::ProgressLine(std::string hint, std::string advice)
    : hint_(std::move(hint)), advice_(std::move(advice)), json_(true), terminal_(false), began_s_(now_s()) {}

ProgressLine::~ProgressLine() = default;

void ProgressLine::end() {}

ProgressCallback ProgressLine::callback() {
  return [this](const Progress& at) { hear(at); };
}

void ProgressLine::hear(const Progress& at) {
  const bool is_next = !at_ || at.stage != at_->stage;
  const double now = now_s();
  if (is_next) began_s_ = now;
  at_ = at;
  if (!is_next && now - last_said_s < kRenewEvery) return;
  last_said_s = now;
  show(now);
}

void ProgressLine::search(const SearchProgress& at) {
  const double now = now_s();
  const bool is_first = !search_;
  search_ = at;
  if (!is_first && now - last_said_s < kRenewEvery) return;
  last_said_s = now;
  show(now);
}

void ProgressLine::count(std::size_t, std::size_t, const std::string&) {}

void ProgressLine::expect(const std::string&, double) {}

void ProgressLine::show(double now) {
  const double spent_s = now - began_s_;
  std::fprintf(stderr, "%s\n", (search_ ? json_of(*search_, spent_s) : json_of(*at_, spent_s)).c_str());
  std::fflush(stderr);
}

}  // namespace clearcut::cli
