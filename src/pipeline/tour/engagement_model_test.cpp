// The engagement models: known cases, one against the other, and incremental against from scratch.
#include "pipeline/tour/engagement_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "base/random.h"
#include "base/units.h"
#include "kinematics/kinematics.h"
#include "pipeline/tour/tour_solver.h"

namespace clearcut::pipeline {
namespace {

Region square(double side) {
  const std::vector<Vec2> corners{{0, 0}, {side, 0}, {side, side}, {0, side}};
  return Region::from_valid_loops(loop_from_points(corners), {});
}

/// A grid of 7 x 7 points, 5 mm apart, in a square of 40 mm; 10 mm cutter.
EngagementTask grid_task() {
  EngagementTask task;
  for (int i = 0; i < 49; ++i) task.points.push_back({5.0 + 5 * (i % 7), 5.0 + 5 * (i / 7)});
  task.target = {square(40)};
  task.radius = 5;
  return task;
}

std::vector<int> shuffled(Random& random) {
  std::vector<int> tour(49);
  std::iota(tour.begin(), tour.end(), 0);
  for (std::size_t i = tour.size(); i > 1; --i) std::swap(tour[i - 1], tour[random.below(i)]);
  return tour;
}

TEST(Engagement, ASlotIsWholeAndTheWayBackIsFree) {
  for (const auto& model : {raster_engagement(grid_task()), exact_engagement(grid_task())}) {
    const auto shares = model->along(std::vector<int>{21, 22, 23, 22, 21});
    ASSERT_EQ(shares.size(), 4u);
    EXPECT_NEAR(shares[0], 1, 0.05);
    EXPECT_NEAR(shares[1], 1, 0.05);
    EXPECT_NEAR(shares[2], 0, 0.05);
    EXPECT_NEAR(shares[3], 0, 0.05);
  }
}

TEST(Engagement, APassBesideAPassHasItsClosedForm) {
  // Half the diameter: acos(1 - stepover / R) = 90 degrees of 180.
  std::vector<int> tour;
  for (int i = 0; i < 7; ++i) tour.push_back(i);
  for (int i = 13; i >= 7; --i) tour.push_back(i);
  EXPECT_NEAR(exact_engagement(grid_task())->along(tour)[9], 0.5, 0.01);
  EXPECT_NEAR(raster_engagement(grid_task())->along(tour)[9], 0.5, 0.06);
}

/// The raster model written down plainly: pixels of a midpoint circle by the root, whole discs cleared sqrt(2 r) pixels behind. For
/// moves along the axes.
class PlainRaster {
 public:
  explicit PlainRaster(const EngagementTask& task)
      : task_(task),
        size_(raster_pixel(task.radius, 0.02)),
        radius_(static_cast<int>(std::lround(task.radius / size_))) {
    for (int y = 0;; ++y) {
      const int x = static_cast<int>(std::floor(std::sqrt(1.0 * radius_ * radius_ - 1.0 * y * y) + 0.5));
      if (x < y) break;
      for (const int sx : {1, -1}) {
        for (const int sy : {1, -1}) circle_.insert({sx * x, sy * y}), circle_.insert({sx * y, sy * x});
      }
    }
    Box where = box(task.target);
    for (const Vec2 p : task.points) where.add(p);
    origin_ = where.grown(task.radius + 2 * size_).min;
  }

  std::vector<double> along(const std::vector<int>& tour) {
    std::vector<double> shares;
    clear(pixel_of(tour[0]));
    for (std::size_t i = 1; i < tour.size(); ++i) {
      Pixel at = pixel_of(tour[i - 1]);
      const Pixel to = pixel_of(tour[i]);
      const Pixel step{sign(to.first - at.first), sign(to.second - at.second)};
      std::vector<Pixel> trail;
      double sum = 0;
      while (at != to) {
        at = {at.first + step.first, at.second + step.second};
        trail.push_back(at);
        sum += engaged(at, step);
        if (trail.size() > lag()) clear(trail[trail.size() - 1 - lag()]);
      }
      for (const Pixel& p : trail) clear(p);
      shares.push_back(sum / static_cast<double>(trail.size()));
    }
    return shares;
  }

 private:
  using Pixel = std::pair<int, int>;
  static int sign(int value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }
  std::size_t lag() const { return static_cast<std::size_t>(std::ceil(std::sqrt(2.0 * radius_))); }
  Pixel pixel_of(int point) const {
    const Vec2 p = task_.points[static_cast<std::size_t>(point)];
    return {static_cast<int>(std::lround((p.x - origin_.x) / size_)),
            static_cast<int>(std::lround((p.y - origin_.y) / size_))};
  }
  bool is_material(Pixel at) const {
    return !cleared_.contains(at) &&
           contains(task_.target, origin_ + Vec2{at.first * size_, at.second * size_});
  }
  double engaged(Pixel at, Pixel step) const {
    int leading = 0, in = 0;
    for (const Pixel& p : circle_) {
      if (p.first * step.first + p.second * step.second <= 0) continue;
      ++leading;
      in += is_material({at.first + p.first, at.second + p.second}) ? 1 : 0;
    }
    return static_cast<double>(in) / leading;
  }
  void clear(Pixel at) {
    for (const Pixel& p : circle_) {
      for (int x = -std::abs(p.first); x <= std::abs(p.first); ++x)
        cleared_.insert({at.first + x, at.second + p.second});
    }
  }

