// Which tasks are to be done, who has them in hand, and who was heard of when.
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
  /// A rank spoke, with these tasks in hand, which an earlier ledger may have given to it.
  void heard(int rank, const std::vector<std::string>& in_hand, double now);
  /// A rank that is known to be dead.
  void bury(int rank) { is_silent_[static_cast<std::size_t>(rank)] = true; }
  /// Up to `most` tasks that nobody has in hand; now `rank` has.
  std::vector<std::string> hand_out(int rank, int most);
  /// Tasks that can be done only now, before all that wait. Those that are known already are left out.
  void add(const std::vector<std::string>& tasks);
  /// Whether the task was not finished before.
  bool finish(const std::string& task);
  /// Takes the tasks back from ranks that were last heard of before `since`; gives those that were not silent so far.
  std::vector<int> take_back(double since);

 private:
  static constexpr int kNobody = -1;

  std::map<std::string, int> holders_;  ///< of unfinished tasks
  std::deque<std::string> waiting_;     ///< in the order to hand out; may name tasks that somebody has
  std::vector<double> last_heard_;      ///< by rank
  std::vector<bool> is_silent_;
};

}  // namespace clearcut::ranks
