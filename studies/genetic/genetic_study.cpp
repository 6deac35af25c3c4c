#include "studies/genetic/genetic_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <mutex>

#include "base/elementary.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "base/text/format.h"
#include "order/genetic/crossover.h"
#include "order/genetic/mutation.h"
#include "order/genetic/selection.h"
#include "order/lattice.h"
#include "pipeline/tour/tour.h"
#include "report/picture/chart.h"
#include "studies/genetic/study_plans.h"

namespace clearcut::studies {
namespace {

constexpr double kZ = 3;  // 99 % in the text's words (eq. 4.11)
constexpr const char* kHeader =
    "study,level,objective,side,population,selection,crossover,mutation,replacement,generations,seed,"
    "run,generation,best,mean,worst,fitness_percent,improved_percent,seconds";
constexpr int kSettings = 11;  // columns before `run`

/// "population * 2": one factor of the algorithm halved or doubled.
void change_one(order::GeneticOptions& genetic, const std::string& change) {
  if (change == "nothing") return;
  const double factor = change.ends_with("* 2") ? 2 : 0.5;
  const std::string what = change.substr(0, change.size() - 4);
  const auto scaled = [&](int value) { return static_cast<int>(std::lround(value * factor)); };
  if (what == "population") genetic.population = scaled(genetic.population);
  if (what == "neighbours") genetic.neighbours = scaled(genetic.neighbours);
  if (what == "crossover rate") genetic.crossover_rate *= factor;
  if (what == "mutation rate") genetic.mutation_rate *= factor;
  if (what == "shared edges") genetic.most_shared *= factor;
}

void set_factor(StudyLevel& level, const std::string& factor, const std::string& value) {
  if (factor == "population") level.genetic.population = std::stoi(value);
  if (factor == "crossover rate") level.genetic.crossover_rate = std::stod(value);
  if (factor == "mutation rate") level.genetic.mutation_rate = std::stod(value);
  if (factor == "neighbours") level.genetic.neighbours = std::stoi(value);
  if (factor == "changed") change_one(level.genetic, value);
  if (factor == "side") level.side = std::stoi(value);
  if (factor == "selection") level.genetic.selection = value;
  if (factor == "crossover") level.genetic.crossover = value;
  if (factor == "mutation") level.genetic.mutation = value;
}

/// Of an open path through the whole lattice; the proofs are in docs/tour.md.
double lattice_optimum(const StudyLevel& level) {
  const int n = level.side;
  if (level.objective == "length") return n * n - 1;
  if (level.objective == "turns") return 2 * n - 2;
  return 90.0 * (2 * n - 2);
}

/// All columns that decide what a run gives, but its number.
std::string settings_text(const GeneticStudy& study, const StudyLevel& level, std::uint64_t seed) {
  const auto& g = level.genetic;
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{}", study.name, level.name, level.objective, level.side,
                     g.population, g.selection, g.crossover, g.mutation, g.replacement, g.stop.rounds, seed);
}

/// Runs of the same number share their seed whatever the level.
std::uint64_t seed_of_run(std::uint64_t seed, int run) {
  return seed * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(run);
}

/// Processor time of this thread, s, which other work on the machine does not lengthen; by the clock where there is none.
double thread_seconds() {
  std::timespec now{};
#ifdef CLOCK_THREAD_CPUTIME_ID
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
#else
  std::timespec_get(&now, TIME_UTC);
#endif
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<StudyRow> one_run(const GeneticStudy& study, int level_index, int run, std::uint64_t seed,
                              const std::atomic<bool>& stop) {
  const StudyLevel& level = study.levels[static_cast<std::size_t>(level_index)];
  order::Problem problem = order::lattice_problem(level.side, level.side);
  problem.shape = order::Shape::kOpenPath;
  order::GeneticOptions options = level.genetic;
  options.seed = seed_of_run(seed, run);
  options.stop.cancel = &stop;
  const double began_s = thread_seconds();
  const auto result = order::run_genetic(problem, *pipeline::objective_named(level.objective, 1000), options);
  const double spent_s = thread_seconds() - began_s;
  std::vector<StudyRow> rows;
  for (const auto& sample : result.samples) {
    StudyRow row{.level = level_index, .run = run, .generation = sample.generation, .best = sample.best};
    row.mean = sample.mean;
    row.worst = sample.worst;
    row.fitness = 100 * lattice_optimum(level) / sample.best;
    rows.push_back(row);
  }
  rows.back().improved =
      100 * static_cast<double>(result.improved) / static_cast<double>(std::max(1LL, result.children));
  if (study.metric == StudyMetric::kSeconds) rows.back().seconds = spent_s;
  return rows;
}

/// Rows by level and run.
using RowsOf = std::map<std::pair<int, int>, std::vector<StudyRow>>;

std::vector<StudyRow> in_order(const RowsOf& rows_of) {
  std::vector<StudyRow> all;
  for (const auto& entry : rows_of) all.insert(all.end(), entry.second.begin(), entry.second.end());
  return all;
}

/// A finite number of at least `least`.
template <class Number>
Number number(const std::string& text, int line, Number least) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || !(value >= least && value <= std::numeric_limits<Number>::max()))
    throw InputError(fmt::format("CSV:{}", line),
                     fmt::format("'{}' is not a number that a study writes; begin a new file", text));
  return value;
}

