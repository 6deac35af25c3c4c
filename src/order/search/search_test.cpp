// The parts of the searches: array tours, exchanges, AB-cycles, children, objectives' changes.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "order/length/ab_cycles.h"
#include "order/length/array_tour.h"
#include "order/length/assembly.h"
#include "order/length/length_search.h"
#include "order/length/population.h"
#include "order/search/exchange_search.h"
#include "order/test_support.h"

namespace clearcut::order {
namespace {

bool is_permutation_of(std::vector<int> nodes, int n) {
  std::sort(nodes.begin(), nodes.end());
  std::vector<int> all(static_cast<std::size_t>(n));
  std::iota(all.begin(), all.end(), 0);
  return nodes == all;
}

/// The edges of a closed tour after an exchange, followed node by node; empty unless they form one tour.
std::vector<int> by_hand(const ArrayTour& tour, const Exchange& exchange) {
  Links links = links_of(tour.nodes());
  const auto swap_link = [&](int v, int old_end, int new_end) {
    (links[v][0] == old_end ? links[v][0] : links[v][1]) = new_end;
  };
  const int ends = 2 * exchange.count;
  for (int i = 0; i < ends; i += 2) {
    swap_link(exchange.t[i], exchange.t[i + 1], -1);
    swap_link(exchange.t[i + 1], exchange.t[i], -1);
  }
  for (int i = 1; i < ends; i += 2) {
    const int a = exchange.t[i], b = exchange.t[i + 1 == ends ? 0 : i + 1];
    swap_link(a, -1, b);
    swap_link(b, -1, a);
  }
  std::vector<int> nodes{0};
  for (int previous = links[0][0], at = 0;;) {
    const int next = links[at][0] == previous ? links[at][1] : links[at][0];
    previous = at;
    at = next;
    if (at == 0 || nodes.size() > links.size()) break;
    nodes.push_back(at);
  }
  return nodes.size() == links.size() ? nodes : std::vector<int>{};
}

/// k different edges of the tour in random order, and random entries; no edge enters that is already there.
std::optional<Exchange> random_exchange(const ArrayTour& tour, int k, Random& random) {
  Exchange exchange;
  exchange.count = k;
  std::vector<int> cuts;
  while (static_cast<int>(cuts.size()) < k) {
    const int p = static_cast<int>(random.below(static_cast<std::uint64_t>(tour.size())));
    if (std::find(cuts.begin(), cuts.end(), p) == cuts.end()) cuts.push_back(p);
  }
  for (int i = 0; i < k; ++i) {
    int a = tour.at(cuts[i]), b = tour.next(a);
    if (random.below(2) == 1) std::swap(a, b);
    exchange.t[2 * i] = a;
    exchange.t[2 * i + 1] = b;
  }
  for (int i = 1; i < 2 * k; i += 2) {
    const int a = exchange.t[i], b = exchange.t[i + 1 == 2 * k ? 0 : i + 1];
    if (a == b || tour.next(a) == b || tour.previous(a) == b) return std::nullopt;
    for (int j = 1; j < i; j += 2) {
      if (std::minmax(a, b) == std::minmax(exchange.t[j], exchange.t[j + 1])) return std::nullopt;
    }
  }
  return exchange;
}

TEST(ArrayTour, ExchangesEqualRelinkingByHand) {
  Random random(11);
  int tours = 0, broken = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const int n = 8 + static_cast<int>(random.below(12));
    ArrayTour tour(random_tour_of(n, random));
    const auto exchange = random_exchange(tour, 2 + static_cast<int>(random.below(4)), random);
    if (!exchange) continue;
    const std::vector<int> expected = by_hand(tour, *exchange);
    ASSERT_EQ(tour.is_tour(*exchange), !expected.empty());
    if (expected.empty()) {
      ++broken;
      continue;
    }
    ++tours;
    const std::vector<int> before = tour.nodes();
    tour.apply(*exchange);
    const Problem closed;
    ASSERT_EQ(canonical(closed, tour.nodes()), canonical(closed, expected));
    for (int p = 0; p < n; ++p) ASSERT_EQ(tour.position(tour.at(p)), p);
    tour.undo();
    ASSERT_EQ(tour.nodes(), before);
  }
  EXPECT_GT(tours, 1000);
  EXPECT_GT(broken, 1000);
}

TEST(ChainedSearch, ItsCostIsTheTourCost) {
  for (const Shape shape : {Shape::kClosedTour, Shape::kOpenPath}) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      Problem problem = random_problem(20 + static_cast<int>(seed) * 30, seed);
      problem.shape = shape;
      if (shape == Shape::kOpenPath && seed % 2 == 0) problem.start = 3;
      if (shape == Shape::kOpenPath && seed % 3 == 0) problem.end = 7;
      const LengthModel model(problem, kCandidates);
      StopRule rule;
      const StopWatch watch(rule);
      Random random(seed);
      ChainedSearch search(model, greedy_tour(model, 0.3, random), default_breadth(), seed);
      search.descend(watch);
      const auto after_descent = search.cost();
      search.run(500, watch);
      EXPECT_LE(search.cost(), after_descent);
      EXPECT_EQ(search.cost(), model.tour_cost(search.nodes()));
      const Tour tour = model.to_problem(search.nodes());
      ASSERT_TRUE(is_valid(problem, tour));
      EXPECT_NEAR(model.length(search.cost()), tour_length(problem, tour), 1e-6);
      EXPECT_EQ(model.tour_cost(model.from_problem(tour)), search.cost());
    }
  }
}

