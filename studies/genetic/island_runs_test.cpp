// Studies on islands: the rows are the same however their epochs are done, and what is done is not done again.
#include "studies/genetic/island_runs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "base/error.h"
#include "base/random.h"

namespace clearcut::studies {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class Memory : public StateStore {
 public:
  std::vector<std::string> names() const override {
    std::vector<std::string> all;
    for (const auto& entry : texts) all.push_back(entry.first);
    return all;
  }
  std::optional<std::string> read(const std::string& name) const override {
    const auto found = texts.find(name);
    return found == texts.end() ? std::nullopt : std::optional(found->second);
  }
  void write(const std::string& name, const std::string& text) override { texts[name] = text; }
  void erase(const std::string& name) override { texts.erase(name); }

  std::map<std::string, std::string> texts;
};

GeneticStudyOptions small(order::IslandOptions islands = {3, 10, 1}) {
  GeneticStudyOptions options;
  options.runs = 2;
  options.generations = 45;  // the last epoch is shorter
  options.side = 5;
  options.threads = 1;
  options.islands = islands;
  return options;
}

std::string serial(const std::string& name, const GeneticStudyOptions& options) {
  const GeneticStudy study = genetic_study(name, options);
  return study_csv(study, options, run_genetic_study(study, options, ""));
}

/// Does the tasks of a study in an order that `seed` gives, and stops after `most`.
class Pieces {
 public:
  Pieces(const std::string& name, const GeneticStudyOptions& options)
      : options_(options), study_(genetic_study(name, options)), csv_(study_csv(study_, options_, {})) {
    options_.finished = [this](const std::vector<StudyRow>& rows) {
      csv_ += study_lines(study_, options_, rows);
    };
  }

  void run(std::uint64_t seed, int most = 1 << 20) {
    const std::atomic<bool> stop = false;
    Random random(seed);
    IslandRuns runs(study_, options_, csv_, store);
    std::vector<std::string> tasks = runs.tasks();
    for (; !tasks.empty() && most > 0; --most) {
      const auto at = tasks.begin() + static_cast<std::ptrdiff_t>(random.below(tasks.size()));
      const std::string task = *at;
      tasks.erase(at);
      EXPECT_TRUE(given.insert(task).second) << task;
      const auto next = runs.finish(task, run_island_task(study_, options_, task, runs.input(task), stop));
      tasks.insert(tasks.end(), next.begin(), next.end());
      most_states = std::max(most_states, store.texts.size());
    }
  }
  std::string csv() const { return study_csv(study_, options_, study_rows(study_, options_, csv_)); }

  Memory store;
  std::set<std::string> given;  ///< all tasks so far
  std::size_t most_states = 0;