/// Lines without the carriage returns of some editors, and without one that does not end. What is no study is never taken for one,
/// and so never written over.
std::vector<std::string> lines_of_csv(const std::string& csv) {
  std::vector<std::string> lines = split(csv.substr(0, csv.rfind('\n') + 1), '\n');
  for (std::string& line : lines)
    if (line.ends_with('\r')) line.pop_back();
  if (!lines.empty() && lines.front() != kHeader)
    throw InputError("CSV:1", "is not the first line of a study; give the file of a study, or a new name");
  return lines;
}

StudyRow row_of(const std::vector<std::string>& values, int level, int line) {
  StudyRow row{.level = level, .run = number(values[0], line, 1)};
  row.generation = number(values[1], line, 0LL);
  row.best = number(values[2], line, 0.0);
  row.mean = number(values[3], line, 0.0);
  row.worst = number(values[4], line, 0.0);
  row.fitness = number(values[5], line, 0.0);
  if (!values[6].empty()) row.improved = number(values[6], line, 0.0);
  if (!values[7].empty()) row.seconds = number(values[7], line, 0.0);
  return row;
}

/// The complete runs of an earlier file; an unfinished one (a file cut short) is left out.
RowsOf rows_of_csv(const GeneticStudy& study, std::uint64_t seed, const std::string& csv) {
  RowsOf rows_of;
  if (csv.empty()) return rows_of;
  std::map<std::string, int> level_of;
  for (std::size_t i = 0; i < study.levels.size(); ++i)
    level_of[settings_text(study, study.levels[i], seed)] = static_cast<int>(i);
  int line = 0;
  for (const std::string& text : lines_of_csv(csv)) {
    if (++line == 1 || text.empty()) continue;
    const auto cells = split(text, ',');
    if (cells.size() != kSettings + 8) continue;  // cut short
    std::string settings = cells[0];
    for (std::size_t i = 1; i < kSettings; ++i) settings += "," + cells[i];
    const auto level = level_of.find(settings);
    if (level == level_of.end())
      throw InputError(fmt::format("CSV:{}", line),
                       "comes from another study or other settings; begin a new file");
    const StudyRow row = row_of({cells.begin() + kSettings, cells.end()}, level->second, line);
    std::vector<StudyRow>& run = rows_of[{row.level, row.run}];
    if (!run.empty() && row.generation <= run.back().generation)
      throw InputError(fmt::format("CSV:{}", line),
                       fmt::format("generation {} of run {} comes twice or out of order; begin a new file",
                                   row.generation, row.run));
    run.push_back(row);
  }
  std::erase_if(rows_of, [&](const auto& entry) {
    const auto& level = study.levels[static_cast<std::size_t>(entry.first.first)];
    return entry.second.back().generation != level.genetic.stop.rounds;
  });
  return rows_of;
}

/// Values of the metric, one a run.
std::vector<double> metric_values(const GeneticStudy& study, const std::vector<StudyRow>& rows, int level) {
  const long long last = study.levels[static_cast<std::size_t>(level)].genetic.stop.rounds;
  std::vector<double> values;
  for (const StudyRow& row : rows) {
    if (row.level != level || row.generation != last) continue;
    values.push_back(study.metric == StudyMetric::kFitness    ? row.fitness
                     : study.metric == StudyMetric::kImproved ? row.improved
                                                              : row.seconds);
  }
  return values;
}

struct Moments {
  double mean = 0, deviation = 0, error = 0;
};

Moments moments(const std::vector<double>& values) {
  Moments m;
  const auto n = static_cast<double>(values.size());
  for (const double value : values) m.mean += value / n;
  for (const double value : values) m.deviation += (value - m.mean) * (value - m.mean);
  m.deviation = values.size() > 1 ? std::sqrt(m.deviation / (n - 1)) : 0;
  m.error = kZ * m.deviation / std::sqrt(n);  // eq. 4.11
  return m;
}