  const EngagementTask& task_;
  double size_;
  int radius_;
  Vec2 origin_;
  std::set<Pixel> circle_, cleared_;
};

TEST(Engagement, TheRasterIsThePlainOneToThePixel) {
  const EngagementTask task = grid_task();
  Random random(5);
  for (int round = 0; round < 3; ++round) {
    std::vector<int> tour{static_cast<int>(random.below(49))};
    while (tour.size() < 12) {
      const int at = tour.back(), other = static_cast<int>(random.below(7));
      const int next = random.below(2) == 0 ? 7 * (at / 7) + other : 7 * other + at % 7;
      if (next != at) tour.push_back(next);
    }
    const std::vector<double> plain = PlainRaster(task).along(tour);
    const auto model = raster_engagement(task);
    const std::vector<double>& ours = model->along(tour);
    ASSERT_EQ(ours.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_DOUBLE_EQ(ours[i], plain[i]) << round << " " << i;
  }
}

TEST(Engagement, RasterAgreesWithExactOnAnyTour) {
  Random random(1);
  for (int i = 0; i < 10; ++i) {
    const auto tour = shuffled(random);
    const auto raster = raster_engagement(grid_task(), 0.01)->along(tour);
    const auto exact = exact_engagement(grid_task())->along(tour);
    double difference = 0;
    for (std::size_t k = 0; k < exact.size(); ++k) difference += std::abs(raster[k] - exact[k]) / 48;
    EXPECT_LT(difference, 0.03);
  }
}

TEST(Engagement, FromTheFirstChangedPointIsTheSameAsFromScratch) {
  Random random(2);
  auto tour = shuffled(random);
  const auto raster = raster_engagement(grid_task());
  const auto exact = exact_engagement(grid_task());
  for (int i = 0; i < 40; ++i) {
    const auto from = random.below(49), to = from + random.below(49 - from);
    std::reverse(tour.begin() + static_cast<std::ptrdiff_t>(from),
                 tour.begin() + static_cast<std::ptrdiff_t>(to));
    EXPECT_EQ(raster->along(tour), raster_engagement(grid_task())->along(tour));
    const auto kept = exact->along(tour), fresh = exact_engagement(grid_task())->along(tour);
    for (std::size_t k = 0; k < kept.size(); ++k) EXPECT_NEAR(kept[k], fresh[k], 1e-9);
  }
}

TEST(Engagement, TooMuchCostsMoreThanTooLittle) {
  EXPECT_EQ(engagement_cost(0), 0);
  EXPECT_GT(engagement_cost(0.1), engagement_cost(-0.1));
  EXPECT_GT(engagement_cost(0.2), 2 * engagement_cost(0.1));
}

/// Eq. 4.22: the reward is 1 / |deviation|, the penalty grows exponentially.
TEST(Engagement, TheInverseRewardIsSteepNearTheTarget) {
  EXPECT_EQ(inverse_engagement_cost(0), 0);
  const auto reward = [](double deviation) { return (1 - inverse_engagement_cost(deviation)) / 0.02; };
  for (const double below : {0.02, 0.05, 0.1, 0.5}) EXPECT_NEAR(reward(-below), 1 / below, 1e-9);
  EXPECT_EQ(inverse_engagement_cost(0.1), engagement_cost(0.1));
}

TEST(TourSolver, SameSeedSameOrderOnOneOrTwoThreads) {
  plan::tour::TourTask task;
  task.points = grid_task().points;
  Layer layer;
  layer.target = grid_task().target;
  layer.tool_radius = 5;
  task.layer = &layer;
  task.pitch = 5;
  for (const char* objective : {"length", "time", "1:length,20:turns,5:engagement"}) {
    ResolvedPlan plan;
    plan.objective = parse_objective(objective, "objective");
    ResolvedStep step;
    step.feed = MmPerMin::of(1000);
    const auto one = tour_solver(plan, step, plan.objective)(task);
    plan.threads = 2;
    EXPECT_EQ(tour_solver(plan, step, plan.objective)(task), one) << objective;
  }
}

TEST(MachineTime, IsTheKinematicTimeOfLongMoves) {
  // Long enough to reach the feed between corners.
  order::Problem problem;
  problem.points = {{0, 0}, {50, 0}, {50, 50}, {0, 80}, {-40, 10}};
  problem.shape = order::Shape::kOpenPath;
  const Machine machine;
  const MmPerMin feed = MmPerMin::of(1200);
  const order::Moves moves(problem);
  const std::vector<int> tour{0, 1, 2, 3, 4};
  std::vector<Move> run;
  for (std::size_t i = 1; i < tour.size(); ++i)
    run.push_back({Edge::line(problem.points[i - 1], problem.points[i]), -1, -1, MoveKind::kCut, feed, 0});
  const double ends = feed.mm_per_min() / 60 / machine.acceleration;  // from rest and to rest: v / a
  EXPECT_NEAR(order::evaluate(*machine_time_objective(machine, feed), moves, tour) + ends,
              kinematics::kinematic_time(run, machine).seconds(), 1e-9);
}

}  // namespace
}  // namespace clearcut::pipeline
