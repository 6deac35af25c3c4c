#include "verify/engagement/load.h"

#include <gtest/gtest.h>

#include "verify/test_program.h"

namespace clearcut::verify {
namespace {

using testing::pocket_part;
using testing::rectangle;
using testing::Writer;

/// Lines and arcs to and fro over a large pocket on three depths, ramps between them: long enough for several parts.
Toolpath long_program() {
  Writer writer;
  for (const double z : {-1.0, -2.0, -3.0}) {
    writer.enter({10, 10}, z + 1, z + 0.5).feed({60, 10}, z).feed({10, 10}, z);
    for (int line = 0; line < 18; ++line) {
      const double y = 10 + 8.0 * line, from = line % 2 == 0 ? 10 : 250, to = 260 - from;
      writer.feed({from, y}).feed({to, y});
      if (line % 2 == 0) writer.arc({to, y + 8}, {to, y + 4}, Turn::kCounterClockwise);
    }
    writer.leave();
  }
  return writer.done();
}

TEST(Load, IsTheSameInHoweverManyPartsItIsMeasured) {
  const Part part = pocket_part(rectangle(0, 0, 270, 170), 10, -3);
  const Toolpath toolpath = long_program();
  const LoadOptions options{{}, 100.0, {}, {}};
  CheckedProgram whole = checked_program(part, toolpath, {}, nullptr, nullptr), parts = whole;
  measure_load(part, whole.moves, options);
  const auto tasks = load_tasks(part, parts.moves, options, 4);
  ASSERT_GT(tasks.size(), 1U);
  for (std::size_t i = tasks.size(); i-- > 0;) tasks[i]();
  ASSERT_EQ(whole.moves.size(), parts.moves.size());
  double engaged = 0;
  for (std::size_t i = 0; i < whole.moves.size(); ++i) {
    const MoveLoad &a = whole.moves[i].load, &b = parts.moves[i].load;
    EXPECT_EQ(a.max_deg, b.max_deg) << i;
    EXPECT_EQ(a.angle_mm_deg, b.angle_mm_deg) << i;
    EXPECT_EQ(a.cutting_mm, b.cutting_mm) << i;
    EXPECT_EQ(a.air_mm, b.air_mm) << i;
    EXPECT_EQ(a.climb_mm, b.climb_mm) << i;
    EXPECT_EQ(a.over_limit_mm, b.over_limit_mm) << i;
    EXPECT_EQ(a.axial_mm, b.axial_mm) << i;
    EXPECT_EQ(a.rapid_contact.has_value(), b.rapid_contact.has_value()) << i;
    engaged += a.cutting_mm;
  }
  EXPECT_GT(engaged, 10000);
}

TEST(Load, OfAShortProgramIsMeasuredInOnePart) {
  const Part part = pocket_part(rectangle(0, 0, 50, 50), 10, -1);
  Writer writer;
  writer.enter({10, 10}, 0, -1).feed({40, 10});
  const Toolpath toolpath = writer.done();
  CheckedProgram program = checked_program(part, toolpath, {}, nullptr, nullptr);
  EXPECT_EQ(load_tasks(part, program.moves, {}, 8).size(), 1U);
}

}  // namespace
}  // namespace clearcut::verify