/// Eq. 4.11 the other way round: how many runs make the error of the mean 1 % of it.
double runs_for_one_per_cent(const Moments& m) {
  return m.mean > 0 ? std::max(1.0, std::ceil(base::pow(kZ * m.deviation / (0.01 * m.mean), 2))) : 1;
}

std::string metric_name(StudyMetric metric) {
  return metric == StudyMetric::kFitness    ? "fitness, optimum / value, %"
         : metric == StudyMetric::kImproved ? "children better than both parents, %"
                                            : "processor time of all generations, s";
}

/// Mean fitness over the generations, between the smallest and the largest of all runs.
report::ChartCurve fitness_curve(const GeneticStudy& study, const std::vector<StudyRow>& rows, int level) {
  std::map<long long, std::vector<double>> at;
  for (const StudyRow& row : rows) {
    if (row.level == level && row.generation > 0) at[row.generation].push_back(row.fitness);
  }
  report::ChartCurve curve{.name = study.levels[static_cast<std::size_t>(level)].name};
  for (const auto& [generation, values] : at) {
    curve.x.push_back(static_cast<double>(generation));
    curve.y.push_back(moments(values).mean);
    curve.low.push_back(*std::min_element(values.begin(), values.end()));
    curve.high.push_back(*std::max_element(values.begin(), values.end()));
  }
  return curve;
}

}  // namespace

const std::vector<std::string>& genetic_study_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const StudyPlan& plan : study_plans()) all.push_back(plan.name);
    return all;
  }();
  return names;
}

GeneticStudy genetic_study(const std::string& name, const GeneticStudyOptions& options) {
  const StudyPlan& plan = study_plan(name);
  const std::string& objective = options.objective;
  if (objective != "length" && objective != "turns" && objective != "angle")
    throw InputError("--objective",
                     fmt::format("'{}' has no known optimum; use length, turns or angle", objective));
  const StudySize& size = options.published_size ? plan.published : plan.ours;
  GeneticStudy study{.name = plan.name, .figure = plan.figure, .factor = plan.factor, .metric = plan.metric};
  study.published_size =
      fmt::format("{} runs of {} generations", plan.published.runs, plan.published.generations);
  study.runs = options.runs.value_or(size.runs);
  const long long generations = options.generations.value_or(size.generations);
  if (study.runs < 1 || generations < 1) throw InputError("study", "needs at least 1 run of 1 generation");
  for (const std::string& value : plan.levels) {
    StudyLevel level{.name = value, .side = options.side.value_or(size.side), .objective = objective};
    level.genetic.stop.rounds = generations;
    level.genetic.patience = std::numeric_limits<long long>::max();
    // So that an operator shows itself: no plain first path, which is a sweep on lattices and all but the optimum;
    // one mutation a child, and a fifth of them crossed.
    level.genetic.breadth = 2;
    level.genetic.again_rate = 0;
    level.genetic.crossover_rate = 0.2;
    set_factor(level, plan.factor, value);
    if (level.side < 2 || level.side > 1000) throw InputError("--side", "lies between 2 and 1000");
    study.levels.push_back(level);
  }
  return study;
}

std::vector<StudyRun> missing_study_runs(const GeneticStudy& study, const GeneticStudyOptions& options,
                                         const std::string& csv) {
  const RowsOf rows_of = rows_of_csv(study, options.seed, csv);
  std::vector<StudyRun> missing;
  for (int run = 1; run <= study.runs; ++run) {
    for (int level = 0; level < static_cast<int>(study.levels.size()); ++level) {
      if (!rows_of.contains({level, run})) missing.push_back({level, run});
    }
  }
  return missing;
}

std::vector<StudyRow> run_study_once(const GeneticStudy& study, const GeneticStudyOptions& options,
                                     const StudyRun& run, const std::atomic<bool>& stop) {
  return one_run(study, run.level, run.run, options.seed, stop);
}

std::vector<StudyRow> study_rows(const GeneticStudy& study, const GeneticStudyOptions& options,
                                 const std::string& csv) {
  return in_order(rows_of_csv(study, options.seed, csv));
}

