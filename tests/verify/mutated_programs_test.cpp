// Programs of our own with one thing changed, checked by the verifier and by a raster that shares no code with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <regex>
#include <sstream>

#include "base/error.h"
#include "base/random.h"
#include "base/text.h"
#include "pipeline/check.h"
#include "pipeline/run.h"
#include "read/gcode/gcode.h"
#include "support/independent/raster_simulator.h"
#include "support/random/first_seed.h"

namespace clearcut {
namespace {

using Lines = std::vector<std::string>;

constexpr double kDiameter = 4, kFloor = -2, kCell = 0.2;
/// mm. What the raster is sure of: gouges are exact but for rounding, what is left is seen to half a cell's diagonal.
constexpr double kSureGouge = 0.002, kSureLeft = 0.02;

Loop circle(Vec2 center, double radius) {
  const Vec2 a = center + Vec2{radius, 0}, b = center - Vec2{radius, 0};
  return {Edge::arc(a, b, center, Turn::kCounterClockwise), Edge::arc(b, a, center, Turn::kCounterClockwise)};
}

std::vector<Region> outlines() {
  const auto polygon = [](const std::vector<Vec2>& corners, const std::vector<Loop>& islands = {}) {
    return Region::from_valid_loops(loop_from_points(corners), islands);
  };
  return {polygon({{0, 0}, {24, 0}, {24, 16}, {0, 16}}, {circle({16.5, 8}, 1.5)}),
          polygon({{0, 0}, {20, 0}, {20, 7}, {8, 9}, {8, 20}, {0, 20}}),
          polygon({{0, 0}, {22, 3}, {18, 14}, {9, 9}, {2, 15}}),
          Region::from_valid_loops(circle({10, 10}, 9), {circle({12, 9}, 2)})};
}

Part part_of(const Region& outline) {
  Part part;
  part.name = "mutated";
  Feature feature;
  feature.name = "POCKET";
  feature.target = feature.allowed = {outline};
  feature.floor_z = kFloor;
  part.features.push_back(feature);
  part.workplan.push_back({});
  return part;
}

Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

bool moves(const std::string& line) {
  return std::regex_search(line, std::regex("^(G[0123] )?[XYZ]-?[0-9.]+"));
}

/// Changes the number of one word by up to centimetres, down to micrometres.
void change_number(std::string& line, Random& random) {
  const std::regex word("([XYZIJ])(-?[0-9.]+)");
  const std::sregex_iterator begin(line.begin(), line.end(), word), end;
  const auto count = static_cast<std::uint64_t>(std::distance(begin, end));
  if (count == 0) return;
  const std::smatch match = *std::next(begin, static_cast<std::ptrdiff_t>(random.below(count)));
  double value = std::stod(match[2].str());
  switch (random.below(8)) {
    case 0:
      value = -value;
      break;
    case 1:
      value *= random.below(2) == 0 ? 10 : 0.1;
      break;
    default:
      value += std::pow(10.0, random.between(-3, 1)) * (random.below(2) == 0 ? 1 : -1);
  }
  line = line.substr(0, static_cast<std::size_t>(match.position())) + match[1].str() + trimmed(value, 4) +
         line.substr(static_cast<std::size_t>(match.position() + match.length()));
}

/// Another motion word; a line without one gets one.
void change_motion(std::string& line, Random& random) {
  const std::string word = "G" + std::to_string(random.below(4)) + " ";
  line = std::regex_search(line, std::regex("^G[0123] ")) ? word + line.substr(3) : word + line;
}

/// One mutation of the block in a program: a number, a motion word, a block left out, twice, exchanged with the next, or split.
Lines mutated(Lines lines, Random& random) {
  std::vector<std::size_t> blocks;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (moves(lines[i])) blocks.push_back(i);
  }
  const std::size_t i = blocks[random.below(blocks.size())];
  const auto at = lines.begin() + static_cast<std::ptrdiff_t>(i);
  switch (random.below(8)) {
    case 0:
      lines.erase(at);
      break;
    case 1:
      lines.insert(at, *at);
      break;
    case 2:
      if (i + 1 < lines.size()) std::swap(lines[i], lines[i + 1]);
      break;
    case 3:
      change_motion(lines[i], random);
      break;
    case 4:
      // A run of blocks is lost, as by a bad copy.
      lines.erase(at, std::min(lines.end(), at + 2 + static_cast<std::ptrdiff_t>(random.below(6))));
      break;
    default:
      change_number(lines[i], random);
  }
  return lines;
}

struct Tally {
  int wrong = 0, right = 0, refused = 0;
};

/// The raster's reason to call the program wrong; "" where it is not sure.
std::string surely_wrong(const Region& outline, const Toolpath& toolpath) {
  test_support::RasterJob job{{outline}, {outline}, kDiameter / 2, 0, 0, kFloor, kCell};
  std::vector<Move> all;
  for (const Section& section : toolpath.sections)
    all.insert(all.end(), section.moves.begin(), section.moves.end());
  // A floor that is off by less than may stay on it is none of the raster's business.
  double lowest = 0;
  for (const Move& move : all) lowest = std::min(lowest, move.z_to);
  if (std::abs(lowest - kFloor) < kSureLeft / 2) job.z = lowest;
  const test_support::RasterFindings found = test_support::simulate(job, all);
  if (found.gouge > kSureGouge) return "gouge of " + trimmed(found.gouge, 4) + " mm";
  if (found.uncut_cells > 0 && found.uncut_depth > kSureLeft)
    return trimmed(found.uncut_depth, 4) + " mm left";
  if (found.rapid_cells > 0) return "a rapid through material";
  return "";
}

void check(const Region& outline, const PlanResult& plan, const std::string& text, Tally& tally) {
  PlanOptions options;
  options.tools = plan.part.tools;
  options.accept = {"out-of-reach"};
  const auto dialect = Dialect::kLinuxCnc;
  CheckResult result;
  try {
    result = pipeline::check_program(plan.part, text, "mutated", options, dialect);
  } catch (const InputError&) {
    ++tally.refused;
    return;
  }
  const std::string wrong = surely_wrong(outline, result.toolpath);
  ++(wrong.empty() ? tally.right : tally.wrong);
  EXPECT_TRUE(wrong.empty() || verdict_of(result.findings) == Verdict::kFaulty)
      << wrong << ", called " << name_of(verdict_of(result.findings)) << "\n"
      << text;
}

/// How many mutations in all: CLEARCUT_MUTATIONS, else `usual`.
int mutation_count(int usual) {
  const char* set = std::getenv("CLEARCUT_MUTATIONS");
  return set ? std::atoi(set) : usual;
}

/// Whatever the raster calls wrong beyond its resolution is FAULTY. Others may be: the raster sees less.
TEST(MutatedPrograms, AreFaultyWhereARasterSaysSo) {
  const std::vector<Region> regions = outlines();
  const std::vector<std::string> strategies{"contour", "zigzag", "spiral", "adaptive"};
  const int each = mutation_count(320) / static_cast<int>(regions.size() * strategies.size());
  Random random(static_cast<std::uint64_t>(10 + test_support::first_seed()));
  Tally tally;
  for (const Region& region : regions) {
    for (const std::string& strategy : strategies) {
      PlanOptions options;
      options.tools = {resolve::parse_tool("endmill:4")};
      options.strategy = strategy;
      options.accept = {"out-of-reach"};  // the outlines' sharp corners
      const PlanResult plan = pipeline::plan_part(part_of(region), options);
      ASSERT_EQ(verdict_and_reasons(plan.findings), "CLEAN\n") << strategy;
      ASSERT_EQ(surely_wrong(region, plan.toolpath), "") << strategy;
      const Lines lines = lines_of(plan.program);
      for (int n = 0; n < each; ++n) check(region, plan, joined(mutated(lines, random)), tally);
    }
  }
  RecordProperty("wrong", tally.wrong);
  std::cout << tally.wrong << " surely wrong, " << tally.right << " not surely, " << tally.refused
            << " refused\n";
  EXPECT_GT(tally.wrong, 10 * each / 3);
}

}  // namespace
}  // namespace clearcut
