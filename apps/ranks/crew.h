// Threads of one process for its share of the work.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace clearcut::ranks {

/// Does a task and gives its result; after a request to stop, it may throw or return anything. `input`: data needed
/// by the task.
using Perform = std::function<std::string(const std::string& task, const std::string& input,
                                          const std::atomic<bool>& stop)>;

class Crew {
 public:
  /// `ahead`: number of tasks that may wait for a thread.
  Crew(Perform perform, int threads, int ahead);
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  /// Requests running tasks to stop and waits for their end.
  ~Crew();

  void give(const std::string& task, const std::string& input);
  /// Number of further tasks that fit.
  int room() const;
  /// Tasks given whose results were not taken yet.
  std::vector<std::string> in_hand() const;
  /// Tasks with their results, each pair once.
  std::vector<std::pair<std::string, std::string>> take_results();
  /// Text of a task's exception; "" if there was none.
  std::string error() const;

 private:
  void work();

  Perform perform_;
  int most_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::pair<std::string, std::string>> waiting_;  ///< tasks with their inputs
  std::multiset<std::string> in_hand_;
  std::vector<std::pair<std::string, std::string>> results_;
  std::string error_;
  std::atomic<bool> stop_ = false;
  std::vector<std::jthread> threads_;
};

}  // namespace clearcut::ranks