std::vector<StudyRow> run_genetic_study(const GeneticStudy& study, const GeneticStudyOptions& options,
                                        const std::string& csv) {
  RowsOf rows_of = rows_of_csv(study, options.seed, csv);
  const std::vector<StudyRun> missing = missing_study_runs(study, options, csv);
  const int total = static_cast<int>(study.levels.size()) * study.runs;
  int done = total - static_cast<int>(missing.size());
  std::mutex mutex;
  std::atomic<bool> stop = false;
  const std::stop_callback on_cancel(options.cancel, [&stop] { stop = true; });
  on_threads(options.threads, [&] {
    parallel_for(std::size_t{0}, missing.size(), [&](std::size_t i) {
      auto rows = run_study_once(study, options, missing[i], stop);
      throw_if_cancelled(options.cancel);  // a run that was cut short is none
      const std::lock_guard lock(mutex);
      if (options.finished) options.finished(rows);
      rows_of[{missing[i].level, missing[i].run}] = std::move(rows);
      ++done;
      if (options.progress) options.progress(done, total, [&] { return in_order(rows_of); });
    });
  });
  return in_order(rows_of);
}

std::string study_lines(const GeneticStudy& study, const GeneticStudyOptions& options,
                        const std::vector<StudyRow>& rows) {
  std::vector<std::string> settings;
  for (const StudyLevel& level : study.levels) settings.push_back(settings_text(study, level, options.seed));
  std::string lines;
  for (const StudyRow& row : rows) {
    const auto level = static_cast<std::size_t>(row.level);
    const bool last = row.generation == study.levels[level].genetic.stop.rounds;
    lines += fmt::format("{},{},{},{},{},{},{},{},{}\n", settings[level], row.run, row.generation,
                         trimmed(row.best, 6), trimmed(row.mean, 6), trimmed(row.worst, 6),
                         trimmed(row.fitness, 6), last ? trimmed(row.improved, 6) : "",
                         last && study.metric == StudyMetric::kSeconds ? trimmed(row.seconds, 6) : "");
  }
  return lines;
}

std::string study_csv(const GeneticStudy& study, const GeneticStudyOptions& options,
                      const std::vector<StudyRow>& rows) {
  return std::string(kHeader) + "\n" + study_lines(study, options, rows);
}

report::TextTable study_table(const GeneticStudy& study, const std::vector<StudyRow>& rows) {
  report::TextTable table;
  table.title = fmt::format("Tour {}: {}", study.figure, metric_name(study.metric));
  table.columns = {{study.factor, report::Align::kLeft},
                   {"runs"},
                   {"mean"},
                   {"E (99 %)"},
                   {"sigma"},
                   {"min"},
                   {"q1"},
                   {"median"},
                   {"q3"},
                   {"max"},
                   {"runs for E = 1 %"}};
  for (int level = 0; level < static_cast<int>(study.levels.size()); ++level) {
    const auto values = metric_values(study, rows, level);
    if (values.empty()) continue;
    const Moments m = moments(values);
    std::vector<std::string> cells{study.levels[static_cast<std::size_t>(level)].name,
                                   std::to_string(values.size())};
    for (const double value : {m.mean, m.error, m.deviation}) cells.push_back(fmt::format("{:.3f}", value));
    for (const double q : {0.0, 0.25, 0.5, 0.75, 1.0})
      cells.push_back(fmt::format("{:.3f}", report::quantile(values, q)));
    cells.push_back(fmt::format("{:.0f}", runs_for_one_per_cent(m)));
    table.add(cells);
  }
  const StudyLevel& first = study.levels.front();
  table.notes.push_back(fmt::format(
      "{} generations of {}, objective {}; the text: {}", first.genetic.stop.rounds,
      study.factor == "side" ? std::string("each lattice") : fmt::format("a {0} x {0} lattice", first.side),
      first.objective, study.published_size));
  return table;
}

std::string study_svg(const GeneticStudy& study, const std::vector<StudyRow>& rows) {
  const std::string title = fmt::format("Tour {} repeated: {}", study.figure, study.name);
  report::ChartPanel boxes{.title = title, .x_label = study.factor, .y_label = metric_name(study.metric)};
  report::ChartPanel curves{.title = "Fitness over the generations: mean, smallest and largest",
                            .x_label = "generation",
                            .y_label = "fitness of the best individual, %"};
  curves.log_x = true;
  for (int level = 0; level < static_cast<int>(study.levels.size()); ++level) {
    const auto values = metric_values(study, rows, level);
    if (values.empty()) continue;
    const std::string& name = study.levels[static_cast<std::size_t>(level)].name;
    boxes.boxes.push_back({name, values, moments(values).error});
    curves.curves.push_back(fitness_curve(study, rows, level));
  }
  if (study.factor != "none") return report::chart_svg({boxes, curves});
  report::ChartPanel histogram{.title = title, .x_label = metric_name(study.metric), .y_label = "runs"};
  histogram.samples = metric_values(study, rows, 0);
  return report::chart_svg({histogram, curves});
}

}  // namespace clearcut::studies
