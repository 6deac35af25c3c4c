// Each kind of move runs at its own feed, and what runs faster than the cutting feed cuts nothing.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "base/error.h"
#include "pipeline/run.h"
#include "stock/material.h"
#include "support/random/random_parts.h"

namespace clearcut {
namespace {

Part pocket_with_island(double diameter) {
  const auto box = [](double x0, double y0, double x1, double y1) {
    return loop_from_points(std::vector<Vec2>{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
  };
  const Regions target{Region::from_valid_loops(box(0, 0, 80, 50), {reversed(box(30, 20, 50, 30))})};
  return test_support::part_of(target, target, FeatureKind::kClosedPocket, diameter);
}

TEST(Feeds, EveryKindOfMoveHasItsOwn) {
  for (const char* strategy : {"contour", "zigzag", "spiral", "adaptive"}) {
    PlanOptions options;
    options.strategy = strategy;
    options.cutting.feed = MmPerMin::of(1000);
    options.cutting.plunge_feed = MmPerMin::of(111);
    options.cutting.ramp_feed = MmPerMin::of(222);
    options.cutting.slot_feed = MmPerMin::of(555);
    options.shop.lead_feed = MmPerMin::of(333);
    options.shop.link_feed = MmPerMin::of(444);
    options.lead = 1;
    options.entry = EntryKind::kHelix;
    const auto result = pipeline::plan_part(pocket_with_island(6), options);
    ASSERT_TRUE(result.findings.all.clean) << strategy;
    std::set<double> level;
    for (const auto& section : result.toolpath.sections) {
      for (const Move& move : section.moves) {
        if (is_rapid(move.kind)) continue;
        const double feed = move.feed.mm_per_min();
        if (move.is_vertical() && move.z_to < move.z_from) {
          EXPECT_EQ(feed, 111) << strategy;
        } else if (move.z_to < move.z_from) {
          EXPECT_EQ(feed, 222) << strategy;
        } else if (move.z_to == move.z_from) {
          level.insert(feed);
        }
      }
    }
    // Helices end with a flat turn at their own feed.
    for (const double feed : level)
      EXPECT_TRUE((std::set<double>{222, 333, 444, 555, 1000}.count(feed))) << feed;
    EXPECT_TRUE(level.count(1000)) << strategy;
  }
}

/// Degrees of the cutter's circle in material, at most, on level moves faster than `feed`.
double widest_contact_above(const PlanResult& result, double feed) {
  const double radius = result.part.tools.front().radius();
  const auto& stock = result.part.stock;
  stock::Material material(stock ? std::optional(stock->plan) : std::nullopt, 0, {radius});
  double widest = 0;
  for (const auto& section : result.toolpath.sections) {
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind)) continue;
      if (move.feed.mm_per_min() > feed && move.z_from == move.z_to) {
        Move lifted = move;  // residuals on the floor are rounding
        lifted.z_from = lifted.z_to = move.z_to + 1e-3;
        for (const double t : {0.02, 0.25, 0.5, 0.75, 0.98})
          widest = std::max(widest, material.engagement(lifted, t, radius - 0.01).angle * 180 / kPi);
      }
      material.add(move, radius);
    }
  }
  return widest;
}

TEST(Feeds, WhatIsFasterThanTheCuttingFeedCutsNothing) {
  const int count = test_support::random_count(8);
  for (const char* strategy : {"contour", "zigzag", "spiral", "adaptive", "fixed", "bisectors"}) {
    for (int i = 0; i < count; ++i) {
      Random random(static_cast<std::uint64_t>(i) + 1);
      const Part part = test_support::random_part(random, random.between(3, 8));
      if (part.features.front().target.empty()) continue;
      PlanOptions options;
      options.strategy = strategy;
      options.threads = 1;
      if (i % 2) options.shop.link_feed = MmPerMin::of(3000);
      try {
        const auto result = pipeline::plan_part(part, options);
        const double feed = result.part.workplan.front().operation.cutting.feed->mm_per_min();
        EXPECT_LT(widest_contact_above(result, feed), 5) << strategy << ", seed " << i + 1;
      } catch (const InputError&) {
      }
    }
  }
}

/// Whatever is stated, and where the cutter goes through what it has cut before.
TEST(Feeds, NoneIsAboveTheMachines) {
  for (const char* strategy : {"contour", "adaptive"}) {
    PlanOptions options;
    options.strategy = strategy;
    options.machine.max_feed = MmPerMin::of(300);
    options.cutting.plunge_feed = options.cutting.ramp_feed = MmPerMin::of(2000);
    options.cutting.slot_feed = options.shop.lead_feed = MmPerMin::of(3000);
    if (strategy == std::string("contour")) options.shop.link_feed = MmPerMin::of(4000);
    const auto result = pipeline::plan_part(pocket_with_island(6), options);
    for (const auto& section : result.toolpath.sections) {
      for (const Move& move : section.moves)
        EXPECT_LE(is_rapid(move.kind) ? 0 : move.feed.mm_per_min(), 300 + 1e-6) << strategy;
    }
  }
}

}  // namespace
}  // namespace clearcut
