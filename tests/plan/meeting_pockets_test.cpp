// Pockets that meet where their outlines all but coincide: planner and verifier are of one mind about the wall between them.
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/check.h"
#include "pipeline/run.h"

namespace clearcut {
namespace {

Feature pocket(const char* name, const std::vector<Vec2>& corners) {
  Feature feature;
  feature.name = name;
  feature.target = feature.allowed = {Region::from_valid_loops(loop_from_points(corners), {})};
  feature.floor_z = -1;
  return feature;
}

/// A pocket, and another one round three sides of it with a wall of `thickness` mm between them (less than 0: they
/// overlap).
Part part_with_wall(double thickness) {
  const double t = thickness;
  Part part;
  part.name = part.source_file = "wall";
  part.features = {
      pocket("inner", {{0, 0}, {12, 0}, {12, 10}, {0, 10}}),
      pocket("around",
             {{-10, -10}, {22, -10}, {22, 10}, {12 + t, 10}, {12 + t, -t}, {-t, -t}, {-t, 10}, {-10, 10}})};
  for (int i = 0; i < 2; ++i) {
    Workingstep step;
    step.feature = i;
    part.workplan.push_back(step);
  }
  return part;
}

TEST(MeetingPockets, AreOneOverAWallThinnerThanTheRoundingOfADrawing) {
  Tool mill;
  mill.diameter = 1;
  PlanOptions options;
  options.tools = {mill};
  options.strategy = "contour";
  for (const double thickness : {-0.001, -4e-6, 1e-7, 4e-6, 9e-6, 1.2e-5, 1e-4, 0.001}) {
    const auto result = pipeline::plan_part(part_with_wall(thickness), options);
    for (const auto& fault : result.findings.faults)
      ADD_FAILURE() << "wall of " << thickness << " mm: " << fault.text;
  }
}

Feature pocket(const char* name, const std::vector<BulgeVertex>& corners) {
  Feature feature = pocket(name, std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}});
  feature.target = feature.allowed = {Region::from_valid_loops(loop_from_bulges(corners), {})};
  return feature;
}

/// Two pockets on both sides of one line, bent in every other piece by up to `bend`, that was drawn twice: its points
/// differ by up to `off` mm.
Part part_drawn_twice(double off, double bend, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  std::vector<BulgeVertex> below{{{-6, -5}, 0}, {{6, -5}, 0}}, above{{{6, 5}, 0}, {{-6, 5}, 0}}, back;
  double bulge = 0;
  for (int i = 0; i < 8; ++i) {
    const Vec2 p{-5 + 1.4 * i + between(-0.5, 0.5), between(-0.05, 0.05)};
    back.push_back({p + Vec2{between(-off, off), between(-off, off)}, -bulge});
    bulge = i % 2 == 0 ? between(-bend, bend) : 0;
    above.push_back({p + Vec2{between(-off, off), between(-off, off)}, bulge});
  }
  above.back().bulge = 0;
  below.insert(below.end(), back.rbegin(), back.rend());
  Part part;
  part.name = part.source_file = "drawn twice";
  part.features = {pocket("below", below), pocket("above", above)};
  for (int i = 0; i < 2; ++i) {
    Workingstep step;
    step.feature = i;
    part.workplan.push_back(step);
  }
  return part;
}

TEST(MeetingPockets, OnBothSidesOfALineDrawnTwiceAreCutWithoutFaults) {
  Tool mill;
  mill.diameter = 1;
  PlanOptions options;
  options.tools = {mill};
  options.strategy = "contour";
  for (const double off : {1e-5, 5e-5, 1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 0.02}) {
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const auto result = pipeline::plan_part(part_drawn_twice(off, seed % 2 == 0 ? 0 : 0.3, seed), options);
      for (const auto& fault : result.findings.faults)
        ADD_FAILURE() << "points " << off << " mm off, seed " << seed << ": " << fault.text;
    }
  }
}

/// Four pockets of two depths that fill a rectangle but for the fourth in some; every corner of each is drawn up to `off` mm
/// from where the next one has it.
Part mosaic(double off, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto between = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  Vec2 nodes[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double dx = i == 1 ? between(-3, 3) : 0, dy = j == 1 ? between(-3, 3) : 0;
      nodes[i][j] = Vec2{(i - 1) * 9.0 + dx, (j - 1) * 7.0 + dy};
    }
  }
  Part part;
  part.name = part.source_file = "mosaic";
  const int cells = seed % 3 == 0 ? 3 : 4;
  for (int cell = 0; cell < cells; ++cell) {
    const int i = cell % 2, j = cell / 2;
    std::vector<Vec2> corners{nodes[i][j], nodes[i + 1][j], nodes[i + 1][j + 1], nodes[i][j + 1]};
    for (Vec2& corner : corners) corner = corner + Vec2{between(-off, off), between(-off, off)};
    part.features.push_back(pocket(("cell " + std::to_string(cell)).c_str(), corners));
    part.features.back().floor_z = between(0, 1) < 0.5 ? -1 : -2;
    Workingstep step;
    step.feature = cell;
    part.workplan.push_back(step);
  }
  return part;
}

TEST(MeetingPockets, OfAMosaicAreCutWithoutFaults) {
  Tool mill;
  mill.diameter = 1.7;
  PlanOptions options;
  options.tools = {mill};
  for (const double off : {0.0, 1e-6, 1e-5, 1e-4, 2e-4}) {
    for (std::uint64_t seed = 0; seed < 9; ++seed) {
      options.strategy = seed % 2 == 0 ? "zigzag" : "contour";
      const auto result = pipeline::plan_part(mosaic(off, seed), options);
      for (const auto& fault : result.findings.faults)
        ADD_FAILURE() << "corners " << off << " mm off, seed " << seed << ": " << fault.text;
    }
  }
}

TEST(MeetingPockets, AreCutAcrossASliverButNotAcrossAWall) {
  Tool mill;
  mill.diameter = 1;
  PlanOptions options;
  options.tools = {mill};
  options.strategy = "zigzag";
  const std::string program = pipeline::plan_part(part_with_wall(0), options).program;
  for (const double thickness : {1e-4, 4e-4, 7e-4, 1.2e-3, 0.002, 0.01}) {
    const auto result = pipeline::check_program(part_with_wall(thickness), program, "joined", options);
    EXPECT_EQ(result.findings.faults.empty(), thickness <= 1e-3) << "wall of " << thickness << " mm";
  }
}

}  // namespace
}  // namespace clearcut
