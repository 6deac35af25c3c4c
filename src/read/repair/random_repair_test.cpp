// Random and very large drawings: valid regions or a refusal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random.h"
#include "base/units.h"
#include "read/repair/meetings.h"
#include "read/repair/repair.h"
#include "read/repair/test_curves.h"

namespace clearcut::read {
namespace {

using testing::closed;
using ::testing::HasSubstr;
using testing::open;
using testing::refusal;
using testing::Repaired;
using testing::repaired;

/// Correct means: either a refusal, or regions whose loops neither cross nor overlap, whose area is that of
/// the even-odd rule for the loops drawn. The check cannot see a wrong but valid nesting of equal area.
TEST(Repair, RandomLoopsGiveValidRegionsOrARefusal) {
  Random random(11);
  int accepted = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<RawCurve> curves;
    const int loops = 1 + static_cast<int>(random.below(6));
    for (int l = 0; l < loops; ++l) {
      std::vector<BulgeVertex> vertices;
      const Vec2 center{random.between(0, 60), random.between(0, 60)};
      const int n = 3 + static_cast<int>(random.below(8));
      for (int i = 0; i < n; ++i) {
        const double bulge = random.below(3) == 0 ? random.between(-0.4, 0.4) : 0;
        vertices.push_back({center + direction_of(2 * kPi * i / n) * random.between(5, 25), bulge});
      }
      curves.push_back({loop_from_bulges(vertices), true, "loop", {}});
    }
    try {
      const Repaired result = repaired(curves);
      ++accepted;
      std::vector<Loop> all;
      for (const Region& region : result.regions) {
        all.push_back(region.outer());
        all.insert(all.end(), region.islands().begin(), region.islands().end());
        EXPECT_GT(signed_area(region.outer()), 0);
        for (const Loop& island : region.islands()) EXPECT_LT(signed_area(island), 0);
      }
      for (const Meeting& meeting : meetings(all, 1000, "check")) {
        EXPECT_EQ(meeting.kind, MeetingKind::kTouch) << round;
      }
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), ::testing::AnyOf(HasSubstr("cross"), HasSubstr("crosses itself"))) << round;
    }
  }
  EXPECT_GT(accepted, 50);
}

/// Grid-like inputs are full of shared corners, shared walls and T-joints.
TEST(Repair, RandomRectanglesOnAGridAreResolvedByEvenOdd) {
  Random random(5);
  int accepted = 0;
  for (int round = 0; round < 300; ++round) {
    std::vector<RawCurve> curves;
    const int count = 2 + static_cast<int>(random.below(5));
    for (int i = 0; i < count; ++i) {
      const double x = static_cast<double>(random.below(8)), y = static_cast<double>(random.below(8));
      const double w = 1 + static_cast<double>(random.below(5)), h = 1 + static_cast<double>(random.below(5));
      curves.push_back(closed({{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}));
    }
    try {
      const Repaired result = repaired(curves);
      ++accepted;
      EXPECT_GT(area(result.regions), 0);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("cross at")) << round;
    }
  }
  EXPECT_GT(accepted, 50);
}

/// Loose lines between points of a small grid: they meet, overlap, repeat and cross in every way.
TEST(Repair, RandomLooseLinesOnAGridAreReadOrRefused) {
  Random random(7);
  const auto pick = [&](int least, int most) {
    return least + static_cast<int>(random.below(static_cast<std::uint64_t>(most - least + 1)));
  };
  int read = 0, merged = 0;
  for (int run = 0; run < 400; ++run) {
    const double w = 10.0 * pick(1, 4), h = 10.0 * pick(1, 4);
    std::vector<RawCurve> curves{open({{0, 0}, {w, 0}}), open({{w, 0}, {w, h}}), open({{w, h}, {0, h}}),
                                 open({{0, h}, {0, 0}})};
    const int extra = pick(1, 4);
    for (int i = 0; i < extra; ++i) {
      const auto at = [&](double size) { return static_cast<double>(pick(0, static_cast<int>(size))); };
      const bool along_x = pick(0, 1) == 0;
      const double side = pick(0, 1) * (along_x ? h : w);
      const double a = at(along_x ? w : h), b = at(along_x ? w : h);
      if (a == b) continue;
      curves.push_back(along_x ? open({{a, side}, {b, side}}) : open({{side, a}, {side, b}}));
    }
    try {
      const Repaired result = repaired(curves);
      EXPECT_NEAR(area(result.regions), w * h, 1e-6) << run;
      ++read;
      merged += result.count(Severity::kRepair, "run along each other") > 0;
    } catch (const InputError& error) {
      ADD_FAILURE() << run << ": " << error.what();
    }
  }
  EXPECT_EQ(read, 400);
  EXPECT_GT(merged, 200);
}

TEST(Repair, NoiseOnRepeatedRunsChangesNothing) {
  Random random(2);
  std::vector<Vec2> points;
  for (int i = 0; i < 500; ++i) points.push_back(direction_of(2 * kPi * i / 500) * random.between(20, 21));
  const Repaired once = repaired({closed(points)}), again = repaired({closed(points)});
  ASSERT_EQ(once.regions[0].outer().size(), again.regions[0].outer().size());
  EXPECT_TRUE(std::equal(once.regions[0].outer().begin(), once.regions[0].outer().end(),
                         again.regions[0].outer().begin()));
}

TEST(Repair, AHundredThousandLooseLinesAreOneOutline) {
  std::vector<RawCurve> loose;
  const int n = 100'000;
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * kPi * i / n;
    points.push_back(direction_of(angle) * (500 + 20 * std::sin(40 * angle)));
  }
  for (int i = 0; i < n; ++i) {
    loose.push_back(
        open({points[static_cast<std::size_t>(i)], points[static_cast<std::size_t>((i + 1) % n)]}));
  }
  const Repaired result = repaired(std::move(loose));
  EXPECT_EQ(result.regions[0].outer().size(), static_cast<std::size_t>(n));
}

}  // namespace
}  // namespace clearcut::read
