#include "studies/genetic/study_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "base/error.h"
#include "base/text.h"

namespace clearcut::studies {
namespace {

constexpr const char* kSettings =
    "study,level,objective,side,population,selection,crossover,mutation,replacement,generations,seed";
constexpr std::size_t kSettingsCount = 11;
/// Of studies on islands, after those.
constexpr const char* kIslandSettings = ",islands,migrate_every,migrants";
constexpr std::size_t kIslandSettingsCount = 3;
constexpr const char* kValues = ",run,generation,best,mean,worst,fitness_percent,improved_percent,seconds";

std::string header_of(bool islands) {
  return fmt::format("{}{}{}", kSettings, islands ? kIslandSettings : "", kValues);
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
std::vector<std::string> lines_of_csv(const std::string& csv, bool islands) {
  std::vector<std::string> lines = split(csv.substr(0, csv.rfind('\n') + 1), '\n');
  for (std::string& line : lines)
    if (line.ends_with('\r')) line.pop_back();
  if (lines.empty() || lines.front() == header_of(islands)) return lines;
  if (lines.front() == header_of(!islands))
    throw InputError("CSV:1", "comes from a study of other islands; begin a new file");
  throw InputError("CSV:1", "is not the first line of a study; give the file of a study, or a new name");
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

}  // namespace

bool has_islands(const GeneticStudy& study) {
  return !study.levels.empty() && study.levels.front().islands.islands > 1;
}

std::vector<StudyRow> in_order(const RowsOf& rows_of) {
  std::vector<StudyRow> all;
  for (const auto& entry : rows_of) all.insert(all.end(), entry.second.begin(), entry.second.end());
  return all;
}

std::string settings_text(const GeneticStudy& study, const StudyLevel& level, std::uint64_t seed) {
  const auto& g = level.genetic;
  const std::string settings =
      fmt::format("{},{},{},{},{},{},{},{},{},{},{}", study.name, level.name, level.objective, level.side,
                  g.population, g.selection, g.crossover, g.mutation, g.replacement, g.stop.rounds, seed);
  const auto& i = level.islands;
  return has_islands(study) ? fmt::format("{},{},{},{}", settings, i.islands, i.migrate_every, i.migrants)
                            : settings;
}

RowsOf rows_of_csv(const GeneticStudy& study, std::uint64_t seed, const std::string& csv) {
  RowsOf rows_of;
  if (csv.empty()) return rows_of;
  std::map<std::string, int> level_of;
  for (std::size_t i = 0; i < study.levels.size(); ++i)
    level_of[settings_text(study, study.levels[i], seed)] = static_cast<int>(i);
  const std::size_t settings_count = kSettingsCount + (has_islands(study) ? kIslandSettingsCount : 0);
  int line = 0;
  for (const std::string& text : lines_of_csv(csv, has_islands(study))) {
    if (++line == 1 || text.empty()) continue;
    const auto cells = split(text, ',');
    if (cells.size() != settings_count + 8) continue;  // cut short
    std::string settings = cells[0];
    for (std::size_t i = 1; i < settings_count; ++i) settings += "," + cells[i];
    const auto level = level_of.find(settings);
    if (level == level_of.end())
      throw InputError(fmt::format("CSV:{}", line),
                       "comes from another study or other settings; begin a new file");
    const auto values = cells.begin() + static_cast<std::ptrdiff_t>(settings_count);
    const StudyRow row = row_of({values, cells.end()}, level->second, line);
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

std::vector<StudyRow> study_rows(const GeneticStudy& study, const GeneticStudyOptions& options,
                                 const std::string& csv) {
  return in_order(rows_of_csv(study, options.seed, csv));
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
  return header_of(has_islands(study)) + "\n" + study_lines(study, options, rows);
}

}  // namespace clearcut::studies
