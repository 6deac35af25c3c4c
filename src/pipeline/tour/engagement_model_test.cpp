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

/// The raster model written down plainly: pixels of a midpoint circle by the root, those of a line by rounding its slope, whole discs
/// cleared sqrt(2 r) pixels behind.
class PlainRaster {
 public:
  PlainRaster(const EngagementTask& task, double accuracy)
      : task_(task),
        size_(raster_pixel(task.radius, accuracy)),
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
    where = where.grown(task.radius + 2 * size_);
    origin_ = where.min;
    side_ = static_cast<int>(std::max(where.width(), where.height()) / size_) + 3;
    cleared_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), false);
  }

  std::vector<double> along(const std::vector<int>& tour) {
    std::vector<double> shares;
    clear(pixel_of(tour[0]));
    for (std::size_t i = 1; i < tour.size(); ++i) {
      const std::vector<Pixel> trail = line(pixel_of(tour[i - 1]), pixel_of(tour[i]));
      const Vec2 direction = point(tour[i]) - point(tour[i - 1]);
      double sum = 0;
      for (std::size_t k = 0; k < trail.size(); ++k) {
        sum += engaged(trail[k], direction);
        if (k >= lag()) clear(trail[k - lag()]);
      }
      for (const Pixel& p : trail) clear(p);
      shares.push_back(sum / static_cast<double>(trail.size()));
    }
    return shares;
  }

 private:
  using Pixel = std::pair<int, int>;
  static int sign(int value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }
  static std::vector<Pixel> line(Pixel from, Pixel to) {
    const int dx = std::abs(to.first - from.first), dy = std::abs(to.second - from.second);
    const int most = std::max(dx, dy);
    const auto after = [most](int k, int all) { return (2 * k * all + most) / (2 * most); };
    std::vector<Pixel> pixels;
    for (int k = 1; k <= most; ++k) {
      pixels.emplace_back(from.first + sign(to.first - from.first) * after(k, dx),
                          from.second + sign(to.second - from.second) * after(k, dy));
    }
    return pixels;
  }
  std::size_t lag() const { return static_cast<std::size_t>(std::ceil(std::sqrt(2.0 * radius_))); }
  Vec2 point(int index) const { return task_.points[static_cast<std::size_t>(index)]; }
  Pixel pixel_of(int index) const {
    const Vec2 p = point(index);
    return {static_cast<int>(std::lround((p.x - origin_.x) / size_)),
            static_cast<int>(std::lround((p.y - origin_.y) / size_))};
  }
  std::size_t place_of(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(x);
  }
  bool is_material(int x, int y) const {
    return !cleared_[place_of(x, y)] && contains(task_.target, origin_ + Vec2{x * size_, y * size_});
  }
  double engaged(const Pixel& at, Vec2 direction) const {
    int leading = 0, in = 0;
    for (const Pixel& p : circle_) {
      if (p.first * direction.x + p.second * direction.y <= 0) continue;
      ++leading;
      in += is_material(at.first + p.first, at.second + p.second) ? 1 : 0;
    }
    return static_cast<double>(in) / leading;
  }
  void clear(const Pixel& at) {
    for (const Pixel& p : circle_) {
      for (int x = -std::abs(p.first); x <= std::abs(p.first); ++x)
        cleared_[place_of(at.first + x, at.second + p.second)] = true;
    }
  }

  const EngagementTask& task_;
  double size_;
  int radius_, side_ = 0;
  Vec2 origin_;
  std::set<Pixel> circle_;
  std::vector<bool> cleared_;
};

TEST(Engagement, TheRasterIsThePlainOneToThePixel) {
  const EngagementTask task = grid_task();
  Random random(5);
  // Circles of 11, 56 and 8 pixels; sqrt(2 r) of the last is a whole number.
  for (const double accuracy : {0.02, 0.02, 0.004, 0.0281}) {
    std::vector<int> tour{static_cast<int>(random.below(49))};
    while (tour.size() < (accuracy > 0.01 ? 12 : 5)) {
      const int next = static_cast<int>(random.below(49));
      if (next != tour.back()) tour.push_back(next);
    }
    const std::vector<double> plain = PlainRaster(task, accuracy).along(tour);
    const auto model = raster_engagement(task, accuracy);
    const std::vector<double>& ours = model->along(tour);
    ASSERT_EQ(ours.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i)
      EXPECT_DOUBLE_EQ(ours[i], plain[i]) << accuracy << " " << i;
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
