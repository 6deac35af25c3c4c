#include "order/search/visit_order.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <numeric>

#include "base/random.h"

namespace clearcut::order {
namespace {

/// Random visits with some precedence that the order as listed keeps. The question refers to `visits`.
VisitQuestion random_question(Random& random, std::size_t count, std::size_t most_ways, int pairs) {
  VisitQuestion question;
  const auto place = [&] { return Vec2{random.between(0, 100), random.between(0, 100)}; };
  for (std::size_t v = 0; v < count; ++v) {
    question.visits.emplace_back();
    const auto ways = 1 + static_cast<std::size_t>(random.between(0, static_cast<double>(most_ways) - 0.01));
    for (std::size_t w = 0; w < ways; ++w)
      question.visits.back().ways.push_back({place(), place(), random.between(0, 10)});
  }
  for (int i = 0; i < pairs; ++i) {
    const auto last = static_cast<std::size_t>(random.between(1, static_cast<double>(count) - 0.01));
    question.precedence.emplace_back(
        static_cast<std::size_t>(random.between(0, static_cast<double>(last) - 0.01)), last);
  }
  return question;
}

void go_straight(VisitQuestion& question) {
  question.travel = [&question](const VisitStep& a, const VisitStep& b) {
    return distance(question.visits[a.visit].ways[a.way].end, question.visits[b.visit].ways[b.way].begin);
  };
  question.far_travel = question.travel;
}

double cost_of(const VisitQuestion& question, const std::vector<VisitStep>& steps) {
  double cost = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    cost += question.visits[steps[i].visit].ways[steps[i].way].own;
    if (i > 0) cost += question.travel(steps[i - 1], steps[i]);
  }
  return cost;
}

bool is_valid(const VisitQuestion& question, const std::vector<VisitStep>& steps) {
  std::vector<std::size_t> place(question.visits.size(), steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) place[steps[i].visit] = i;
  if (steps.size() != place.size()) return false;
  if (std::find(place.begin(), place.end(), steps.size()) != place.end()) return false;
  if (question.fixed_first && place[0] != 0) return false;
  return std::all_of(question.precedence.begin(), question.precedence.end(),
                     [&](const auto& pair) { return place[pair.first] < place[pair.second]; });
}

/// Of all orders with all ways.
double least_cost(const VisitQuestion& question) {
  std::vector<std::size_t> order(question.visits.size());
  std::iota(order.begin(), order.end(), 0u);
  double least = 1e300;
  const auto with_ways = [&](const auto& self, std::vector<VisitStep>& steps) -> void {
    if (steps.size() == order.size()) {
      if (is_valid(question, steps)) least = std::min(least, cost_of(question, steps));
      return;
    }
    const std::size_t visit = order[steps.size()];
    for (std::size_t way = 0; way < question.visits[visit].ways.size(); ++way) {
      steps.push_back({visit, way});
      self(self, steps);
      steps.pop_back();
    }
  };
  do {
    std::vector<VisitStep> steps;
    with_ways(with_ways, steps);
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

TEST(VisitOrder, FewVisitsAreInTheBestOfAllOrders) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    auto question = random_question(random, 2 + seed % 4, 3, static_cast<int>(seed % 3));
    question.fixed_first = seed % 5 == 0;
    go_straight(question);
    const auto steps = order_visits(question);
    ASSERT_TRUE(is_valid(question, steps)) << seed;
    EXPECT_NEAR(cost_of(question, steps), least_cost(question), 1e-9) << seed;
  }
}

TEST(VisitOrder, ManyVisitsKeepPrecedenceAndAreNoDearerThanAsListed) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    auto question = random_question(random, 10 + 4 * seed, 1 + seed % 3, static_cast<int>(2 * seed));
    question.ordered_before = true;
    question.fixed_first = seed % 2 == 0;
    go_straight(question);
    const auto steps = order_visits(question);
    ASSERT_TRUE(is_valid(question, steps)) << seed;
    std::vector<VisitStep> listed;
    for (std::size_t v = 0; v < question.visits.size(); ++v) listed.push_back({v, 0});
    EXPECT_LT(cost_of(question, steps), 0.8 * cost_of(question, listed)) << seed;
  }
}

TEST(VisitOrder, NearestFirstIsNeverBetter) {
  // Places on a line: to the far left first is dear, yet going there at last costs more than nearest first knows.
  VisitQuestion question;
  for (const double x : {0.0, 1.0, -2.0, 4.0, -8.0, 16.0, -32.0, 64.0, 65.0, 66.0, 67.0, 68.0})
    question.visits.push_back({{{{x, 0}, {x, 0}, 0}}});
  go_straight(question);
  EXPECT_LE(cost_of(question, order_visits(question)), 101);
}

/// kB; the most that this process has held so far.
long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

TEST(VisitOrder, MemoryGrowsWithTheWaysAndNotWithTheirSquare) {
  Random random(1);
  auto question = random_question(random, 3000, 2, 0);
  question.ordered_before = true;
  go_straight(question);
  const long before = peak_memory();
  EXPECT_TRUE(is_valid(question, order_visits(question)));
  EXPECT_LT(peak_memory() - before, 100'000);
}

TEST(VisitOrder, NothingIsNothing) {
  EXPECT_TRUE(order_visits({}).empty());
}

}  // namespace
}  // namespace clearcut::order