TEST(AbCycles, TogetherAreTheDifferenceOfTheTours) {
  Random random(3);
  for (int trial = 0; trial < 300; ++trial) {
    const int n = 8 + static_cast<int>(random.below(60));
    const Links a = links_of(random_tour_of(n, random)), b = links_of(random_tour_of(n, random));
    AbCycles cycles(n);
    cycles.split(a, b, random);
    EdgeCounts counts(n);
    counts.add(a);
    std::vector<EdgeChange> changes;
    for (int i = 0; i < cycles.count(); ++i) {
      const auto cycle = cycles.cycle(i);
      ASSERT_GE(cycle.size(), 4u);
      ASSERT_EQ(cycle.size() % 2, 0u);
      for (std::size_t k = 0; k < cycle.size(); ++k) {
        changes.push_back({cycle[k], cycle[k + 1 == cycle.size() ? 0 : k + 1], k % 2 == 1});
      }
    }
    counts.apply(changes);  // A minus its own edges plus those of B is B
    for (int v = 0; v < n; ++v) {
      for (const int w : b[v]) ASSERT_EQ(counts.count(v, w), 1);
    }
    const auto edges =
        std::count_if(changes.begin(), changes.end(), [](const EdgeChange& c) { return !c.added; });
    ASSERT_EQ(static_cast<std::size_t>(edges) * 2, changes.size());
  }
}

TEST(Assembly, ChildrenAreToursWithTheGainTheyClaim) {
  Random random(9);
  int children = 0;
  for (int trial = 0; trial < 60; ++trial) {
    Problem problem = random_problem(40 + trial, static_cast<std::uint64_t>(trial));
    if (trial % 2 == 1) problem.shape = Shape::kOpenPath;
    if (trial % 4 == 1) problem.start = 0, problem.end = 1;
    const LengthModel model(problem, kCandidates);
    const auto parent = greedy_tour(model, 1.0, random), other = greedy_tour(model, 1.0, random);
    const Links a = links_of(parent), b = links_of(other);
    AbCycles cycles(model.size());
    cycles.split(a, b, random);
    Assembly assembly(model);
    assembly.set_parent(a);
    assembly.index_cycles(cycles);
    for (int i = 0; i < cycles.count(); ++i) {
      std::vector<int> chosen{i};
      if (trial % 3 == 0) assembly.block_around(cycles, i, chosen);
      Child child;
      if (!assembly.build(cycles, chosen, child)) continue;
      ++children;
      Links links = a;
      const auto relink = [&](int v, int old_end, int new_end) {
        (links[v][0] == old_end ? links[v][0] : links[v][1]) = new_end;
      };
      for (const EdgeChange& c : child.changes) {
        if (!c.added) relink(c.a, c.b, -1), relink(c.b, c.a, -1);
      }
      for (const EdgeChange& c : child.changes) {
        if (c.added) relink(c.a, -1, c.b), relink(c.b, -1, c.a);
      }
      const std::vector<int> nodes = nodes_of(links);
      ASSERT_TRUE(is_permutation_of(nodes, model.size()));
      ASSERT_EQ(model.tour_cost(nodes), model.tour_cost(parent) - child.gain);
    }
  }
  EXPECT_GT(children, 200);
}

