// Repeated studies: resumable, repeatable, and true to what they say they measure.
#include "studies/genetic/genetic_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "studies/genetic/study_claims.h"
#include "studies/genetic/study_plans.h"

namespace clearcut::studies {
namespace {

GeneticStudyOptions small(int threads = 1) {
  GeneticStudyOptions options;
  options.runs = 3;
  options.generations = 25;
  options.side = 5;
  options.threads = threads;
  return options;
}

std::string csv_of(const std::string& name, const GeneticStudyOptions& options,
                   const std::string& earlier = "") {
  const GeneticStudy study = genetic_study(name, options);
  return study_csv(study, options, run_genetic_study(study, options, earlier));
}

/// The row of a study in docs/tour.md: its findings and its means. Empty where there is none.
std::vector<std::string> documented_row(const StudyPlan& plan) {
  const std::string page = read_file(CLEARCUT_SOURCE_DIR "/docs/tour.md", 1 << 20);
  const std::string begin = "| `" + plan.name + "`, " + plan.figure + " | ";
  const auto at = page.find(begin);
  if (at == std::string::npos) return {};
  const auto from = at + begin.size();
  std::string row = page.substr(from, page.find('\n', from) - from);
  return split(std::regex_replace(row, std::regex(R"( \|$)"), ""), '|');
}

/// "... runs each: 5: 98.75 ± 0.43, 10: 97.99 ± 0.17".
std::map<std::string, LevelMean> documented_means(const std::string& cell) {
  std::map<std::string, LevelMean> means;
  const std::regex level("(?:, |each: )([^,:]+): ([0-9.e-]+) ± ([0-9.e-]+)");
  for (std::sregex_iterator at(cell.begin(), cell.end(), level), end; at != end; ++at)
    means[std::regex_replace((*at)[1].str(), std::regex(R"(\\)"), "")] = {std::stod((*at)[2]),
                                                                          std::stod((*at)[3]), 2};
  return means;
}

/// Studies take minutes, so that their table is made by a script; here it is held that each has its row with all of its levels, and that
/// the verdict on every finding follows from the means beside it.
TEST(GeneticStudy, TheTableOfStudiesSaysWhatItsMeansSay) {
  int findings = 0;
  for (const StudyPlan& plan : study_plans()) {
    SCOPED_TRACE(plan.name);
    const auto row = documented_row(plan);
    ASSERT_EQ(row.size(), 2U);
    auto means = documented_means(row[1]);
    for (const std::string& level : plan.levels) EXPECT_TRUE(means.contains(level)) << level;
    EXPECT_NE(row[1].find(std::to_string(plan.middle.runs) + " runs each"), std::string::npos);
    StudyMeans of;
    of.mean = [&](const std::string& level) { return means[level]; };
    of.abscissa = [](const std::string& level) { return std::stod(level) * std::stod(level); };
    of.greatest_deviation = [](const std::string&) { return 0.0; };
    for (const StudyClaim& claim : plan.claims) {
      if (claim.kind == StudyClaim::Kind::kWithin) continue;  // by single runs
      const std::string text = claim_text(claim, of);
      const auto from = std::string("the text: ").size(), verdict = text.find("; here: ");
      const std::string said = text.substr(from, verdict - from) + ": " +
                               text.substr(verdict + 8, text.find(" (by") - verdict - 8) + " (";
      EXPECT_NE(row[0].find(said), std::string::npos) << said;
      ++findings;
    }
  }
  EXPECT_GE(findings, 14);
}

TEST(GeneticStudy, GivesTheSameRowsOnOneAndTwoThreads) {
  for (const std::string& name : genetic_study_names()) {
    if (name == "time") continue;  // its seconds differ
    GeneticStudyOptions options = small();
    if (name == "size") options.runs = 1;
    const std::string one = csv_of(name, options);
    options.threads = 2;
    EXPECT_EQ(one, csv_of(name, options)) << name;
  }
}

TEST(GeneticStudy, KeepsTheRowsOfAnEarlierFile) {
  GeneticStudyOptions options = small();
  const std::string whole = csv_of("selection", options);
  options.runs = 2;
  const std::string part = csv_of("selection", options);
  options.runs = 3;
  int runs = 0;
  options.progress = [&](int, int, const auto&) { ++runs; };
  EXPECT_EQ(csv_of("selection", options, part), whole);
  EXPECT_EQ(runs, 5);  // the third run of five levels
  // A file cut off inside its last line: the run it belongs to is done again.
  runs = 0;
  EXPECT_EQ(csv_of("selection", options, whole.substr(0, whole.size() - 9)), whole);
  EXPECT_EQ(runs, 1);
  runs = 0;
  EXPECT_EQ(csv_of("selection", options, whole), whole);
  EXPECT_EQ(runs, 0);
}

/// What was appended run by run, in any order, cut anywhere: the rest gives the same file.
TEST(GeneticStudy, GoesOnFromLinesAppendedRunByRun) {
  GeneticStudyOptions options = small(2);
  options.runs = 2;
  const GeneticStudy study = genetic_study("selection", options);
  const std::string none = study_csv(study, options, {});
  std::string appended = none;
  options.finished = [&](const std::vector<StudyRow>& rows) {
    appended += study_lines(study, options, rows);
  };
  const std::string whole = study_csv(study, options, run_genetic_study(study, options, ""));
  EXPECT_EQ(appended.size(), whole.size());
  options.finished = nullptr;
  const int total = static_cast<int>(study.levels.size()) * 2;
  EXPECT_EQ(missing_study_runs(study, options, none).size(), static_cast<std::size_t>(total));
  EXPECT_TRUE(missing_study_runs(study, options, appended).empty());
  EXPECT_EQ(study_csv(study, options, study_rows(study, options, appended)), whole);
  for (std::size_t size = none.size(); size < appended.size(); size += 97)
    EXPECT_EQ(csv_of("selection", options, appended.substr(0, size)), whole) << size;
  // Of the last run all is there but the end of its last number.
  EXPECT_EQ(missing_study_runs(study, options, appended.substr(0, appended.size() - 1)).size(), 1U);
}

TEST(GeneticStudy, OneRunAloneGivesItsRows) {
  const GeneticStudyOptions options = small();
  const GeneticStudy study = genetic_study("mutation", options);
  const std::atomic<bool> stop = false;
  std::string csv = study_csv(study, options, {});
  auto runs = missing_study_runs(study, options, csv);
  std::reverse(runs.begin(), runs.end());
  for (const StudyRun& run : runs)
    csv += study_lines(study, options, run_study_once(study, options, run, stop));
  EXPECT_EQ(study_csv(study, options, study_rows(study, options, csv)), csv_of("mutation", options));
}

TEST(GeneticStudy, KeepsRowsRatherThanMakingThemAnew) {
  const GeneticStudyOptions options = small();
  std::string csv = csv_of("mutation", options);
  const auto at = csv.find("\n", csv.find("\n") + 1);
  const auto before = csv.rfind(",", csv.rfind(",", csv.rfind(",", at) - 1) - 1);
  csv.replace(before + 1, 2, "11");  // another fitness in the first row
  EXPECT_EQ(csv_of("mutation", options, csv), csv);
}

TEST(GeneticStudy, RefusesRowsOfOtherSettings) {
  GeneticStudyOptions options = small();
  const std::string csv = csv_of("selection", options);
  EXPECT_THROW(csv_of("crossover", options, csv), InputError);
  options.side = 6;
  EXPECT_THROW(csv_of("selection", options, csv), InputError);
  options = small();
  options.seed = 2;
  EXPECT_THROW(csv_of("selection", options, csv), InputError);
}

/// A file that is no study, or was changed by hand, is refused rather than written over or counted twice.
TEST(GeneticStudy, RefusesWhatNoStudyWrote) {
  const GeneticStudyOptions options = small();
  const std::string csv = csv_of("spread", options);
  EXPECT_THROW(csv_of("spread", options, "a letter to somebody\n"), InputError);
  const std::string header = csv.substr(0, csv.find('\n') + 1);
  EXPECT_THROW(csv_of("spread", options, csv + csv.substr(header.size())), InputError);
  const std::string row = csv.substr(header.size(), csv.find('\n', header.size()) - header.size());
  for (const char* value : {"nan", "inf", "-1", "1e999", "x", ""}) {
    std::string bad = row;
    const auto end = bad.rfind(",,");
    bad.replace(bad.rfind(',', end - 1) + 1, end - bad.rfind(',', end - 1) - 1, value);
    EXPECT_THROW(csv_of("spread", options, header + bad + "\n"), InputError) << bad;
  }
}

TEST(GeneticStudy, TakesLineEndsOfOtherSystems) {
  const GeneticStudyOptions options = small();
  const std::string csv = csv_of("spread", options);
  std::string other;
  for (const char c : csv) other += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(csv_of("spread", options, other), csv);
}

TEST(GeneticStudy, RowsAreWhatTheySay) {
  GeneticStudyOptions options = small();
  const GeneticStudy study = genetic_study("population", options);
  const auto rows = run_genetic_study(study, options, "");
  std::set<long long> sampled;
  for (const StudyRow& row : rows) {
    EXPECT_LE(row.best, row.mean + 1e-9);
    EXPECT_LE(row.mean, row.worst + 1e-9);
    EXPECT_NEAR(row.fitness, 100 * 24 / row.best, 1e-9);
    EXPECT_LE(row.fitness, 100 + 1e-9);
    sampled.insert(row.generation);
  }
  EXPECT_EQ(sampled, (std::set<long long>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 20, 25}));  // eq. 5.1, the last
  EXPECT_EQ(rows.size(), study.levels.size() * 3 * sampled.size());
}

/// Eq. 4.11: E = z sigma / sqrt(N) with z = 3.
TEST(GeneticStudy, TheTableHasMeanAndError) {
  const GeneticStudyOptions options = small();
  const GeneticStudy study = genetic_study("spread", options);
  std::vector<StudyRow> rows;
  for (const double fitness : {90.0, 92.0, 97.0})
    rows.push_back({.run = static_cast<int>(rows.size()) + 1, .generation = 25, .fitness = fitness});
  const TextTable table = study_table(study, rows);
  ASSERT_EQ(table.rows.size(), 1u);
  EXPECT_EQ(table.rows[0][1], "3");
  EXPECT_EQ(table.rows[0][2], "93.000");
  EXPECT_EQ(table.rows[0][3], "6.245");  // 3 * sqrt(13) / sqrt(3)
  EXPECT_EQ(table.rows[0][4], "3.606");
  EXPECT_EQ(table.rows[0][7], "92.000");
  EXPECT_EQ(table.rows[0][10], "136");  // (3 * 3.606 / 0.93)^2, rounded up
  EXPECT_NE(study_svg(study, rows).find("</svg>"), std::string::npos);
}

TEST(GeneticStudy, SensitivityChangesOneFactorAtATime) {
  const GeneticStudy study = genetic_study("sensitivity", small());
  const auto& base = study.levels.front().genetic;
  for (std::size_t i = 1; i < study.levels.size(); ++i) {
    const auto& one = study.levels[i].genetic;
    const int changed = (one.population != base.population) + (one.neighbours != base.neighbours) +
                        (one.crossover_rate != base.crossover_rate) +
                        (one.mutation_rate != base.mutation_rate) + (one.most_shared != base.most_shared);
    EXPECT_EQ(changed, 1) << study.levels[i].name;
  }
}

/// Section 3.9: halved and doubled. Studies of operators cross a fifth of the children and draw first paths from two near points.
TEST(GeneticStudy, SensitivityHalvesAndDoubles) {
  std::map<std::string, order::GeneticOptions> of;
  for (const StudyLevel& level : genetic_study("sensitivity", small()).levels) of[level.name] = level.genetic;
  EXPECT_EQ(of["nothing"].breadth, 2);
  EXPECT_DOUBLE_EQ(of["nothing"].crossover_rate, 0.2);
  EXPECT_DOUBLE_EQ(of["crossover rate / 2"].crossover_rate, 0.1);
  EXPECT_DOUBLE_EQ(of["crossover rate * 2"].crossover_rate, 0.4);
  EXPECT_DOUBLE_EQ(of["mutation rate / 2"].mutation_rate, 0.5);
  EXPECT_DOUBLE_EQ(of["shared edges / 2"].most_shared, 0.1);
  EXPECT_EQ(of["population * 2"].population, 50);
  EXPECT_EQ(of["neighbours / 2"].neighbours, 12);
}

TEST(GeneticStudy, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(genetic_study("luck", {}), InputError);
  GeneticStudyOptions options;
  options.objective = "time";
  EXPECT_THROW(genetic_study("size", options), InputError);
  options = {};
  options.side = 1;
  EXPECT_THROW(genetic_study("spread", options), InputError);
}

}  // namespace
}  // namespace clearcut::studies
