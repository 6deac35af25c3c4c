// The published genetic algorithm: what crossover and mutation promise.
#include "order/genetic/operators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/error.h"
#include "order/genetic/pool.h"
#include "order/genetic/test_problems.h"
#include "order/test_support.h"

namespace clearcut::order {
namespace {

using testing::open_problem;
using testing::problem_of_kind;
using testing::random_genome;

/// Tour 3.6.2 (b.2.1) and table 3.1.
const Genome kParent1({0, 3, 7, 5, 4, 1, 8, 2, 6});

const Genome kParent2({0, 5, 8, 2, 6, 3, 1, 4, 7});

TEST(Crossover, EveryChildIsAValidOrder) {
  for (const std::string& name : crossover_names()) {
    for (int kind = 0; kind < 3; ++kind) {
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Problem problem = problem_of_kind(kind, 2 + static_cast<int>(seed) * 2, seed);
        const Moves moves(problem);
        const OperatorContext context(moves, 24);
        if (context.free_count() < 2) continue;
        Random random(seed);
        const auto crossover = crossover_named(name, context);
        Genome child;
        for (int i = 0; i < 10; ++i) {
          crossover->cross(random_genome(problem, random), random_genome(problem, random), random, child);
          EXPECT_TRUE(is_valid(problem, child.genes())) << name << " kind " << kind << " seed " << seed;
          for (int p = 0; p < child.size(); ++p) EXPECT_EQ(child.place(child.at(p)), p);
        }
      }
    }
  }
}

TEST(Crossover, TwoEqualParentsHaveThatChild) {
  for (const char* name : {"pmx", "ox", "cx", "eax"}) {
    const Problem problem = open_problem(20, 3);
    const Moves moves(problem);
    const OperatorContext context(moves, 24);
    Random random(1);
    const Genome parent = random_genome(problem, random);
    Genome child;
    crossover_named(name, context)->cross(parent, parent, random, child);
    EXPECT_EQ(child.genes(), parent.genes()) << name;
  }
}

/// Tour table 3.1: the genetic edges of the text's parents.
TEST(Crossover, GeneticEdgesAreThoseOfTable31) {
  const std::vector<std::vector<int>> printed{{3, 5, 6, 7}, {3, 4, 8}, {6, 8},       {0, 1, 6, 7}, {1, 5, 7},
                                              {0, 4, 7, 8}, {0, 2, 3}, {0, 3, 4, 5}, {1, 2, 5}};
  for (int gene = 0; gene < 9; ++gene)
    EXPECT_EQ(genetic_edges(kParent1, kParent2, gene), printed[static_cast<std::size_t>(gene)]) << gene;
}

/// Tour 3.6.2 (b.2.1): the stretch of the fourth to the sixth gene.
TEST(Crossover, OneStretchMapsAsInTheText) {
  Genome child;
  map_stretch(kParent1, kParent2, 3, 5, child);
  EXPECT_EQ(child.genes(), (Tour{0, 1, 7, 2, 6, 3, 8, 5, 4}));
  map_stretch(kParent2, kParent1, 3, 5, child);
  EXPECT_EQ(child.genes(), (Tour{0, 2, 8, 5, 4, 1, 3, 6, 7}));
}

/// What each of the operators of 3.6.2 takes from whom, on random parents.
class OperatorsOfTheReview : public ::testing::Test {
 protected:
  static constexpr int kGenes = 30;
  /// Children of 200 pairs of parents.
  template <class Check>
  void each_child(const std::string& name, const Check& check) {
    const Problem problem = open_problem(kGenes, 4);
    const Moves moves(problem);
    const OperatorContext context(moves, 24);
    const auto crossover = crossover_named(name, context);
    Random random(11);
    Genome child;
    for (int i = 0; i < 200; ++i) {
      const Genome a = random_genome(problem, random), b = random_genome(problem, random);
      crossover->cross(a, b, random, child);
      check(a, b, child, moves);
    }
  }
};

TEST_F(OperatorsOfTheReview, PositionsOfOneAndOrderOfTheOther) {
  int kept = 0;
  each_child("pos", [&](const Genome& a, const Genome& b, const Genome& child, const Moves&) {
    Tour rest;
    for (int p = 0; p < kGenes; ++p)
      if (child.at(p) != b.at(p)) rest.push_back(a.place(child.at(p)));
    EXPECT_TRUE(std::is_sorted(rest.begin(), rest.end()));
    kept += kGenes - static_cast<int>(rest.size());
  });
  EXPECT_GT(kept, 200 * kGenes / 3);
  each_child("ox2", [&](const Genome& a, const Genome& b, const Genome& child, const Moves&) {
    Tour moved;
    for (int p = 0; p < kGenes; ++p)
      if (child.at(p) != a.at(p)) moved.push_back(b.place(child.at(p)));
    EXPECT_TRUE(std::is_sorted(moved.begin(), moved.end()));
  });
}

TEST_F(OperatorsOfTheReview, AgreementAndTurns) {
  each_child("vr", [&](const Genome& a, const Genome& b, const Genome& child, const Moves&) {
    for (int p = 0; p < kGenes; ++p) {
      if (a.at(p) != b.at(p)) continue;
      EXPECT_EQ(child.at(p), a.at(p));
    }
  });
  each_child("ap", [&](const Genome& a, const Genome& b, const Genome& child, const Moves&) {
    EXPECT_TRUE(child.at(0) == a.at(0) || child.at(0) == b.at(0));
    EXPECT_TRUE(child.at(1) == a.at(0) || child.at(1) == b.at(0) || a.at(0) == b.at(0));
  });
  int shortest = kGenes, half = 0;
  double mean = 0;
  each_child("mpx", [&](const Genome& a, const Genome& b, const Genome& child, const Moves&) {
    int run = 1;
    while (run < kGenes && b.place(child.at(run)) == b.place(child.at(run - 1)) + 1) ++run;
    shortest = std::min(shortest, run);
    half += run == kGenes / 2 ? 1 : 0;
    mean += run / 200.0;
    Tour rest;
    for (int p = run; p < kGenes; ++p) rest.push_back(a.place(child.at(p)));
    EXPECT_TRUE(std::is_sorted(rest.begin(), rest.end()));
  });
  EXPECT_EQ(shortest, 10);
  EXPECT_GE(half, 15) << "of 200, where 10 to 15 are equally often";
  EXPECT_NEAR(mean, (10 + kGenes / 2) / 2.0, 0.25);
}

/// UPMX maps a third of the positions and one more, each by a number of its own.
TEST(Crossover, UniformMappingTakesAThirdOfThePositions) {
  const Problem problem = open_problem(30, 4);
  const Moves moves(problem);
  const OperatorContext context(moves, 24);
  Random random(3);
  const Genome a = random_genome(problem, random), b = random_genome(problem, random);
  Random same(random.state());
  Genome child;
  crossover_named("upmx", context)->cross(a, b, random, child);
  for (int i = 0; i < 1 + 30 / 3; ++i) context.any_position(same);
  EXPECT_EQ(random.state(), same.state());
}

/// PSM switches a quarter of the genes of a stretch, each with any of it: 1 - 3/4 exp(-1/4) of them move.
TEST(Mutation, PartialShuffleSwitchesAQuarter) {
  const Problem problem = open_problem(400, 4);
  const Moves moves(problem);
  const OperatorContext context(moves, 24);
  const auto mutation = mutation_named("partial-shuffle", context);
  Random random(3);
  const Genome genome = random_genome(problem, random);
  double genes = 0, moved = 0;
  for (int i = 0; i < 300; ++i) {
    const Rearrangement change = mutation->choose(genome, random);
    for (std::size_t k = 0; k < change.genes.size(); ++k)
      moved += change.genes[k] != genome.at(change.first + static_cast<int>(k)) ? 1 : 0;
    genes += static_cast<double>(change.genes.size());
  }
  EXPECT_NEAR(moved / genes, 1 - 0.75 * std::exp(-0.25), 0.02);
}

/// Moves come from a parent unless both lead to used genes.
TEST_F(OperatorsOfTheReview, MovesOfTheParents) {
  for (const char* name : {"hx", "aer", "scx"}) {
    int inherited = 0;
    each_child(name, [&](const Genome& a, const Genome& b, const Genome& child, const Moves&) {
      for (int p = 0; p + 1 < kGenes; ++p) {
        const int from = child.at(p), to = child.at(p + 1);
        inherited += a.place(to) == a.place(from) + 1 || b.place(to) == b.place(from) + 1 ? 1 : 0;
      }
    });
    EXPECT_GT(inherited, 200 * (kGenes - 1) * 2 / 5) << name;
  }
}

TEST_F(OperatorsOfTheReview, SortedMatchesNeverGetLonger) {
  const auto length = [](const Genome& genome, const Moves& moves) {
    double sum = 0;
    for (int p = 0; p + 1 < genome.size(); ++p) sum += moves.length(genome.at(p), genome.at(p + 1));
    return sum;
  };
  each_child("smx", [&](const Genome& a, const Genome&, const Genome& child, const Moves& moves) {
    EXPECT_LE(length(child, moves), length(a, moves) + 1e-9);
  });
}

/// A stretch that both parents run through between the same ends takes the shorter order.
TEST(Crossover, SortedMatchTakesTheShorterOrder) {
  Problem row;
  for (int i = 0; i < 8; ++i) row.points.push_back({static_cast<double>(i), 0});
  row.shape = Shape::kOpenPath;
  const Moves moves(row);
  const OperatorContext context(moves, 24);
  const auto crossover = smx(context);
  Random random(1);
  Genome child;
  const Genome first({0, 1, 3, 2, 4, 5, 7, 6});
  int shorter = 0;
  for (int i = 0; i < 50; ++i) {
    crossover->cross(first, Genome({0, 1, 2, 3, 4, 7, 5, 6}), random, child);
    if (child.genes() == first.genes()) continue;  // 4 5 7 6 is the shorter order already
    EXPECT_EQ(child.genes(), (Tour{0, 1, 2, 3, 4, 5, 7, 6}));
    ++shorter;
  }
  EXPECT_GT(shorter, 10);
}

/// The text's two offspring: the stretch 5 4 1 of parent 1 in parent 2, and 2 6 3 of parent 2 in parent 1.
TEST(Crossover, PmxGivesTheTextsOffspring) {
  const Problem problem = open_problem(9, 1);
  const Moves moves(problem);
  const OperatorContext context(moves, 24);
  const auto crossover = pmx(context);
  Random random(1);
  bool first_seen = false, second_seen = false;
  Genome child;
  for (int i = 0; i < 2000; ++i) {
    crossover->cross(kParent1, kParent2, random, child);
    first_seen = first_seen || child.genes() == Tour{0, 1, 7, 2, 6, 3, 8, 5, 4};
    crossover->cross(kParent2, kParent1, random, child);
    second_seen = second_seen || child.genes() == Tour{0, 2, 8, 5, 4, 1, 3, 6, 7};
  }
  EXPECT_TRUE(first_seen);
  EXPECT_TRUE(second_seen);
}

/// Outside the stretch a PMX child differs from the first parent only where a displaced gene went: at most as
/// many positions as inside.
TEST(Crossover, PmxKeepsMostOfTheFirstParent) {
  const Problem problem = open_problem(40, 2);
  const Moves moves(problem);
  const OperatorContext context(moves, 24);
  const auto crossover = pmx(context);
  Random random(5);
  Genome child;
  for (int i = 0; i < 200; ++i) {
    const Genome a = random_genome(problem, random), b = random_genome(problem, random);
    crossover->cross(a, b, random, child);
    int as_first = 0, as_second = 0;
    for (int p = 0; p < 40; ++p) {
      as_first += child.at(p) == a.at(p) ? 1 : 0;
      as_second += child.at(p) == b.at(p) ? 1 : 0;
    }
    EXPECT_GE(as_first + 2 * as_second, 40);
    EXPECT_GE(as_second, 1);
  }
}

/// The genes that do not come from the second parent keep the order they have in the first.
TEST(Crossover, OxKeepsTheOrderOfTheRest) {
  const Problem problem = open_problem(30, 2);
  const Moves moves(problem);
  const OperatorContext context(moves, 24);
  const auto crossover = ox(context);
  Random random(5);
  Genome child;
  for (int i = 0; i < 200; ++i) {
    const Genome a = random_genome(problem, random), b = random_genome(problem, random);
    crossover->cross(a, b, random, child);
    bool explained = false;
    for (int low = 0; low < 30 && !explained; ++low) {
      for (int high = low; high < 30 && !explained; ++high) {
        Tour rest;
        bool donated = true;
        for (int p = low; p <= high; ++p) donated = donated && child.at(p) == b.at(p);
        for (int p = 0; p < 30; ++p) {
          if (p < low || p > high) rest.push_back(a.place(child.at(p)));
        }
        explained = donated && std::is_sorted(rest.begin(), rest.end());
      }
    }
    EXPECT_TRUE(explained);
  }
}

TEST(Crossover, CxGivesEveryPositionAGeneOfOneOfTheParents) {
  const Problem problem = open_problem(30, 2);
  const Moves moves(problem);
  const OperatorContext context(moves, 24);
  const auto crossover = cx(context);
  Random random(5);
  Genome child;
  for (int i = 0; i < 200; ++i) {
    const Genome a = random_genome(problem, random), b = random_genome(problem, random);
    crossover->cross(a, b, random, child);
    int from_second = 0;
    for (int p = 0; p < 30; ++p) {
      EXPECT_TRUE(child.at(p) == a.at(p) || child.at(p) == b.at(p));
      from_second += child.at(p) == b.at(p) ? 1 : 0;
    }
    EXPECT_GE(from_second, 1);
  }
}

/// Nearly all edges of an ERX child are edges of a parent; for the text's parents table 3.1 lists them.
TEST(Crossover, ErxInheritsEdges) {
  const Problem problem = random_problem(60, 2);
  const Moves moves(problem);
  const OperatorContext context(moves, 24);
  const auto crossover = erx(context);
  Random random(5);
  Genome child;
  double shared = 0;
  for (int i = 0; i < 100; ++i) {
    const Genome a = random_genome(problem, random), b = random_genome(problem, random);
    crossover->cross(a, b, random, child);
    int inherited = 0;
    for (int p = 0; p < 60; ++p) {
      const int u = child.at(p), v = child.at((p + 1) % 60);
      inherited += has_edge(a, u, v, true) || has_edge(b, u, v, true) ? 1 : 0;
    }
    shared += inherited / 60.0;
  }
  EXPECT_GT(shared / 100, 0.75);
}

/// An EAX child has the edges of its parents, except the few that join subtours.
TEST(Crossover, EaxInheritsEdges) {
  const Problem problem = random_problem(100, 4);
  const Moves moves(problem);
  const OperatorContext context(moves, 24);
  const auto crossover = eax(context);
  Random random(5);
  Genome child;
  int different = 0;
  for (int i = 0; i < 30; ++i) {
    const Genome a(nearest_path(context, 2, random)), b(nearest_path(context, 2, random));
    crossover->cross(a, b, random, child);
    int foreign = 0;
    for (int p = 0; p < 100; ++p) {
      const int u = child.at(p), v = child.at((p + 1) % 100);
      foreign += has_edge(a, u, v, true) || has_edge(b, u, v, true) ? 0 : 1;
    }
    EXPECT_LE(foreign, 30);
    different += child.genes() == a.genes() ? 0 : 1;
  }
  EXPECT_GT(different, 15);
}

/// New edges that a mutation makes at most; those that are not here may make any number.
const std::map<std::string, int> kMostNewEdges{{"exchange", 4},         {"inversion", 2},
                                               {"nearest", 2},          {"displacement", 3},
                                               {"insertion", 3},        {"inverted-displacement", 3},
                                               {"centre-inversion", 3}, {"three-successive", 4},
                                               {"three-random", 6},     {"shorter", 2}};

TEST(Mutation, PromisesHold) {
  for (int kind = 0; kind < 3; ++kind) {
    const Problem problem = problem_of_kind(kind, 40, 7);
    const Moves moves(problem);
    const OperatorContext context(moves, 6);
    const bool closed = problem.closed();
    for (const std::string& name : mutation_names()) {
      const auto mutation = mutation_named(name, context);
      Random random(3);
      int changed = 0;
      for (int i = 0; i < 300; ++i) {
        const Genome before = random_genome(problem, random);
        Genome after = before;
        after.apply(mutation->choose(before, random));
        ASSERT_TRUE(is_valid(problem, after.genes())) << name;
        const int edges = closed ? 40 : 39;
        const int fresh = edges - static_cast<int>(std::lround(shared_edges(after, before, closed) * edges));
        const auto most = kMostNewEdges.find(name);
        EXPECT_LE(fresh, most == kMostNewEdges.end() ? edges : most->second) << name;  // Tour 4.3.3 iii
        changed += after.genes() != before.genes() ? 1 : 0;
        if (name != "nearest" || fresh == 0) continue;
        bool near = false;  // one of the new edges joins near neighbours
        for (int p = 0; p < edges; ++p) {
          const int a = after.at(p), b = after.at((p + 1) % 40);
          if (has_edge(before, a, b, closed)) continue;
          const auto& of_a = context.neighbours.nearest(a);
          const auto& of_b = context.neighbours.nearest(b);
          near =
              near || std::count(of_a.begin(), of_a.end(), b) + std::count(of_b.begin(), of_b.end(), a) > 0;
        }
        EXPECT_TRUE(near);
      }
      EXPECT_GT(changed, name == "shorter" || name == "three-random" ? 100 : 200) << name << " kind " << kind;
    }
  }
}

}  // namespace
}  // namespace clearcut::order
