// Work handed out to the processes of a job as they have room for it, none of it lost when one of them dies.
//
// Rank 0 hands out. Every rank, also that one, does tasks on threads of its own and reports at least once in `beat` seconds: what it
// has room for, what it has in hand, what it has finished. Each report is answered, with tasks or none; a rank that got none gets some as soon as there are. A rank that is not heard of for
// `silence` seconds has died: others do what it had in hand. Where rank 0 itself no longer answers, the next one takes its place and
// asks anew what is still to be done. A rank that only seemed dead does no harm: a task gives the same result anywhere, and the first counts.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ranks/crew.h"
#include "ranks/ranks.h"

namespace clearcut::ranks {

struct Work {
  /// All that is not done yet. Asked on rank 0, and again on one that takes its place.
  std::function<std::vector<std::string>()> tasks;
  /// What a task rests on and its rank may not have, on the rank that hands out; travels with the task. May be empty.
  std::function<std::string(const std::string& task)> input{};
  /// On any rank, from several threads. What it throws ends the work on all of them.
  Perform perform;
  /// On the rank that hands out, once for each task.
  std::function<void(const std::string& task, const std::string& result)> finished;
  /// The same, after that: tasks that can be done only now. They come before all others. May be empty.
  std::function<std::vector<std::string>(const std::string& task)> next{};
  /// Told of deaths, on the rank that hands out.
  std::function<void(const std::string& text)> say;
  int threads = 1;
  int ahead = 0;  ///< tasks that a rank may have waiting, so that short ones need not wait for an answer
};

/// Seconds.
struct Timing {
  double pause = 0.001;  ///< between two looks for messages, so that waiting takes no processor's time
  double beat = 1;       ///< longest time between two reports
  double silence = 10;   ///< after which a rank has died
  double first = 300;    ///< the same before the first answer: reading what is done already takes its time
};

struct Outcome {
  bool leads = false;      ///< this rank handed out at the end, and was told of all results
  bool some_died = false;  ///< as far as is known
};

/// Comes back on every rank when all is done. Throws InputError with what a task threw, on the rank that hands out.
Outcome distribute(Ranks& ranks, const Work& work, const Timing& timing = {});

/// Shares work among the processes of an MPI job, calls `write` on the rank that knows the results, and leaves the job; gives the exit
/// code, that of `write` or 0.
int on_mpi_ranks(const std::function<Outcome(Ranks& ranks)>& work, const std::function<int()>& write);

}  // namespace clearcut::ranks
