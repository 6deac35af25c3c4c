// Runs of a study on islands in pieces that can be done anywhere: one epoch of one island each. Its state is its result, which is kept
// where a later call finds it.
#pragma once

#include <atomic>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "studies/genetic/genetic_study.h"

namespace clearcut::studies {

/// Where the states of runs that are not finished are kept, by name. A text is there whole or not at all.
class StateStore {
 public:
  StateStore() = default;
  StateStore(const StateStore&) = delete;
  StateStore& operator=(const StateStore&) = delete;
  virtual ~StateStore() = default;

  virtual std::vector<std::string> names() const = 0;
  /// Nothing where there is none of that name.
  virtual std::optional<std::string> read(const std::string& name) const = 0;
  virtual void write(const std::string& name, const std::string& text) = 0;
  virtual void erase(const std::string& name) = 0;
};

/// What is done of the runs on islands that a file of rows does not hold yet. Its tasks are words without blanks.
class IslandRuns {
 public:
  /// What a task names.
  struct Piece {
    StudyRun run;
    order::Epoch epoch;
  };
  static std::string name_of(const Piece& piece);
  static std::optional<Piece> piece_of(const std::string& name);

  /// Goes on from the states in the store; those of runs that `csv` holds, and what cannot be read, are erased. All must outlive this.
  /// Throws as run_genetic_study, and where the store holds states of other settings.
  IslandRuns(const GeneticStudy& study, const GeneticStudyOptions& options, const std::string& csv,
             StateStore& store);

  /// All that can be done now, in the order in which it is best done.
  std::vector<std::string> tasks() const;
  /// What a task rests on.
  std::string input(const std::string& task) const;
  /// Keeps the result and gives what can be done only now. The rows of a run whose last task this was go to `options.finished`.
  std::vector<std::string> finish(const std::string& task, const std::string& result);
  int missing_runs() const { return static_cast<int>(progress_.size()); }

 private:
  using Key = std::pair<int, int>;  ///< run, level: the order in which runs are done

  const order::IslandOptions& islands(const StudyRun& run) const;
  long long last_epoch(const StudyRun& run) const;
  bool is_ready(const StudyRun& run, int island) const;
  /// As input() has it; nothing where it is not there or cannot be read.
  std::optional<std::string> state_text(const Piece& piece) const;
  void check_settings() const;
  void take_over(const Piece& piece);
  bool has_what_it_needs(const StudyRun& run) const;
  void forget(const StudyRun& run);
  void erase_if_done_with(const StudyRun& run, const order::Epoch& epoch);
  void finish_run(const StudyRun& run);

  const GeneticStudy& study_;
  const GeneticStudyOptions& options_;
  StateStore& store_;
  std::map<Key, std::vector<long long>> progress_;  ///< of missing runs: epochs done by each island
};

/// Does a task of IslandRuns with its input and gives its result. Throws InputError where the input is none of such a task. Asked to
/// stop, it may give anything.
std::string run_island_task(const GeneticStudy& study, const GeneticStudyOptions& options,
                            const std::string& task, const std::string& input, const std::atomic<bool>& stop);

}  // namespace clearcut::studies
