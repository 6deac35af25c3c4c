// Boards as CAD programs write them: pads on a raster, tracks in segments, each drawn on its own; all nets are parted.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "base/containers.h"
#include "base/random.h"
#include "base/text.h"
#include "pipeline/run.h"
#include "read/job/read_part.h"
#include "resolve/resolve.h"

namespace clearcut::pipeline {
namespace {

constexpr double kPitch = 2.54;  // mm

/// Pads of three apertures in a square, and tracks that join neighbours to nets of a few pads without crossing.
class RandomBoard {
 public:
  RandomBoard(int pads, std::uint64_t seed)
      : random_(seed), pads_(pads), nets_(pads), size_(static_cast<std::size_t>(pads), 1) {
    while (columns_ * columns_ < pads) ++columns_;
    for (int pad = 0; pad < pads_; ++pad) {
      text_ += "D" + std::to_string(10 + random_.below(3)) + "*" + place(at(pad)) + "D03*\n";
    }
    text_ += "D13*\n";
    for (const auto& [a, b] : shuffled_neighbours()) join(a, b);
  }

  std::string gerber() const {
    return "%FSLAX46Y46*%\n%MOMM*%\n%TF.FileFunction,Copper,L1,Top*%\n%ADD10C,1.6*%\n%ADD11R,1.6X1.6*%\n"
           "%ADD12O,1.6X2.0*%\n%ADD13C,0.25*%\n" +
           text_ + "M02*\n";
  }

 private:
  int& size_of(int net) { return size_[static_cast<std::size_t>(net)]; }
  Vec2 at(int pad) const { return Vec2{double(pad % columns_), double(pad / columns_)} * kPitch; }

  static std::string place(Vec2 p) { return "X" + trimmed(p.x * 1e6, 0) + "Y" + trimmed(p.y * 1e6, 0); }

  /// To the right, up, and aslant one way, so that no two cross.
  std::vector<std::pair<int, int>> shuffled_neighbours() {
    std::vector<std::pair<int, int>> all;
    for (int pad = 0; pad < pads_; ++pad) {
      const bool last = pad % columns_ + 1 == columns_;
      if (!last && pad + 1 < pads_) all.emplace_back(pad, pad + 1);
      if (pad + columns_ < pads_) all.emplace_back(pad, pad + columns_);
      if (!last && pad + columns_ + 1 < pads_) all.emplace_back(pad, pad + columns_ + 1);
    }
    for (std::size_t i = all.size(); i > 1; --i) std::swap(all[i - 1], all[random_.below(i)]);
    return all;
  }

  /// One to three segments in a line.
  void join(int a, int b) {
    constexpr int kLargestNet = 6;
    const int first = nets_.find(a), second = nets_.find(b);
    if (first == second || size_of(first) + size_of(second) > kLargestNet) return;
    nets_.join(first, second);
    size_of(second) += size_of(first);
    const int segments = 1 + static_cast<int>(random_.below(3));
    for (int i = 0; i < segments; ++i) {
      text_ += place(lerp(at(a), at(b), double(i) / segments)) + "D02*" +
               place(lerp(at(a), at(b), double(i + 1) / segments)) + "D01*\n";
    }
  }

  Random random_;
  int pads_, columns_ = 1;
  DisjointSets nets_;
  std::vector<int> size_;
  std::string text_;
};

/// CLEARCUT_BOARD_PADS sets how many pads, which are 120 else.
TEST(Boards, NetsOfARasterOfPadsAreIsolated) {
  const char* set = std::getenv("CLEARCUT_BOARD_PADS");
  const RandomBoard board(set ? std::atoi(set) : 120, 1);
  ReadOptions reading;
  reading.depth = 0.1;
  const Part part = read::read_part_text(board.gerber(), "F_Cu.gbr", reading);
  ASSERT_EQ(part.features.size(), 1U);
  EXPECT_EQ(part.features.front().kind, FeatureKind::kIsolation);
  PlanOptions options;
  options.tools = {resolve::parse_tool("endmill:0.2")};
  options.strategy = "contour";
  const PlanResult result = plan_part(part, options);
  EXPECT_EQ(verdict_of(result.findings), Verdict::kClean);
  for (const Condition& condition : result.findings.conditions) EXPECT_NE(condition.name, "not-parted");
}

}  // namespace
}  // namespace clearcut::pipeline