 private:
  GeneticStudyOptions options_;
  GeneticStudy study_;
  std::string csv_;
};

TEST(IslandRuns, GiveTheSameRowsOnOneAndTwoThreads) {
  GeneticStudyOptions options = small();
  const std::string one = serial("selection", options);
  EXPECT_THAT(one, HasSubstr(",generations,seed,islands,migrate_every,migrants,run,"));
  EXPECT_THAT(one, HasSubstr(",45,1,3,10,1,2,"));
  options.threads = 2;
  EXPECT_EQ(serial("selection", options), one);
}

TEST(IslandRuns, GiveTheSameRowsInAnyOrderOfTheirEpochs) {
  for (const int islands : {2, 3, 5}) {
    const std::string whole = serial("spread", small({islands, 10, 2}));
    for (const std::uint64_t seed : {1, 2, 3}) {
      Pieces pieces("spread", small({islands, 10, 2}));
      pieces.run(seed);
      EXPECT_EQ(pieces.csv(), whole) << islands << " " << seed;
      EXPECT_EQ(pieces.given.size(), static_cast<std::size_t>(2 * islands * 5));
      EXPECT_TRUE(pieces.store.texts.empty());
      EXPECT_LE(pieces.most_states, static_cast<std::size_t>(2 * 2 * islands));
    }
  }
}

/// Stopped after any number of epochs: no epoch is done twice.
TEST(IslandRuns, GoOnFromTheStatesThatAreThere) {
  const std::string whole = serial("spread", small());
  for (int most = 1; most < 30; most += 2) {
    Pieces pieces("spread", small());
    pieces.run(7, most);
    pieces.run(8, most);
    pieces.run(9);
    EXPECT_EQ(pieces.csv(), whole) << most;
    EXPECT_EQ(pieces.given.size(), 30U);
    EXPECT_TRUE(pieces.store.texts.empty());
  }
}

TEST(IslandRuns, DamagedStatesAreMadeAnew) {
  const std::string whole = serial("spread", small());
  Pieces pieces("spread", small());
  pieces.run(7, 12);
  for (auto& [name, text] : pieces.store.texts) text.resize(text.size() - 3);
  pieces.store.texts["0.99.0.1"] = "of a run that is not asked for";
  pieces.given.clear();
  pieces.run(8);
  EXPECT_EQ(pieces.csv(), whole);
  EXPECT_TRUE(pieces.store.texts.empty());
}

/// Whatever is taken away, what is left is either enough or made anew.
TEST(IslandRuns, StatesThatWereTakenAwayAreMadeAnew) {
  const std::string whole = serial("spread", small());
  Pieces pieces("spread", small());
  pieces.run(5, 21);
  const auto states = pieces.store.texts;
  ASSERT_GT(states.size(), 3U);
  ASSERT_LT(states.size(), 12U);
  for (unsigned left = 0; left < 1U << states.size(); left += 3) {
    Pieces again("spread", small());
    unsigned bit = 1;
    for (const auto& state : states) {
      if (left & bit) again.store.texts.insert(state);
      bit <<= 1;
    }
    again.run(left);
    ASSERT_EQ(again.csv(), whole) << left;
    EXPECT_TRUE(again.store.texts.empty());
  }
}

TEST(IslandRuns, StatesAndRowsOfOtherSettingsAreRefused) {
  Pieces pieces("spread", small());
  pieces.run(7, 12);
  GeneticStudyOptions other = small();
  other.seed = 2;
  Pieces others("spread", other);
  others.store.texts = pieces.store.texts;
  EXPECT_THAT([&] { others.run(1); },
              ThrowsMessage<InputError>(HasSubstr("other settings; begin a new file")));
  other = small();
  other.generations = 12;
  Pieces fewer("spread", other);
  fewer.store.texts = pieces.store.texts;
  EXPECT_THROW(fewer.run(1), InputError);
  EXPECT_EQ(fewer.store.texts, pieces.store.texts);  // nothing was erased
  const std::string rows = serial("spread", small());
  for (const order::IslandOptions islands : {order::IslandOptions{1}, {2, 10, 1}, {3, 9, 1}, {3, 10, 2}}) {
    const GeneticStudyOptions options = small(islands);
    EXPECT_THROW(study_rows(genetic_study("spread", options), options, rows), InputError);
  }
  EXPECT_THROW(genetic_study("spread", small({2, 10, 25})), InputError);
}

TEST(IslandRuns, WhatIsNoTaskIsRefused) {
  const std::atomic<bool> stop = false;
  const GeneticStudy study = genetic_study("spread", small());
  for (const char* task : {"", "1.1.0.1", "0.1.0", "0.1.0.1.", "0.1.-1.1", "0.1.0.2"})
    EXPECT_THROW(run_island_task(study, small(), task, "", stop), InputError) << task;
}

TEST(IslandRuns, TheTableSaysWhatTheyAre) {
  const GeneticStudy study = genetic_study("spread", small());
  const auto table = study_table(study, run_genetic_study(study, small(), ""));
  EXPECT_THAT(table.notes.front(),
              HasSubstr("3 islands, each of the population; every 10 generations the best 1"));
}

}  // namespace
}  // namespace clearcut::studies
