// Open tasks, their current ranks, and the times of the ranks' last reports.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

namespace clearcut::ranks {

/// Times are seconds from any beginning.
class Ledger {
 public:
  Ledger(std::vector<std::string> tasks, int ranks, double now);

  bool complete() const { return holders_.empty(); }
  /// Notes a rank's report with its current tasks; an earlier ledger may have assigned them.
  void heard(int rank, const std::vector<std::string>& in_hand, double now);
  /// Marks a rank as dead.
  void bury(int rank) { is_silent_[static_cast<std::size_t>(rank)] = true; }
  /// Assigns up to `most` free tasks to `rank`.
  std::vector<std::string> hand_out(int rank, int most);
  /// Adds tasks that are now possible, before all waiting ones. Known tasks are left out.
  void add(const std::vector<std::string>& tasks);
  /// Whether the task was not finished before.
  bool finish(const std::string& task);
  /// Takes the tasks back from ranks with their last report before `since`; returns the newly silent ones.
  std::vector<int> take_back(double since);

 private:
  static constexpr int kNobody = -1;

  std::map<std::string, int> holders_;  ///< ranks of unfinished tasks
  std::deque<std::string> waiting_;     ///< in the order of distribution; may contain tasks already assigned
  std::vector<double> last_heard_;      ///< times by rank
  std::vector<bool> is_silent_;
};

}  // namespace clearcut::ranks
