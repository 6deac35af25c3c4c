#include "studies/genetic/genetic_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

#include "base/elementary.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "order/genetic/operators.h"
#include "order/genetic/selection.h"
#include "report/picture/chart.h"
#include "studies/genetic/study_plans.h"
#include "studies/genetic/study_rows.h"

namespace clearcut::studies {
namespace {

constexpr double kZ = 3;  // 99 % in the text's words (eq. 4.11)

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

/// What the text finds, and what these runs say of it.
void add_claims(TextTable& table, const GeneticStudy& study, const std::vector<StudyRow>& rows) {
  const std::vector<StudyClaim>& claims = study_plan(study.name).claims;
  const auto values_of = [&](const std::string& name) {
    for (std::size_t i = 0; i < study.levels.size(); ++i)
      if (study.levels[i].name == name) return metric_values(study, rows, static_cast<int>(i));
    return std::vector<double>();
  };
  StudyMeans means;
  means.mean = [&](const std::string& name) {
    const auto values = values_of(name);
    const Moments m = moments(values);
    return LevelMean{m.mean, m.error, static_cast<int>(values.size())};
  };
  means.greatest_deviation = [&](const std::string& name) {
    const auto values = values_of(name);
    const double mean = moments(values).mean;
    double greatest = 0;
    for (const double value : values) greatest = std::max(greatest, std::abs(value - mean));
    return greatest;
  };
  means.abscissa = [](const std::string& name) { return std::stod(name) * std::stod(name); };  // points
  for (const StudyClaim& claim : claims) table.notes.push_back(claim_text(claim, means));
  if (claims.empty()) table.notes.emplace_back("the text prints no finding of this study");
}

std::string islands_note(const order::IslandOptions& islands) {
  return fmt::format("{} islands, each of the population; {}", islands.islands,
                     islands.migrants == 0
                         ? "nothing moves between them"
                         : fmt::format("every {} generations the best {} of each move to the next",
                                       islands.migrate_every, islands.migrants));
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
  const StudySize& size = options.published_size ? plan.published
                          : options.middle_size  ? plan.middle
                                                 : plan.ours;
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
    level.islands = options.islands;
    order::check_islands(level.islands, level.genetic);
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

TextTable study_table(const GeneticStudy& study, const std::vector<StudyRow>& rows) {
  TextTable table;
  table.title = fmt::format("Tour {}: {}", study.figure, metric_name(study.metric));
  table.columns = {{study.factor, Align::kLeft},
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
  if (has_islands(study)) table.notes.push_back(islands_note(first.islands));
  table.notes.push_back(fmt::format(
      "{} generations of {}, objective {}; the text: {}", first.genetic.stop.rounds,
      study.factor == "side" ? std::string("each lattice") : fmt::format("a {0} x {0} lattice", first.side),
      first.objective, study.published_size));
  add_claims(table, study, rows);
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
