// Holders and clamps against an independent look at voxels: points of random programs, and cylinders that stand on them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

#include "verify/test_program.h"
#include "verify/verify.h"

namespace clearcut::verify {
namespace {

using clearcut::testing::rectangle;
using clearcut::testing::Writer;

struct Fixture {
  Part part;
  Toolpath program;
};

/// A stock with 1 to 4 clamps around and on it, a cutter in a holder, and level passes, ramps and plunges.
Fixture random_set_up(std::mt19937& random) {
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  Fixture out;
  out.part.is_shape_stated = false;
  out.part.stock = Stock{{{0, 0}, {80, 60}}, -20, 0};
  Tool tool;
  tool.diameter = between(4, 12);
  tool.stickout = between(3, 40);
  tool.holder_diameter = between(15, 50);
  out.part.tools = {tool};
  for (int i = 0, count = 1 + static_cast<int>(between(0, 3.999)); i < count; ++i) {
    const double size = between(5, 25), on = between(-8, 8),
                 along = between(0, 55);  // by how much it lies on the stock
    const Vec2 low[] = {{on - size, along}, {80 - on, along}, {along, on - size}, {along, 60 - on}};
    const Vec2 at = low[static_cast<std::size_t>(between(0, 3.999))];
    out.part.keep_outs.push_back({{at, at + Vec2{size, size}}, -20, between(2, 35)});
  }
  Writer writer;
  writer.enter({between(5, 75), between(5, 55)}, 0, between(-18, -0.5));
  for (int i = 0; i < 6; ++i) {
    const Vec2 to{between(5, 75), between(5, 55)};
    between(0, 1) < 0.7 ? writer.feed(to) : writer.feed(to, between(-18, -0.5));
  }
  out.program = writer.done();
  return out;
}

/// mm by which a tool's bodies are within clamps and stock at most, by samples; below zero where they stay apart.
struct Crossing {
  double clamp = -100, holder = -100;
};

Crossing crossing_of(const Fixture& set_up) {
  constexpr double kCell = 0.5, kStep = 0.25;
  const Tool& tool = set_up.part.tools[0];
  const int columns = static_cast<int>(80 / kCell), rows = static_cast<int>(60 / kCell);
  std::vector<double> height(static_cast<std::size_t>(columns * rows), 0.0);
  Crossing most;
  for (const Section& section : set_up.program.sections)
    for (const Move& move : section.moves) {
      const int count =
          1 + static_cast<int>(std::max(move.path.length(), std::abs(move.z_to - move.z_from)) / kStep);
      const std::vector<double> before = height;
      for (int i = 0; i <= count; ++i) {
        const double t = static_cast<double>(i) / count, z = move.z_from + t * (move.z_to - move.z_from);
        const Vec2 p = move.path.from == move.path.to ? move.path.from : move.path.at(t);
        for (const KeepOut& clamp : set_up.part.keep_outs) {
          const double far = clamp.plan.distance_to(p);
          most.clamp = std::max(most.clamp, std::min(tool.radius() - far, clamp.top_z - z));
          most.clamp = std::max(most.clamp,
                                std::min(tool.holder_diameter / 2 - far, clamp.top_z - z - *tool.stickout));
        }
        for (int x = 0; x < columns; ++x)
          for (int y = 0; y < rows; ++y) {
            const Vec2 cell{(x + 0.5) * kCell, (y + 0.5) * kCell};
            const double far = norm(cell - p);
            const std::size_t k = static_cast<std::size_t>(x * rows + y);
            if (far < tool.radius()) height[k] = std::min(height[k], z);
            most.holder = std::max(most.holder,
                                   std::min(tool.holder_diameter / 2 - far, before[k] - z - *tool.stickout));
          }
      }
    }
  return most;
}

bool has(const Fixture& set_up, FaultKind kind) {
  const Findings findings = verify_program(set_up.part, set_up.program, {});
  return std::any_of(findings.faults.begin(), findings.faults.end(),
                     [&](const Fault& fault) { return fault.kind == kind; });
}

/// The last stickout that a message says to clear it, 0 where none does.
double said_stickout(const Fixture& set_up) {
  double most = 0;
  for (const Fault& fault : verify_program(set_up.part, set_up.program, {}).faults) {
    const std::string words = "which a stickout of ";
    const std::size_t at = fault.text.find(words);
    if (at != std::string::npos) most = std::max(most, std::atof(fault.text.c_str() + at + words.size()));
  }
  return most;
}

TEST(Bodies, AreJudgedAsVoxelsJudgeThem) {
  const char* const set = std::getenv("CLEARCUT_RANDOM_PARTS");
  const int count = set ? std::atoi(set) : 12;
  std::mt19937 random(3);
  int clamps = 0, holders = 0, clear = 0, near = 0;
  for (int i = 0; i < count; ++i) {
    Fixture set_up = random_set_up(random);
    const Crossing voxels = crossing_of(set_up);
    constexpr double kDoubt = 0.8;  // mm; of cells and steps
    const bool clamp = has(set_up, FaultKind::kKeepOut), holder = has(set_up, FaultKind::kHolder);
    if (voxels.clamp > 0.01) {
      EXPECT_TRUE(clamp) << "set-up " << i << ": " << voxels.clamp << " mm into a clamp";
    }
    if (voxels.clamp < -kDoubt) {
      EXPECT_FALSE(clamp) << "set-up " << i << ": clear by " << -voxels.clamp;
    }
    if (voxels.holder > kDoubt) {
      EXPECT_TRUE(holder) << "set-up " << i << ": " << voxels.holder << " mm of the holder in material";
    }
    if (voxels.holder < -kDoubt) {
      EXPECT_FALSE(holder) << "set-up " << i << ": clear by " << -voxels.holder;
    }
    clamps += clamp, holders += holder, clear += !clamp && !holder;
    const double longer = said_stickout(set_up);
    if (longer == 0) continue;
    ++near;
    EXPECT_GT(longer, *set_up.part.tools[0].stickout);
    set_up.part.tools[0].stickout = longer;
    EXPECT_FALSE(has(set_up, FaultKind::kHolder)) << "set-up " << i;
    EXPECT_EQ(said_stickout(set_up), 0) << "set-up " << i;
  }
  std::cout << count << " set-ups: " << clamps << " into clamps, " << holders
            << " with the holder in material, " << clear << " clear; " << near
            << " longer stickouts clear what they say\n";
  EXPECT_GT(holders, 0);
  EXPECT_GT(clear, 0);
}

}  // namespace
}  // namespace clearcut::verify
