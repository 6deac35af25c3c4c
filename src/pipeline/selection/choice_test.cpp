#include "pipeline/selection/choice.h"

#include <gtest/gtest.h>

#include <utility>

#include "base/work_budget.h"
#include "model/strategy_entry.h"

namespace clearcut::pipeline {
namespace {

StrategyEntry named(const char* name) {
  StrategyEntry entry;
  entry.name = name;
  return entry;
}

std::vector<ChoiceStep> one_step(std::vector<Attempt> contest) {
  Attempts attempts;
  attempts.contest = std::move(contest);
  return {{"pocket", 0, 5, MmPerMin::of(1000), attempts}};
}

TEST(Choice, AStrategyThatTakesTooMuchWorkIsLeftOutByNameAndTheOthersAnswer) {
  const StrategyEntry contour = named("contour"), zigzag = named("zigzag");
  const auto planner = [](int, const Attempt& attempt) {
    const WorkBudget budget(10);
    StepPlan plan;
    WorkBudget::spend(attempt.strategy->name == "contour" ? 11 : 10);
    plan.section.moves.emplace_back();
    plan.time_s = 1;
    return plan;
  };
  const Choice choice(one_step({{&contour, {}}, {&zigzag, {}}}), planner, 1);
  EXPECT_EQ(choice.attempt(0).strategy->name, "zigzag");
  EXPECT_FALSE(choice.section(0).moves.empty());
  EXPECT_EQ(choice.left_out(0), std::vector<std::string>{"contour"});
  EXPECT_EQ(choice.contests().front().contestants.back().outcome, Outcome::kTooMuchWork);
}

TEST(Choice, WhereAllTakeTooMuchWorkNothingIsPlanned) {
  const StrategyEntry contour = named("contour");
  const auto planner = [](int, const Attempt&) -> StepPlan { throw OutOfWork("too much"); };
  const Choice choice(one_step({{&contour, {}}}), planner, 1);
  EXPECT_TRUE(choice.section(0).moves.empty());
  EXPECT_EQ(choice.left_out(0), std::vector<std::string>{"contour"});
}

}  // namespace
}  // namespace clearcut::pipeline
