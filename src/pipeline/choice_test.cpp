#include "pipeline/choice.h"

#include <gtest/gtest.h>

#include "base/work_budget.h"

namespace clearcut::pipeline {
namespace {

TEST(Choice, AStrategyThatTakesTooMuchWorkIsLeftOutByNameAndTheOthersAnswer) {
  Attempts attempts;
  attempts.contest = {{"contour", std::nullopt}, {"zigzag", std::nullopt}};
  const auto planner = [](int, const Attempt& attempt) {
    const WorkBudget budget(10);
    StepPlan plan;
    WorkBudget::spend(attempt.strategy == "contour" ? 11 : 10);
    plan.section.moves.emplace_back();
    plan.time_s = 1;
    return plan;
  };
  const Choice choice({{"pocket", 0, 5, MmPerMin::of(1000)}}, attempts, planner, {});
  EXPECT_EQ(choice.attempt(0).strategy, "zigzag");
  EXPECT_FALSE(choice.section(0).moves.empty());
  EXPECT_EQ(choice.left_out(0), std::vector<std::string>{"contour"});
  EXPECT_EQ(choice.contests().front().contestants.back().outcome, Outcome::kTooMuchWork);
}

TEST(Choice, WhereAllTakeTooMuchWorkNothingIsPlanned) {
  Attempts attempts;
  attempts.contest = {{"contour", std::nullopt}};
  const auto planner = [](int, const Attempt&) -> StepPlan { throw OutOfWork("too much"); };
  const Choice choice({{"pocket", 0, 5, MmPerMin::of(1000)}}, attempts, planner, {});
  EXPECT_TRUE(choice.section(0).moves.empty());
  EXPECT_EQ(choice.left_out(0), std::vector<std::string>{"contour"});
}

}  // namespace
}  // namespace clearcut::pipeline
