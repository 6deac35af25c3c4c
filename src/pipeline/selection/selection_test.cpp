#include "pipeline/selection/selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "base/work_budget.h"
#include "model/options/strategy_entry.h"
#include "options/row.h"
#include "pipeline/selection/strategies.h"

namespace clearcut::pipeline {
namespace {

StrategyEntry named(const char* name) {
  StrategyEntry entry;
  entry.name = name;
  return entry;
}

std::vector<SelectionStep> one_step(std::vector<StrategyCandidate> selection) {
  StrategyCandidates candidates;
  candidates.competing = std::move(selection);
  return {{"pocket", 0, 5, MmPerMin::of(1000), candidates}};
}

TEST(Selection, AStrategyThatTakesTooMuchWorkIsLeftOutByNameAndTheOthersAnswer) {
  const StrategyEntry contour = named("contour"), zigzag = named("zigzag");
  const auto planner = [](int, const StrategyCandidate& candidate) {
    const WorkBudget budget(10);
    StepPlan plan;
    WorkBudget::spend(candidate.strategy->name == "contour" ? 11 : 10);
    plan.section.moves.emplace_back();
    plan.time_s = 1;
    return plan;
  };
  const Selection selection(one_step({{&contour, {}}, {&zigzag, {}}}), planner, 1);
  EXPECT_EQ(selection.candidate(0).strategy->name, "zigzag");
  EXPECT_FALSE(selection.section(0).moves.empty());
  EXPECT_EQ(selection.left_out(0), std::vector<std::string>{"contour"});
  EXPECT_EQ(selection.selections().front().candidates.back().outcome, Outcome::kTooMuchWork);
}

/// Both of two that are planned at once may find no memory; each is asked again alone.
TEST(Selection, AStrategyThatTakesTooMuchMemoryIsLeftOutByNameAndTheOthersAnswer) {
  const StrategyEntry contour = named("contour"), zigzag = named("zigzag");
  std::atomic<int> asked{0};
  const auto planner = [&](int, const StrategyCandidate& candidate) {
    if (++asked <= 2 || candidate.strategy->name == "contour") throw std::bad_alloc();
    StepPlan plan;
    plan.section.moves.emplace_back();
    plan.time_s = 1;
    return plan;
  };
  const Selection selection(one_step({{&contour, {}}, {&zigzag, {}}}), planner, 1);
  EXPECT_EQ(selection.candidate(0).strategy->name, "zigzag");
  EXPECT_EQ(selection.beyond_memory(0), std::vector<std::string>{"contour"});
  EXPECT_EQ(selection.selections().front().candidates.back().outcome, Outcome::kTooMuchMemory);
}

/// Planned again alone a strategy may have no passes: then it was not left out for want of memory.
TEST(Selection, WhatIsPlannedAgainIsToldByWhatItThenCameTo) {
  const StrategyEntry contour = named("contour"), zigzag = named("zigzag");
  std::atomic<int> asked{0};
  const auto planner = [&](int, const StrategyCandidate& candidate) {
    if (++asked <= 2) throw std::bad_alloc();
    StepPlan plan;
    if (candidate.strategy->name == "zigzag") plan.section.moves.emplace_back();
    return plan;
  };
  const Selection selection(one_step({{&contour, {}}, {&zigzag, {}}}), planner, 1);
  EXPECT_EQ(selection.candidate(0).strategy->name, "zigzag");
  EXPECT_TRUE(selection.beyond_memory(0).empty());
}

/// What was not clean stays where a fallback gives nothing.
TEST(Selection, AFallbackWithoutAPlanTakesNoPlace) {
  const StrategyEntry contour = named("contour"), zigzag = named("zigzag");
  const auto planner = [](int, const StrategyCandidate& candidate) {
    if (candidate.strategy->name == "zigzag") throw std::bad_alloc();
    StepPlan plan;
    plan.section.moves.emplace_back();
    plan.time_s = 1;
    return plan;
  };
  auto steps = one_step({{&contour, {}}});
  steps.front().candidates.fallbacks = {{&zigzag, {}}};
  Selection selection(steps, planner, 1);
  EXPECT_FALSE(selection.next(0));
  EXPECT_EQ(selection.candidate(0).strategy->name, "contour");
  EXPECT_FALSE(selection.section(0).moves.empty());
  EXPECT_EQ(selection.beyond_memory(0), std::vector<std::string>{"zigzag"});
}

TEST(Selection, WhereNoneFindsMemoryThatIsThrown) {
  const StrategyEntry contour = named("contour"), zigzag = named("zigzag");
  const auto planner = [](int, const StrategyCandidate&) -> StepPlan { throw std::bad_alloc(); };
  EXPECT_THROW(Selection(one_step({{&contour, {}}, {&zigzag, {}}}), planner, 1), std::bad_alloc);
}

/// A rival of contour is fastest and not clean; contour's own plan comes before the slower zigzag.
TEST(Selection, AfterARivalTheStrategyItselfIsPlanned) {
  const StrategyEntry contour = named("contour"), zigzag = named("zigzag");
  const auto planner = [](int, const StrategyCandidate& candidate) {
    StepPlan plan;
    plan.section.moves.emplace_back();
    plan.time_s = candidate.strategy->name == "zigzag" ? 13 : candidate.beside_rivals ? 10 : 11;
    return plan;
  };
  Selection selection(one_step({{&contour, {}, true}, {&zigzag, {}}}), planner, 1);
  ASSERT_TRUE(selection.next(0));
  EXPECT_EQ(selection.candidate(0).strategy->name, "contour");
  EXPECT_FALSE(selection.candidate(0).beside_rivals);
  ASSERT_TRUE(selection.next(0));
  EXPECT_EQ(selection.candidate(0).strategy->name, "zigzag");
  EXPECT_FALSE(selection.next(0));
  std::vector<Outcome> outcomes;
  const auto selections = selection.selections();
  for (const auto& one : selections.front().candidates) outcomes.push_back(one.outcome);
  EXPECT_EQ(outcomes, (std::vector{Outcome::kNotClean, Outcome::kNotClean, Outcome::kKept}));
}

/// Where the engagement is limited only one strategy competes.
TEST(Selection, WhereAllThatCompeteTakeTooMuchWorkAFallbackAnswers) {
  const StrategyEntry adaptive = named("adaptive"), contour = named("contour"), zigzag = named("zigzag");
  const auto planner = [](int, const StrategyCandidate& candidate) {
    if (candidate.strategy->name != "zigzag") throw OutOfWork("too much");
    StepPlan plan;
    plan.section.moves.emplace_back();
    plan.time_s = 1;
    return plan;
  };
  auto steps = one_step({{&adaptive, {}}});
  steps.front().candidates.fallbacks = {{&contour, {}}, {&zigzag, {}}, {&zigzag, Stepover{"0.4"}}};
  Selection selection(steps, planner, 1);
  EXPECT_EQ(selection.candidate(0).strategy->name, "zigzag");
  EXPECT_FALSE(selection.section(0).moves.empty());
  EXPECT_EQ(selection.left_out(0), (std::vector<std::string>{"adaptive", "contour"}));
  ASSERT_TRUE(selection.next(0));
  EXPECT_EQ(selection.candidate(0).stepover.text, "0.4") << "what was tried is not tried again";
}

TEST(Selection, WhereAllTakeTooMuchWorkNothingIsPlanned) {
  const StrategyEntry contour = named("contour");
  const auto planner = [](int, const StrategyCandidate&) -> StepPlan { throw OutOfWork("too much"); };
  const Selection selection(one_step({{&contour, {}}}), planner, 1);
  EXPECT_TRUE(selection.section(0).moves.empty());
  EXPECT_EQ(selection.left_out(0), std::vector<std::string>{"contour"});
}

TEST(Selection, EveryStrategyIsNamedByTheOption) {
  const Row& row = *row_named("strategy");
  EXPECT_THAT(row.names, testing::UnorderedElementsAreArray(strategy_names(built_in_strategies())))
      << "the row of --strategy in src/options/rows.cpp lists the names for help and completion";
  for (const std::string& name : row.names)
    EXPECT_NE((" " + row.sentence + ",").find(" " + name + ","), std::string::npos) << name;
}

}  // namespace
}  // namespace clearcut::pipeline
