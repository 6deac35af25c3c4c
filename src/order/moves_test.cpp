// Ways that were dear to find: kept, given back, and found anew where they had to give way.
#include "order/moves.h"

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <thread>

#include "geometry/contours/boolean.h"
#include "geometry/route/legal_paths.h"
#include "geometry/voronoi/clearance.h"
#include "order/genetic/genetic.h"
#include "order/objective.h"
#include "order/test_support.h"

namespace clearcut::order {
namespace {

MoveShape shape_of_length(double length) {
  MoveShape shape;
  shape.length = length;
  return shape;
}

TEST(ShapeStore, IsAMapWhileItHasRoom) {
  Random random(1);
  ShapeStore store;
  std::map<std::pair<int, int>, double> plain;
  for (int i = 0; i < 100000; ++i) {
    const int low = static_cast<int>(random.below(300)), high = low + static_cast<int>(random.below(300));
    const auto at = plain.find({low, high});
    const auto found = store.find(low, high);
    ASSERT_EQ(found.has_value(), at != plain.end());
    if (found) {
      ASSERT_EQ(found->length, at->second);
    }
    if (random.below(2) == 0) continue;
    plain[{low, high}] = i;
    store.keep(low, high, shape_of_length(i));
  }
  EXPECT_LT(store.places(), 3 * plain.size());
}

TEST(ShapeStore, NeverGrowsBeyondItsBound) {
  constexpr std::size_t kMost = 1024;
  ShapeStore store(kMost);
  int kept = 0;
  for (int i = 0; i < 100000; ++i) {
    store.keep(i, i + 1, shape_of_length(i));
    const auto just_kept = store.find(i, i + 1), earlier = store.find(i / 2, i / 2 + 1);
    ASSERT_TRUE(just_kept.has_value());
    ASSERT_EQ(just_kept->length, i);
    if (earlier) {
      ASSERT_EQ(earlier->length, i / 2);
      ++kept;
    }
  }
  EXPECT_LE(store.places(), kMost);
  EXPECT_LE(ShapeStore::kMostPlaces * 72, std::size_t{80} << 20);
  EXPECT_GT(kept, 0);
}

TEST(ShapeStore, ServesSeveralThreads) {
  ShapeStore store(4096);
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      for (int i = 0; i < 20000; ++i) {
        const int low = (i * 7919) % 200, high = low + i % 100;
        const auto found = store.find(low, high);
        if (found && found->length != low * 1000 + high) ++wrong;
        store.keep(low, high, shape_of_length(low * 1000 + high));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

Regions pocket_with_islands(std::uint64_t seed) {
  Random random(seed);
  const auto rectangle = [](Vec2 low, Vec2 high) {
    const std::vector<Vec2> corners{low, {high.x, low.y}, high, {low.x, high.y}};
    return Region::from_valid_loops(loop_from_points(corners), {});
  };
  Regions area{rectangle({0, 0}, {random.between(40, 60), random.between(40, 60)})};
  for (int i = 0; i < 4; ++i) {
    const Vec2 p{random.between(5, 30), random.between(5, 30)};
    area = subtract(area, {rectangle(p, p + Vec2{random.between(2, 9), random.between(2, 9)})}, {});
  }
  return {area.front()};
}

/// A grid of points in a pocket with islands.
struct Pocket {
  explicit Pocket(std::uint64_t seed) : paths(pocket_with_islands(seed)) {
    for (double y = 1; y < 60; y += 4)
      for (double x = 1; x < 60; x += 4)
        if (paths.area().holds({x, y})) problem.points.push_back({x, y});
    problem.shape = Shape::kOpenPath;
    problem.detour = [this](int a, int b) {
      ++asked;
      return paths.bends(problem.points[a], problem.points[b]).value_or(std::vector<Vec2>{});
    };
  }
  Pocket(const Pocket&) = delete;
  Pocket& operator=(const Pocket&) = delete;
  LegalPaths paths;
  Problem problem;
  std::atomic<int> asked = 0;
};

/// Every move of every pair from the start, again, and backwards, as the ways themselves say; also where hardly any is kept.
TEST(Moves, AreTheSameWhateverIsKept) {
  for (const std::uint64_t seed : {1u, 2u}) {
    const Pocket pocket(seed);
    const Problem& problem = pocket.problem;
    const Moves kept(problem), hardly_any(problem, 128);
    for (int round = 0; round < 2; ++round) {
      for (int a = 0; a < problem.size(); ++a) {
        for (int b = 0; b < problem.size(); ++b) {
          const auto way = move_points(problem, a, b);
          for (const Moves* moves : {&kept, &hardly_any}) {
            const MoveShape shape = moves->shape(a, b);
            ASSERT_NEAR(shape.length, way_length(problem, way), 1e-9);
            ASSERT_EQ(shape.length, kept.length(b, a));
            ASSERT_EQ(shape.straight, way.size() == 2);
            ASSERT_EQ(shape.leaves, way[1] - way[0]);
            ASSERT_EQ(shape.arrives, way.back() - way[way.size() - 2]);
            ASSERT_EQ(moves->inner_turns(a, b), shape.inner_turns);
            ASSERT_EQ(moves->inner_angle(a, b), shape.inner_angle);
          }
        }
      }
    }
  }
}

/// Each way is found once, whatever the population.
TEST(Moves, TheGeneticAlgorithmFindsEachWayOnce) {
  const Pocket pocket(4);
  GeneticOptions options;
  options.stop.rounds = 400;
  const auto objective = weighted_sum({{20, turns_objective()}, {1, length_objective()}});
  run_genetic(pocket.problem, *objective, options);
  const int pairs = pocket.problem.size() * (pocket.problem.size() - 1) / 2;
  EXPECT_GT(pocket.asked, 100);
  EXPECT_LE(pocket.asked, pairs);
}

}  // namespace
}  // namespace clearcut::order
