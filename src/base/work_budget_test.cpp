#include "base/work_budget.h"

#include <gtest/gtest.h>

namespace clearcut::inline base {
namespace {

TEST(WorkBudget, EndsATaskThatTakesMoreSteps) {
  const WorkBudget budget(10);
  WorkBudget::spend(6);
  EXPECT_THROW(WorkBudget::spend(5), OutOfWork);
  EXPECT_NO_THROW(WorkBudget::spend(4));
}

TEST(WorkBudget, AnInnerTaskHasItsOwnAndTheOuterOneGoesOnWithIts) {
  const WorkBudget outer(3);
  {
    const WorkBudget inner = WorkBudget::unlimited();
    WorkBudget::spend(1000);
  }
  WorkBudget::spend(3);
  EXPECT_THROW(WorkBudget::spend(1), OutOfWork);
}

TEST(WorkBudget, WithoutOneAllIsFree) {
  EXPECT_NO_THROW(WorkBudget::spend(UINT64_MAX));
}

}  // namespace
}  // namespace clearcut::inline base
