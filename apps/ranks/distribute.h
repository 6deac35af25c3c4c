// Open tasks, their current ranks, and the times of the ranks' last reports.
//
// Work distributed to the processes of a job as they have room for it; no work is lost if one of them dies.
//
// Rank 0 distributes. Every rank, including rank 0, does tasks on its own threads and reports at least once in `beat`
// seconds: its free room, its current tasks, its finished tasks. Each report is answered, with or without tasks; a
// rank without tasks gets some as soon as there are any. A rank without reports for `silence` seconds has died:
// others do its current tasks. If rank 0 itself no longer answers, the next rank takes its place and computes the
// remaining tasks anew. A rank wrongly taken as dead does no harm: a task gives the same result anywhere, and the
// first result counts.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ranks/crew.h"
#include "ranks/ranks.h"

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

struct Work {
  /// All tasks not done yet. Called on rank 0, and again on a rank that takes its place.
  std::function<std::vector<std::string>()> tasks;
  /// Data needed by a task and possibly missing on its rank; called on the distributing rank and sent with the task.
  /// May be empty.
  std::function<std::string(const std::string& task)> input{};
  /// Called on any rank, from several threads. An exception ends the work on all ranks.
  Perform perform;
  /// Called on the distributing rank, once for each task.
  std::function<void(const std::string& task, const std::string& result)> finished;
  /// The same, called afterwards: returns tasks now possible. They come before all others. May be empty.
  std::function<std::vector<std::string>(const std::string& task)> next{};
  /// Called for deaths of ranks, on the distributing rank.
  std::function<void(const std::string& text)> say;
  int threads = 1;
  int ahead = 0;  ///< number of tasks waiting on a rank, so that short ones need not wait for an answer
};

/// Seconds.
struct Timing {
  double pause = 0.001;  ///< between two checks for messages, so that waiting takes no processor time
  double beat = 1;       ///< longest time between two reports
  double silence = 10;   ///< after which a rank counts as dead
  double first = 300;    ///< the same before the first answer: reading finished work takes time
};

struct Outcome {
  bool leads = false;      ///< this rank distributed at the end, and has all results
  bool some_died = false;  ///< whether ranks died, as far as known
};

/// Returns on every rank when all is done. Throws InputError with the text of a task's exception, on the distributing
/// rank.
Outcome distribute(Ranks& ranks, const Work& work, const Timing& timing = {});

/// Shares work among the processes of an MPI job, calls `write` on the rank with the results, and leaves the job;
/// returns the exit code of `write`, or 0.
int on_mpi_ranks(const std::function<Outcome(Ranks& ranks)>& work, const std::function<int()>& write);

}  // namespace clearcut::ranks
