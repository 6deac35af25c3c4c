#include "ranks/distribute.h"

#include <clearcut/error.h>
#include <fmt/format.h>

#include <chrono>
#include <iterator>
#include <optional>
#include <thread>
#include <utility>

namespace clearcut::ranks {

Ledger::Ledger(std::vector<std::string> tasks, int ranks, double now)
    : last_heard_(static_cast<std::size_t>(ranks), now), is_silent_(static_cast<std::size_t>(ranks)) {
  for (std::string& task : tasks) {
    if (holders_.emplace(task, kNobody).second) waiting_.push_back(std::move(task));
  }
}

void Ledger::heard(int rank, const std::vector<std::string>& in_hand, double now) {
  last_heard_[static_cast<std::size_t>(rank)] = now;
  is_silent_[static_cast<std::size_t>(rank)] = false;
  for (const std::string& task : in_hand) {
    const auto held = holders_.find(task);
    if (held != holders_.end() && held->second == kNobody) held->second = rank;
  }
}

std::vector<std::string> Ledger::hand_out(int rank, int most) {
  std::vector<std::string> given;
  while (static_cast<int>(given.size()) < most && !waiting_.empty()) {
    const std::string task = std::move(waiting_.front());
    waiting_.pop_front();
    const auto held = holders_.find(task);
    if (held == holders_.end() || held->second != kNobody) continue;
    held->second = rank;
    given.push_back(task);
  }
  return given;
}

void Ledger::add(const std::vector<std::string>& tasks) {
  auto place = waiting_.begin();
  for (const std::string& task : tasks) {
    if (holders_.emplace(task, kNobody).second) place = std::next(waiting_.insert(place, task));
  }
}

bool Ledger::finish(const std::string& task) {
  return holders_.erase(task) > 0;
}

std::vector<int> Ledger::take_back(double since) {
  std::vector<int> silent;
  for (std::size_t rank = 0; rank < last_heard_.size(); ++rank) {
    if (is_silent_[rank] || last_heard_[rank] >= since) continue;
    is_silent_[rank] = true;
    silent.push_back(static_cast<int>(rank));
    for (auto& [task, holder] : holders_) {
      if (holder != static_cast<int>(rank)) continue;
      holder = kNobody;
      waiting_.push_front(task);
    }
  }
  return silent;
}

namespace {

using Clock = std::chrono::steady_clock;
using Results = std::vector<std::pair<std::string, std::string>>;

/// Report of a rank to the distributing one.
struct Report {
  int room = 0;
  std::vector<std::string> in_hand;
  Results results;
  std::string error;
};

constexpr const char* kReport = "report";
constexpr const char* kTasks = "tasks";  // the answer to a report
constexpr const char* kMore = "more";    // tasks that became possible afterwards
constexpr const char* kEnd = "end";
constexpr const char* kSomeDied = "some died";

std::string text_of(const Report& report) {
  std::vector<std::string> results;
  for (const auto& [task, result] : report.results) {
    results.push_back(task);
    results.push_back(result);
  }
  return pack({kReport, std::to_string(report.room), pack(report.in_hand), pack(results), report.error});
}

Report report_of(const std::vector<std::string>& fields) {
  Report report{std::stoi(fields.at(1)), unpack(fields.at(2)), {}, fields.at(4)};
  const auto results = unpack(fields.at(3));
  for (std::size_t i = 0; i + 1 < results.size(); i += 2)
    report.results.emplace_back(results[i], results[i + 1]);
  return report;
}

class Distribution {
 public:
  Distribution(Ranks& ranks, const Work& work, const Timing& timing)
      : ranks_(ranks), work_(work), timing_(timing), crew_(work.perform, work.threads, work.ahead) {}

  Outcome run() {
    try {
      return run_to_the_end();
    } catch (const InputError&) {
      tell_end();
      throw;
    }
  }

 private:
  Outcome run_to_the_end() {
    if (ranks_.number() == 0) lead();
    while (!is_over_) {
      while (auto message = is_over_ ? std::nullopt : ranks_.receive()) hear(*message);
      if (is_over_) break;
      ledger_ ? serve() : follow();
      std::this_thread::sleep_for(std::chrono::duration<double>(timing_.pause));
    }
    return {ledger_.has_value(), some_died_};
  }

  double now() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }

  void lead() {
    leader_ = ranks_.number();
    if (leader_ > 0) {
      some_died_ = true;
      work_.say(fmt::format("rank {} has not been heard of for {} s; rank {} takes its place", leader_ - 1,
                            timing_.silence, leader_));
    }
    ledger_.emplace(work_.tasks(), ranks_.count(), now());
    room_.assign(static_cast<std::size_t>(ranks_.count()), 0);
    // A rank taking another's place first waits for reports on the others' current tasks.
    hands_out_from_ = leader_ == 0 ? 0 : now() + 2 * timing_.beat;
    for (int rank = 0; rank < leader_; ++rank) ledger_->bury(rank);
    ledger_->heard(leader_, crew_.in_hand(), now());
    for (const auto& [task, result] : std::exchange(unanswered_, {})) finish(task, result);
  }

  void hear(const Message& message) {
    const auto fields = unpack(message.text);
    if (fields.at(0) == kEnd) {
      is_over_ = true;
      some_died_ = some_died_ || fields.at(1) == kSomeDied;
      ledger_.reset();
    }
    if (fields.at(0) == kTasks && message.from == leader_ && waits_) take_answer(unpack(fields.at(1)));
    if (fields.at(0) == kMore && message.from == leader_) take(unpack(fields.at(1)));
    if (fields.at(0) != kReport) return;
    // A report to a non-distributing rank: its sender has found all earlier ranks dead.
    if (!ledger_) lead();
    answer(message.from, report_of(fields));
  }

