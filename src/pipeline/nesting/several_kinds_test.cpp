#include "pipeline/nesting/several_kinds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/random.h"

namespace clearcut::pipeline {
namespace {

Box box_at(const KindsQuestion& q, const KindPlace& place) {
  const NestKind& kind = q.kinds[place.kind];
  return {place.at,
          place.at + (place.turned ? Vec2{kind.height, kind.width} : Vec2{kind.width, kind.height})};
}

bool is_on_sheet(const KindsQuestion& q, const Box& one) {
  return one.min.x >= q.edge - 1e-6 && one.min.y >= q.edge - 1e-6 && one.max.x <= q.width - q.edge + 1e-6 &&
         one.max.y <= q.height - q.edge + 1e-6;
}

bool is_apart(const Box& a, const Box& b, double gap) {
  return a.min.x >= b.max.x + gap - 1e-6 || b.min.x >= a.max.x + gap - 1e-6 ||
         a.min.y >= b.max.y + gap - 1e-6 || b.min.y >= a.max.y + gap - 1e-6;
}

bool is_free(const KindsQuestion& q, const Box& one, const std::vector<Box>& taken) {
  const auto apart = [&](const Box& other) { return is_apart(one, other, q.gap); };
  return is_on_sheet(q, one) && std::all_of(taken.begin(), taken.end(), apart) &&
         std::all_of(q.kept_free.begin(), q.kept_free.end(), apart);
}

/// A place for one more of the kind: where there is one, there is one that touches others, or the edge, on its left and below.
bool has_place(const KindsQuestion& q, std::size_t kind, const std::vector<Box>& taken) {
  std::set<double> xs{q.edge}, ys{q.edge};
  for (const auto* boxes : {&taken, &q.kept_free}) {
    for (const Box& one : *boxes) {
      xs.insert(one.max.x + q.gap);
      ys.insert(one.max.y + q.gap);
    }
  }
  for (const double x : xs)
    for (const double y : ys)
      for (const bool turned : {false, true})
        if (is_free(q, box_at(q, {kind, {x, y}, turned}), taken)) return true;
  return false;
}

KindsQuestion random_question(Random& random) {
  KindsQuestion q;
  q.width = random.between(80, 400);
  q.height = random.between(80, 300);
  q.edge = random.between(0, 8);
  q.gap = random.unit() < 0.2 ? 0 : random.between(0, 10);
  const int kinds = 2 + static_cast<int>(random.between(0, 2.99));
  for (int k = 0; k < kinds; ++k) {
    NestKind kind{random.between(15, 90), random.between(15, 90), {}};
    if (random.unit() < 0.6) kind.count = 1 + static_cast<int>(random.between(0, 7));
    q.kinds.push_back(kind);
  }
  for (int k = static_cast<int>(random.between(0, 2.99)); k > 0; --k) {
    const Vec2 at{random.between(0, q.width - 20), random.between(0, q.height - 20)};
    q.kept_free.push_back({at, at + Vec2{random.between(5, 20), random.between(5, 20)}});
  }
  return q;
}

/// Rectangles lie on the sheet, a gap from each other and from what is kept free, no more than are wanted; and where fewer are there, none
/// has a place any more.
TEST(NestKinds, PlacesAreApartAndNoneIsLeft) {
  Random random(13);
  for (int round = 0; round < 120; ++round) {
    const KindsQuestion q = random_question(random);
    std::vector<Box> taken;
    std::vector<int> placed(q.kinds.size(), 0);
    for (const KindPlace& place : nest_kinds(q)) {
      const Box one = box_at(q, place);
      EXPECT_TRUE(is_free(q, one, taken)) << round;
      taken.push_back(one);
      ++placed[place.kind];
    }
    for (std::size_t kind = 0; kind < q.kinds.size(); ++kind) {
      const auto& count = q.kinds[kind].count;
      if (count) {
        EXPECT_LE(placed[kind], *count);
      }
      if (!count || placed[kind] < *count) {
        EXPECT_FALSE(has_place(q, kind, taken)) << round << " kind " << kind;
      }
    }
  }
}

/// What fits exactly is found: gaps take no place beyond the outermost parts.
TEST(NestKinds, WhatFitsExactlyIsFound) {
  KindsQuestion q{100, 60, 5, 2, {{44, 50, 1}, {44, 24, 2}}, {}};
  EXPECT_EQ(nest_kinds(q).size(), 3U);
  q.width = 99.9;
  EXPECT_EQ(nest_kinds(q).size(), 2U);
}

/// Kinds without a number come in equal numbers, beside those with one.
TEST(NestKinds, KindsWithoutANumberTakeTurns) {
  const KindsQuestion q{200, 100, 0, 0, {{20, 20, {}}, {20, 20, {}}, {40, 40, 2}}, {}};
  std::vector<int> placed(3, 0);
  for (const KindPlace& place : nest_kinds(q)) ++placed[place.kind];
  EXPECT_EQ(placed, (std::vector<int>{21, 21, 2}));
}

/// A kind that wants the whole sheet leaves room for the others.
TEST(NestKinds, EachKindHasAPlaceWhereThatIsPossible) {
  const KindsQuestion q{100, 100, 0, 0, {{50, 50, 100}, {10, 10, 3}}, {}};
  std::vector<int> placed(2, 0);
  for (const KindPlace& place : nest_kinds(q)) ++placed[place.kind];
  EXPECT_EQ(placed[0], 3);
  EXPECT_EQ(placed[1], 3);
}

}  // namespace
}  // namespace clearcut::pipeline
