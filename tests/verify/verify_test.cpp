// The check against programs as they come: planned by us, stripped of every word that is not motion, or
// spoilt at random and checked a second time by sampling.
#include "verify/verify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

#include "base/error.h"
#include "base/random.h"
#include "base/text.h"
#include "pipeline/check.h"
#include "pipeline/run.h"
#include "read/gcode/gcode.h"

namespace clearcut {
namespace {

constexpr double kRadius = 2;

/// 24 x 16 mm with a round island: small enough for the slow check.
Part small_part(double depth) {
  const std::vector<Vec2> corners{{0, 0}, {24, 0}, {24, 16}, {0, 16}};
  const Vec2 a{18, 8}, b{15, 8}, c{16.5, 8};
  const Loop island{Edge::arc(a, b, c, Turn::kCounterClockwise), Edge::arc(b, a, c, Turn::kCounterClockwise)};
  Part part;
  part.name = "small";
  Feature feature;
  feature.name = "SMALL";
  feature.target = feature.allowed = {Region::from_valid_loops(loop_from_points(corners), {island})};
  feature.floor_z = -depth;
  part.features.push_back(feature);
  part.workplan.push_back({});
  return part;
}

PlanResult planned(double depth) {
  PlanOptions options;
  options.tools = {resolve::parse_tool("endmill:4")};
  options.stepdown = 2;
  options.strategy = "contour";
  return pipeline::plan_part(small_part(depth), options);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

Findings checked(const Part& part, const std::string& text) {
  return pipeline::check_program(part, text, "x.ngc", {}, Dialect::kLinuxCnc).findings;
}

bool has(const Findings& findings, FaultKind kind) {
  return std::any_of(findings.faults.begin(), findings.faults.end(),
                     [&](const Fault& f) { return f.kind == kind; });
}

TEST(VerifyPrograms, TheVerdictNeedsNoCommentNorLabel) {
  const PlanResult result = planned(4);
  ASSERT_TRUE(result.findings.all.clean);
  const std::string bare = std::regex_replace(result.program, std::regex("\\([^)]*\\)"), "");
  ASSERT_NE(bare, result.program);
  const Findings findings = checked(result.part, bare);
  EXPECT_TRUE(findings.all.clean);
  EXPECT_EQ(findings.all.uncut_thickness_mm, result.findings.all.uncut_thickness_mm);
  EXPECT_EQ(findings.all.gouge_mm, result.findings.all.gouge_mm);
  ASSERT_EQ(findings.features.size(), 1u);
  EXPECT_NEAR(findings.features[0].figures.feed_mm, result.findings.features[0].figures.feed_mm, 1e-9);
  EXPECT_EQ(findings.features[0].layers.size(), 2u);
}

TEST(VerifyPrograms, LabelsThatLieChangeNoVerdict) {
  const PlanResult result = planned(4);
  Toolpath lying = result.toolpath;
  for (Section& section : lying.sections) {
    section.label = "SOMETHING ELSE";
    section.workingstep = 17;
  }
  EXPECT_TRUE(verify::verify_program(result.part, lying, {}).all.clean);
}

/// A section that calls itself the work of another workingstep is held to the stepdown of the place where it cuts.
TEST(VerifyPrograms, LabelsDoNotChooseTheStepdown) {
  const PlanResult result = planned(4);
  Part part = result.part;
  Workingstep deep = part.workplan.front();
  deep.name = "DEEP";
  deep.operation.stepdown = 50;
  deep.feature = static_cast<int>(part.features.size());
  Feature elsewhere = part.features.front();
  elsewhere.target = {Region::from_valid_loops(
      loop_from_points(std::vector<Vec2>{{500, 500}, {520, 500}, {520, 520}, {500, 520}}), {})};
  part.features.push_back(elsewhere);
  part.workplan.front().operation.stepdown = 1;
  part.workplan.push_back(deep);
  Toolpath lying = result.toolpath;
  for (Section& section : lying.sections) {
    section.label = "DEEP";
    section.workingstep = 1;
  }
  EXPECT_TRUE(has(verify::verify_program(part, lying, {}), FaultKind::kTooDeep));
}

TEST(VerifyPrograms, ALevelLeftOutOfTheTextIsFound) {
  const PlanResult result = planned(4);
  std::vector<std::string> lines = lines_of(result.program);
  const auto is_level = [](const std::string& line) { return line.find("Z-2") != std::string::npos; };
  const auto from = std::find_if(lines.begin(), lines.end(), is_level);
  const auto to = std::find_if(from, lines.end(),
                               [](const std::string& line) { return line.find("Z-4") != std::string::npos; });
  ASSERT_TRUE(from != lines.end() && to != lines.end());
  // The whole first level is run in the air: its depth word is replaced.
  for (auto line = from; line != to; ++line) *line = std::regex_replace(*line, std::regex("Z-2"), "Z0.5");
  const Findings findings = checked(result.part, joined(lines));
  EXPECT_TRUE(has(findings, FaultKind::kTooDeep));
  EXPECT_NEAR(findings.all.max_axial_mm, 4, 1e-6);
}

/// What plain search says of a program at one depth: sampled to 0.02 mm along the moves, 0.1 mm over the
/// plan.
class SlowJudge {
 public:
  explicit SlowJudge(const Region& region) : region_(region) {
    constexpr double step = 0.1;
    std::vector<Vec2> legal;
    for (double x = step / 2; x < 24; x += step) {
      for (double y = step / 2; y < 16; y += step) {
        if (!region.contains({x, y})) continue;
        points_.push_back({x, y});
        if (region.boundary_distance({x, y}) >= kRadius) legal.push_back({x, y});
      }
    }
    std::erase_if(points_, [&](Vec2 p) {
      if (region_.boundary_distance(p) >= kRadius) return false;
      return std::none_of(legal.begin(), legal.end(),
                          [&](Vec2 c) { return norm_squared(c - p) <= kRadius * kRadius; });
    });
  }

  /// Greatest depth of a cut into the walls while the tip is below the top.
  double gouge(const Toolpath& toolpath) const {
    double worst = 0;
    each_cut(toolpath, true, [&](const Move& move) {
      const int n = move.is_vertical() ? 0 : static_cast<int>(std::ceil(move.path.length() / 0.02));
      for (int i = 0; i <= n; ++i) {
        const Vec2 p = n == 0 ? move.path.from : move.path.at(static_cast<double>(i) / n);
        const double apart = region_.boundary_distance(p);
        worst = std::max(worst, region_.contains(p) ? kRadius - apart : kRadius + apart);
      }
    });
    return worst;
  }

  struct Left {
    double thickness =
        0;             ///< mm; how far a point within reach of a legal grid point lies outside what was cut
    double width = 0;  ///< mm; of the widest disc within the region that nothing was cut of
  };
  Left left(const Toolpath& toolpath, double z) const {
    std::vector<const Move*> cuts;
    each_cut(toolpath, false, [&](const Move& move) {
      if (std::max(move.z_from, move.z_to) <= z + 1e-6 || (move.is_vertical() && move.z_to <= z + 1e-6))
        cuts.push_back(&move);
    });
    Left worst;
    for (const Vec2 p : points_) {
      double excess = 1e9;
      for (const Move* move : cuts) {
        excess = std::min(excess, distance(move->path, p) - kRadius);
        if (excess <= 0) break;
      }
      worst.thickness = std::max(worst.thickness, excess);
      worst.width = std::max(worst.width, 2 * std::min(excess, region_.boundary_distance(p)));
    }
    return worst;
  }

 private:
  template <typename Visit>
  static void each_cut(const Toolpath& toolpath, bool rapids, Visit visit) {
    for (const Section& section : toolpath.sections) {
      for (const Move& move : section.moves) {
        if (std::min(move.z_from, move.z_to) < -1e-3 && (rapids || !is_rapid(move.kind))) visit(move);
      }
    }
  }

  const Region& region_;
  std::vector<Vec2> points_;  ///< of the target, within reach
};

/// Changes one coordinate of one block below the heading; empty when that block has none.
std::string spoilt(const std::string& program, Random& random) {
  std::vector<std::string> lines = lines_of(program);
  // Every other time a block of the ring along the wall.
  const std::regex block(random.below(2) == 0 ? "^(G[0123] )?[XY]-?[0-9]" : "^(G1 )?(X2|X22|Y2|Y14)( |$)");
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (std::regex_search(lines[i], block)) candidates.push_back(i);
  }
  if (candidates.empty()) return "";
  std::string& line = lines[candidates[random.below(candidates.size())]];
  std::smatch match;
  if (!std::regex_search(line, match, std::regex("([XY])(-?[0-9.]+)"))) return "";
  const double size = std::pow(10.0, random.between(-2, 0.6)) * (random.below(2) == 0 ? 1 : -1);
  const double value = std::stod(match[2].str()) + size;
  line = match.prefix().str() + match[1].str() + trimmed(value, 4) + match.suffix().str();
  return joined(lines);
}

// What correct means: on programs with one wrong coordinate the exact check finds whatever the slow one
// finds, and blames nothing that the slow one, blurred by its own step, holds innocent. Gouges are sampled to
// 0.02 mm along a move, which hides up to 0.1 um beside a wall; what is left is seen on a grid of 0.1 mm,
// legal centres too.
TEST(VerifyPrograms, SpoiltProgramsAreCheckedAsBySampling) {
  const PlanResult result = planned(2);
  ASSERT_TRUE(result.findings.all.clean);
  const Region& region = result.part.features[0].target[0];
  const SlowJudge slow(region);
  ASSERT_LE(slow.gouge(result.toolpath), 0.001);
  ASSERT_LE(slow.left(result.toolpath, -2).thickness, 0.01);
  Random random(4);
  int gouged = 0, left = 0, clean = 0, refused = 0;
  for (int round = 0; round < 120; ++round) {
    const std::string text = spoilt(result.program, random);
    Toolpath toolpath;
    try {
      toolpath = read::gcode::read_gcode(text, "spoilt.ngc").toolpath;
    } catch (const InputError&) {
      ++refused;  // an arc whose ends no longer fit its centre
      continue;
    }
    const Findings findings = verify::verify_program(result.part, toolpath, {});
    const double gouge = slow.gouge(toolpath);
    const auto [uncut, width] = slow.left(toolpath, -2);
    gouged += gouge > 0.002;
    left += uncut > 0.02;
    clean += findings.all.clean;
    if (gouge > 0.002) {
      EXPECT_TRUE(has(findings, FaultKind::kGouge)) << "round " << round << ": " << gouge;
    }
    if (gouge < 0.0008) {
      EXPECT_FALSE(has(findings, FaultKind::kGouge)) << "round " << round << ": " << gouge;
    }
    if (gouge > 0.002 && gouge < kRadius) {
      EXPECT_NEAR(findings.all.gouge_mm, gouge, 0.001) << "round " << round;
    }
    if (uncut > 0.02) {
      EXPECT_TRUE(has(findings, FaultKind::kUncut)) << "round " << round << ": " << uncut;
    }
    EXPECT_GE(findings.all.uncut_thickness_mm, uncut - 1e-9) << "round " << round;
    EXPECT_LE(findings.all.uncut_thickness_mm, 1.06 * (width + 0.2)) << "round " << round;
  }
  EXPECT_GT(gouged, 10);
  EXPECT_GT(left, 10);
  EXPECT_GT(clean, 10);
  EXPECT_LT(refused, 50);
}

/// Replaces the first line of a program that matches, and checks what that makes of it.
Findings with_line(const PlanResult& result, const std::string& pattern, const std::string& line) {
  auto lines = lines_of(result.program);
  const auto found = std::find_if(lines.begin(), lines.end(), [&](const std::string& text) {
    return std::regex_search(text, std::regex(pattern));
  });
  EXPECT_NE(found, lines.end()) << pattern;
  *found = line;
  return checked(result.part, joined(lines));
}

/// A program that cannot be read is not called clean either.
bool called_clean(const PlanResult& result, const std::string& pattern, const std::string& line) {
  try {
    return with_line(result, pattern, line).all.clean;
  } catch (const InputError&) {
    return false;
  }
}

TEST(VerifyPrograms, UnitsPlanesAndModesThatAreNotMeant) {
  const PlanResult result = planned(4);
  ASSERT_TRUE(result.findings.all.clean);
  EXPECT_TRUE(called_clean(result, "^G21", "G21"));
  EXPECT_FALSE(called_clean(result, "^G21", "G20"));  // numbers in mm, read as inches
  EXPECT_TRUE(called_clean(result, "^G17 ", "G17 G40 G49 G54 G80 G90 G91.1 G94"));
  EXPECT_FALSE(called_clean(result, "^G17 ", "G17 G40 G49 G54 G80 G91 G91.1 G94"));  // incremental
  EXPECT_FALSE(called_clean(result, "^G17 ", "G17 G40 G49 G54 G80 G90 G90.1 G94"));  // centres absolute
  EXPECT_FALSE(called_clean(result, "^G17 ", "G18 G40 G49 G54 G80 G90 G91.1 G94"));  // arcs upright
}

}  // namespace
}  // namespace clearcut