  void answer(int from, const Report& report) {
    ledger_->heard(from, report.in_hand, now());
    for (const auto& [task, result] : report.results) finish(task, result);
    if (!report.error.empty()) throw InputError("", report.error);
    const auto tasks = given_to(from, report.room);
    room_[static_cast<std::size_t>(from)] = report.room - static_cast<int>(tasks.size()) / 2;
    ranks_.send(from, pack({kTasks, pack(tasks)}));
  }

  /// Tasks for a rank, each followed by its input.
  std::vector<std::string> given_to(int rank, int room) {
    std::vector<std::string> tasks;
    if (now() < hands_out_from_) return tasks;
    for (const std::string& task : ledger_->hand_out(rank, room)) {
      tasks.push_back(task);
      tasks.push_back(work_.input ? work_.input(task) : "");
    }
    return tasks;
  }

  void finish(const std::string& task, const std::string& result) {
    if (!ledger_->finish(task)) return;
    work_.finished(task, result);
    if (work_.next) ledger_->add(work_.next(task));
  }

  /// Sends new tasks to ranks with free room.
  void give_what_came_up() {
    for (int rank = 0; rank < ranks_.count(); ++rank) {
      int& room = room_[static_cast<std::size_t>(rank)];
      if (room == 0) continue;
      const auto tasks = given_to(rank, room);
      room -= static_cast<int>(tasks.size()) / 2;
      if (!tasks.empty()) ranks_.send(rank, pack({kMore, pack(tasks)}));
    }
  }

  void tell_end() {
    for (int rank = 0; rank < ranks_.count(); ++rank) {
      if (rank != ranks_.number()) ranks_.send(rank, pack({kEnd, some_died_ ? kSomeDied : ""}));
    }
  }

  /// One round of the distributing rank.
  void serve() {
    const int self = ranks_.number();
    for (const auto& [task, result] : crew_.take_results()) finish(task, result);
    if (const std::string error = crew_.error(); !error.empty()) throw InputError("", error);
    ledger_->heard(self, {}, now());
    take(given_to(self, crew_.room()));
    give_what_came_up();
    for (const int rank : ledger_->take_back(now() - timing_.silence)) {
      some_died_ = true;
      room_[static_cast<std::size_t>(rank)] = 0;
      work_.say(
          fmt::format("rank {} has not been heard of for {} s; others do its work", rank, timing_.silence));
    }
    is_over_ = ledger_->complete();
    if (is_over_) tell_end();
  }

  /// One round of any other rank.
  void follow() {
    const double time = now();
    if (waits_) {
      const double patience = last_answer_ ? timing_.silence : timing_.first;
      if (time - asked_ > patience) succeed();
      return;
    }
    for (auto& result : crew_.take_results()) unanswered_.push_back(std::move(result));
    const std::string error = crew_.error();
    const bool needs_work = crew_.room() > 0 && time > asks_again_;
    if (unanswered_.empty() && error.empty() && !needs_work && time - asked_ < timing_.beat) return;
    asked_ = time;
    waits_ = true;
    ranks_.send(leader_, text_of({crew_.room(), crew_.in_hand(), unanswered_, error}));
  }

  void take_answer(const std::vector<std::string>& tasks) {
    waits_ = false;
    last_answer_ = now();
    unanswered_.clear();
    take(tasks);
    // Without tasks, asking continuously would only hinder others.
    if (tasks.empty()) asks_again_ = now() + timing_.beat / 4;
  }

  void take(const std::vector<std::string>& tasks) {
    for (std::size_t i = 0; i + 1 < tasks.size(); i += 2) crew_.give(tasks[i], tasks[i + 1]);
  }

  /// The distributing rank has died: the next rank takes over.
  void succeed() {
    waits_ = false;
    asked_ = 0;
    some_died_ = true;
    ++leader_;
    if (leader_ == ranks_.number()) lead();
  }

  Ranks& ranks_;
  const Work& work_;
  Timing timing_;
  Clock::time_point began_ = Clock::now();
  std::optional<Ledger> ledger_;  ///< on the distributing rank
  std::vector<int> room_;         ///< by rank: its room beyond its current tasks, on the distributing rank
  int leader_ = 0;
  double hands_out_from_ = 0;
  bool waits_ = false;  ///< for an answer to a report
  double asked_ = -1e9, asks_again_ = 0;
  std::optional<double> last_answer_;
  Results unanswered_;  ///< finished, not yet known to have been heard
  bool is_over_ = false, some_died_ = false;
  Crew crew_;  ///< the last member: its threads end first
};

}  // namespace

Outcome distribute(Ranks& ranks, const Work& work, const Timing& timing) {
  return Distribution(ranks, work, timing).run();
}

int on_mpi_ranks(const std::function<Outcome(Ranks& ranks)>& work, const std::function<int()>& write) {
  // Open MPI may wait forever for a dead rank. If none has died, the others arrive while the leader still writes.
  constexpr double kAtOnce = 2, kSoon = 10, kLater = 120;
  constexpr int kRefused = 2;
  const auto ranks = mpi_ranks();
  try {
    const Outcome outcome = work(*ranks);
    const int exit_code = outcome.leads ? write() : 0;
    const double patience = outcome.leads       ? (outcome.some_died ? kAtOnce : kSoon)
                            : outcome.some_died ? kSoon
                                                : kLater;
    ranks->leave(patience, exit_code);
    return exit_code;
  } catch (const InputError&) {
    ranks->leave(kSoon, kRefused);
    throw;
  }
}

}  // namespace clearcut::ranks
