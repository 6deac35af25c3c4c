// The Monte-Carlo studies of the Tour text (4.3, 6.2), repeated: many runs of its genetic algorithm on square
// lattices, whose optimum is known, with one thing changed at a time.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "order/genetic/genetic.h"
#include "order/genetic/islands.h"
#include "report/words/text_table.h"

namespace clearcut::studies {

/// Everything that decides what a run gives, but its number.
struct StudyLevel {
  std::string name;  ///< of the level: "pmx", "25", ...
  int side = 20;     ///< of the lattice, points
  std::string objective = "length";
  order::GeneticOptions genetic{};  ///< of each island
  order::IslandOptions islands{};
};

/// What a study measures of each run.
enum class StudyMetric {
  kFitness,   ///< optimum / value of the best, per cent
  kImproved,  ///< children better than both parents, per cent
  kSeconds,
};

struct GeneticStudy {
  std::string name;
  std::string figure;            ///< of the text
  std::string factor;            ///< what changes from level to level
  std::string published_size{};  ///< how much the text ran
  StudyMetric metric = StudyMetric::kFitness;
  std::vector<StudyLevel> levels{};
  int runs = 0;
};

/// One line of the CSV: a run after a generation (those of eq. 5.1).
struct StudyRow {
  int level = 0;  ///< index
  int run = 0;    ///< from 1
  long long generation = 0;
  double best = 0, mean = 0, worst = 0;  ///< values of the population
  double fitness = 0;                    ///< of the best, per cent
  double improved = 0;                   ///< per cent of all children so far; at the last generation only
  double seconds = 0;                    ///< of processor time, of the whole run; only in the study of time
};

struct GeneticStudyOptions {
  std::optional<int> runs;               ///< per level; default: the study's, far fewer than the text's
  std::optional<long long> generations;  ///< of each run
  std::optional<int> side;               ///< of the lattice, where that is not the factor
  std::string objective = "length";
  order::IslandOptions islands{};  ///< populations side by side in each run
  bool middle_size = false;        ///< minutes of work instead of seconds
  bool published_size = false;     ///< runs, generations and sides of the text: days of work
  std::uint64_t seed = 1;
  int threads = 0;  ///< 0: all cores
  std::stop_token
      cancel;  ///< asked to stop, the study ends with Cancelled; rows of finished runs were told before
  /// Called after each run with the runs done, the runs asked for, and a function that gives all rows so far;
  /// under a lock, from any thread.
  std::function<void(int done, int total, const std::function<std::vector<StudyRow>()>& rows)> progress;
  /// Called before that with the rows of the run itself, under the same lock: what keeps them loses no finished run.
  std::function<void(const std::vector<StudyRow>& rows)> finished;
};

/// One run of one level.
struct StudyRun {
  int level = 0;  ///< index
  int run = 0;    ///< from 1
};

const std::vector<std::string>& genetic_study_names();

/// The study with the options put into it. Throws InputError for an unknown name, or options without sense.
GeneticStudy genetic_study(const std::string& name, const GeneticStudyOptions& options);

/// Runs what `csv` (the file of an earlier call, may be empty) does not hold yet, on all cores, and gives all
/// rows, sorted. Run i of every level has the same seed, so levels differ by their factor alone. The same
/// options give the same rows on any number of threads, seconds excepted. Throws InputError when `csv` is of
/// another study or other settings.
std::vector<StudyRow> run_genetic_study(const GeneticStudy& study, const GeneticStudyOptions& options,
                                        const std::string& csv);

/// The runs that `csv` does not hold yet, in the order in which they are done. Throws as run_genetic_study.
std::vector<StudyRun> missing_study_runs(const GeneticStudy& study, const GeneticStudyOptions& options,
                                         const std::string& csv);

/// The rows of one run. Asked to stop, it gives fewer.
std::vector<StudyRow> run_study_once(const GeneticStudy& study, const GeneticStudyOptions& options,
                                     const StudyRun& run, const std::atomic<bool>& stop);

/// The rows of the complete runs in `csv`, sorted. Throws as run_genetic_study.
std::vector<StudyRow> study_rows(const GeneticStudy& study, const GeneticStudyOptions& options,
                                 const std::string& csv);

std::string study_csv(const GeneticStudy& study, const GeneticStudyOptions& options,
                      const std::vector<StudyRow>& rows);

/// The lines of these rows alone, to append to such a file. Its last line may be cut short: the run it belongs to is done again.
std::string study_lines(const GeneticStudy& study, const GeneticStudyOptions& options,
                        const std::vector<StudyRow>& rows);

/// Per level: runs, mean with its error E = z sigma / sqrt(N), z = 3 (eq. 4.11), standard deviation, quartiles.
TextTable study_table(const GeneticStudy& study, const std::vector<StudyRow>& rows);

/// Box plots of the levels, and the fitness over the generations with its spread; the study of spread has its
/// histogram too.
std::string study_svg(const GeneticStudy& study, const std::vector<StudyRow>& rows);

}  // namespace clearcut::studies