TEST(ExchangeSearch, ChangesEqualFullEvaluation) {
  const std::pair<double, ObjectivePtr> parts[] = {
      {1.0, length_objective()}, {3.0, turns_objective()}, {0.1, angle_objective()}};
  std::vector<ObjectivePtr> objectives{length_objective(), turns_objective(), angle_objective(),
                                       time_objective(600), weighted_sum({parts[0], parts[1], parts[2]})};
  Random random(21);
  int checked = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    Problem problem = random_problem(10 + trial % 9, static_cast<std::uint64_t>(trial));
    for (Vec2& p : problem.points) p = {std::round(p.x / 20), std::round(p.y / 20)};
    if (trial % 2 == 1) problem.shape = Shape::kOpenPath;
    const Moves moves(problem);
    const Neighbours near = nearest_neighbours(problem.points, 8);
    const Objective& objective = *objectives[static_cast<std::size_t>(trial) % objectives.size()];
    const Tour tour = random_tour_of(problem.size(), random);
    const ExchangeSearch search(moves, objective, near, tour, 1);
    std::vector<int> nodes = tour;
    if (!problem.closed()) nodes.push_back(problem.size());
    ArrayTour path(nodes);
    const auto exchange = random_exchange(path, 2 + trial % 2, random);
    if (!exchange || !path.is_tour(*exchange)) continue;
    path.apply(*exchange);
    Tour changed = path.nodes();
    if (!problem.closed()) {
      std::rotate(changed.begin(), std::find(changed.begin(), changed.end(), problem.size()), changed.end());
      changed.erase(changed.begin());
    }
    ++checked;
    EXPECT_NEAR(search.local_change(*exchange),
                evaluate(objective, moves, changed) - evaluate(objective, moves, tour), 1e-6);
  }
  EXPECT_GT(checked, 1500);
}

/// Points on a lattice with ends and precedence that differ by seed.
Problem lattice_like(std::uint64_t seed) {
  Problem problem = random_problem(40, seed);
  for (Vec2& p : problem.points) p = {std::round(p.x / 10), std::round(p.y / 10)};
  if (seed % 4 == 0) return problem;
  problem.shape = Shape::kOpenPath;
  if (seed % 4 == 1) problem.start = 0, problem.end = 39;
  if (seed % 4 == 2) problem.precedence = {{5, 2}, {2, 30}, {30, 7}, {11, 10}, {12, 10}};
  return problem;
}

TEST(ExchangeSearch, KeepsItsValueTrueAndItsTourValid) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Problem problem = lattice_like(seed);
    const Moves moves(problem);
    const Neighbours near = nearest_neighbours(problem.points, 8);
    const auto objective = weighted_sum({{1.0, length_objective()}, {2.0, turns_objective()}});
    StopRule rule;
    const StopWatch watch(rule);
    const Tour start = topological_order(problem);
    ExchangeSearch search(moves, *objective, near, start, seed);
    search.descend(watch);
    search.run(200, 0, watch);
    ASSERT_TRUE(is_valid(problem, search.tour()));
    EXPECT_NEAR(search.value(), evaluate(*objective, moves, search.tour()), 1e-6);
    EXPECT_LT(search.value(), evaluate(*objective, moves, start));
  }
}

}  // namespace
}  // namespace clearcut::order
