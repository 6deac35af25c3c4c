// Stock to leave has to stand, on walls and floors, whoever cuts it away.
#include <gtest/gtest.h>

#include "verify/test_findings.h"
#include "verify/verify.h"

namespace clearcut::verify {
namespace {

using namespace clearcut::testing;

Part leaving(double side, double floor) {
  Part part = square_part();
  part.workplan[0].operation.allowance_side = side;
  part.workplan[0].operation.allowance_floor = floor;
  return part;
}

Findings of_rings(const Part& part, double outermost, double z) {
  return verify_program(part, square_program({2, 6.5, 11, 15.5, 19.5, outermost}, z), {});
}

TEST(StockToLeave, OnWallsHasToStand) {
  const Part part = leaving(0.3, 0);
  EXPECT_TRUE(of_rings(part, 21.7, -2).faults.empty()) << report_of(of_rings(part, 21.7, -2));
  EXPECT_TRUE(of_rings(part, 21.709, -2).faults.empty()) << "within what uncut allows";
  const Findings cut = of_rings(part, 22, -2);
  ASSERT_EQ(cut.faults.size(), 1U) << report_of(cut);
  EXPECT_EQ(cut.faults[0].kind, FaultKind::kStockToLeave);
  EXPECT_NEAR(cut.faults[0].size, 0.3, 1e-9);
  EXPECT_TRUE(has(of_rings(part, 21.72, -2), FaultKind::kStockToLeave));
  EXPECT_TRUE(of_rings(leaving(0, 0), 22, -2).faults.empty());
}

TEST(StockToLeave, OnFloorsHasToStand) {
  const Part part = leaving(0, 0.3);
  EXPECT_TRUE(of_rings(part, 22, -1.7).faults.empty()) << report_of(of_rings(part, 22, -1.7));
  const Findings cut = of_rings(part, 22, -2);
  ASSERT_EQ(cut.faults.size(), 1U) << report_of(cut);
  EXPECT_EQ(cut.faults[0].kind, FaultKind::kStockToLeave);
  EXPECT_NEAR(cut.faults[0].size, 0.3, 1e-9);
  EXPECT_TRUE(has(of_rings(part, 22, -1.72), FaultKind::kStockToLeave));
}

TEST(StockToLeave, IsNothingOnceAFinishingStepAsksForAll) {
  Part part = leaving(0.3, 0.2);
  part.workplan.push_back(part.workplan[0]);
  part.workplan[1].operation.allowance_side = part.workplan[1].operation.allowance_floor = 0;
  EXPECT_TRUE(of_rings(part, 22, -2).faults.empty()) << report_of(of_rings(part, 22, -2));
}

TEST(StockToLeave, OfTheDeepestCutIsAGougeAlone) {
  const Findings cut = of_rings(leaving(0.3, 0), 22.2, -2);
  EXPECT_TRUE(has(cut, FaultKind::kGouge));
  EXPECT_FALSE(has(cut, FaultKind::kStockToLeave)) << report_of(cut);
}

TEST(StockToLeave, EndsWhereAnotherFeatureClears) {
  // A slot without allowance runs from the pocket out through the middle of its right wall.
  Part part = leaving(0.3, 0);
  Feature slot = part.features[0];
  slot.name = "SLOT";
  slot.target = slot.allowed = rectangle(40, 20, 70, 30);
  part.features.push_back(slot);
  Workingstep step = part.workplan[0];
  step.feature = 1;
  step.operation.allowance_side = 0;
  part.workplan.push_back(step);
  Writer writer;
  cut_square_rings(writer, {25, 25}, {2, 6.5, 11, 15.5, 19.5, 21.7}, 0, -2);
  writer.leave().enter({44, 23}, 0, -2);
  writer.feed({67, 23}).feed({67, 27}).feed({44, 27}).feed({44, 25}).feed({67, 25});
  const Findings right = verify_program(part, writer.done(), {});
  EXPECT_FALSE(has(right, FaultKind::kStockToLeave)) << report_of(right);
}

TEST(StockToLeave, IsCutByBallsAndSinkingMovesToo) {
  Part part = leaving(0.3, 0);
  part.tools[0].corner_radius = 1;
  Writer writer;
  writer.enter({25, 25}, 0, -1).feed({47, 25}, -2).feed({40, 25});
  EXPECT_TRUE(has(verify_program(part, writer.done(), {}), FaultKind::kStockToLeave));
  Writer shallow;
  shallow.enter({25, 25}, 0, -1).feed({46.7, 25}, -2).feed({40, 25});
  EXPECT_FALSE(has(verify_program(part, shallow.done(), {}), FaultKind::kStockToLeave));
}

}  // namespace
}  // namespace clearcut::verify
