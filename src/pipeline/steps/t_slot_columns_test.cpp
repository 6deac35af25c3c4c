// T-slots against columns of material: what stands over a place is a list of intervals of height, so that material may stand over
// air. It shares nothing with the planner and the verifier but the reader of programs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "base/text.h"
#include "pipeline/check.h"
#include "pipeline/run.h"
#include "pipeline/test_drawings.h"

namespace clearcut::pipeline {
namespace {

constexpr double kTop = 0, kBottom = -30, kAbove = 100;
/// mm. Columns nearer than this to where something changes are not asked; steps along sloping moves are as long.
constexpr double kNear = 0.05;
constexpr double kChord = 0.25;  // mm, of arcs
constexpr double kApart = 1.13;  // mm between columns

struct Cutters {
  double mill = 0, disc = 0, height = 0, neck = 0;  // diameters, and the disc's height
};

struct Scene {
  Cutters cutters;
  double depth = 0;
  std::vector<Vec2> line;
  double hole = 0;  // radius of a hole about its beginning; 0: it begins at the side of the plate
};

double distance_to_line(Vec2 p, const std::vector<Vec2>& line) {
  double least = distance(p, line.front());
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 way = line[i + 1] - line[i];
    const double t = std::clamp(dot(p - line[i], way) / dot(way, way), 0.0, 1.0);
    least = std::min(least, distance(p, line[i] + way * t));
  }
  return least;
}

class Column {
 public:
  explicit Column(Vec2 at) : at_(at) {}
  Vec2 at() const { return at_; }
  const std::vector<std::pair<double, double>>& stands() const { return stands_; }

  bool meets(double low, double high) const {
    return std::any_of(stands_.begin(), stands_.end(),
                       [&](const auto& one) { return one.first < high - 1e-6 && one.second > low + 1e-6; });
  }
  void remove(double low, double high) {
    std::vector<std::pair<double, double>> rest;
    for (const auto& [from, to] : stands_) {
      if (std::min(to, low) > from + 1e-9) rest.emplace_back(from, std::min(to, low));
      if (std::max(from, high) < to - 1e-9) rest.emplace_back(std::max(from, high), to);
    }
    stands_ = std::move(rest);
  }

 private:
  Vec2 at_;
  std::vector<std::pair<double, double>> stands_{{kBottom, kTop}};
};

/// What a program makes of a plate of 100 x 60 mm, and whether something but edges touched material on the way.
class Plate {
 public:
  Plate() {
    for (double x = 0.31; x < 100; x += kApart)
      for (double y = 0.17; y < 60; y += kApart) columns_.emplace_back(Vec2{x, y});
  }

  void run(const Toolpath& toolpath, const Cutters& cutters) {
    for (const Section& section : toolpath.sections) {
      const bool disc = section.tool_number == 2;
      for (const Move& move : section.moves) run(move, disc, cutters);
    }
  }
  const std::vector<Column>& columns() const { return columns_; }
  bool was_touched() const { return touched_; }

 private:
  void run(const Move& move, bool disc, const Cutters& cutters) {
    const bool slopes = !move.is_vertical() && move.z_from != move.z_to;
    const double piece = slopes ? kNear : move.path.is_arc() ? kChord : kAbove;
    const int steps = 1 + static_cast<int>(move.path.length() / piece);
    for (int i = 0; i < steps; ++i) {
      const double from = static_cast<double>(i) / steps, to = (i + 1.0) / steps;
      const double z_from = move.z_from + (move.z_to - move.z_from) * from;
      const double z_to = move.z_from + (move.z_to - move.z_from) * to;
      const std::vector<Vec2> way = move.is_vertical()
                                        ? std::vector<Vec2>{move.path.from}
                                        : std::vector<Vec2>{move.path.at(from), move.path.at(to)};
      sweep(way, std::min(z_from, z_to), std::max(z_from, z_to), is_rapid(move.kind), disc, cutters);
    }
  }

  void sweep(const std::vector<Vec2>& way, double low, double high, bool rapid, bool disc,
             const Cutters& cutters) {
    if (low >= kTop) return;
    const double radius = (disc ? cutters.disc : cutters.mill) / 2;
    const double top = disc ? high + cutters.height : kAbove;
    for (Column& column : columns_) {
      const double d = distance_to_line(column.at(), way);
      if (d > radius) continue;
      touched_ = touched_ || (rapid && d < radius - kNear && column.meets(low, top)) ||
                 (disc && d < cutters.neck / 2 - kNear && column.meets(low + cutters.height, kAbove));
      column.remove(low, top);
    }
  }

  std::vector<Column> columns_;
  bool touched_ = false;
};

/// Beyond the sides of the plate a line goes on as it comes.
std::vector<Vec2> drawn_on(std::vector<Vec2> line) {
  const std::size_t last = line.size() - 1;
  if (line[0].x <= 0) line[0] = line[0] - (line[1] - line[0]);
  if (line[last].x >= 100) line[last] = line[last] + (line[last] - line[last - 1]);
  return line;
}

/// mm; how far the heights of a column are from those that the part asks for; 0 near its walls.
double error_at(const Column& column, const Scene& scene) {
  const double d = distance_to_line(column.at(), drawn_on(scene.line));
  const double from_begin = distance(column.at(), scene.line.front());
  for (const double wall : {scene.cutters.mill / 2, scene.cutters.disc / 2})
    if (std::abs(d - wall) < 2 * kNear || std::abs(from_begin - scene.hole) < 2 * kNear) return 0;
  Column asked(column.at());
  if (d < scene.cutters.mill / 2 || from_begin < scene.hole) asked.remove(-scene.depth, kTop);
  if (d < scene.cutters.disc / 2) asked.remove(-scene.depth, scene.cutters.height - scene.depth);
  if (asked.stands().size() != column.stands().size()) return 1;
  double error = 0;
  for (std::size_t i = 0; i < asked.stands().size(); ++i) {
    error = std::max({error, std::abs(asked.stands()[i].first - column.stands()[i].first),
                      std::abs(asked.stands()[i].second - column.stands()[i].second)});
  }
  return error;
}

double greatest_error(const Plate& plate, const Scene& scene) {
  double error = 0;
  for (const Column& column : plate.columns()) error = std::max(error, error_at(column, scene));
  return error;
}

double tenths(double value) {
  return std::round(value * 10) / 10;
}

Scene scene_of(Random& random) {
  Scene scene;
  scene.cutters.neck = tenths(random.between(4, 9));
  scene.cutters.mill = tenths(scene.cutters.neck + random.between(0.3, 2));
  scene.cutters.disc = tenths(scene.cutters.mill + random.between(2, 8));
  scene.cutters.height = tenths(random.between(2, 7));
  scene.depth = tenths(scene.cutters.height + random.between(1, 8));
  scene.line = {{0, tenths(random.between(25, 35))},
                {tenths(random.between(35, 60)), tenths(random.between(22, 38))}};
  if (random.below(2) == 0) scene.line.push_back({100, tenths(random.between(25, 35))});
  if (random.below(3) == 0) {
    scene.line.front().x = 20;
    scene.hole = tenths(scene.cutters.disc / 2 + random.between(0.2, 3));
  }
  return scene;
}

Part part_of(const Scene& scene) {
  std::string text = box("STOCK_D30", 0, 0, 100, 60);
  if (scene.hole > 0) text += circle("POCKET_D" + trimmed(scene.depth, 1), scene.line.front(), scene.hole);
  for (std::size_t i = 0; i + 1 < scene.line.size(); ++i) {
    const Vec2 from = scene.line[i], to = scene.line[i + 1];
    text += "0\nLINE\n8\nTSLOT_D" + trimmed(scene.depth, 1) + "\n10\n" + trimmed(from.x, 3) + "\n20\n" +
            trimmed(from.y, 3) + "\n11\n" + trimmed(to.x, 3) + "\n21\n" + trimmed(to.y, 3) + "\n";
  }
  return drawn(text);
}

PlanOptions options_of(const Cutters& cutters) {
  return with({"endmill:" + trimmed(cutters.mill, 1) + ":length=40",
               "tslot:" + trimmed(cutters.disc, 1) + ":length=" + trimmed(cutters.height, 1) +
                   ":shank=" + trimmed(cutters.neck, 1)});
}

TEST(TSlotColumns, WhatIsPlannedAndCertifiedIsWhatColumnsShow) {
  Random random(11);
  for (int i = 0; i < 40; ++i) {
    const Scene scene = scene_of(random);
    const PlanResult result = plan_part(part_of(scene), options_of(scene.cutters));
    ASSERT_EQ(verdict_of(result.findings), Verdict::kClean) << i << "\n" << faults_of(result.findings);
    Plate plate;
    plate.run(result.toolpath, scene.cutters);
    EXPECT_FALSE(plate.was_touched()) << i << "\n" << result.program;
    EXPECT_LT(greatest_error(plate, scene), 1e-3) << i << "\n" << result.program;
  }
}

/// Where words of these letters begin that numbers follow.
std::vector<std::size_t> words_of(const std::string& text, const std::string& letters) {
  std::vector<std::size_t> words;
  for (std::size_t at = text.find("T1 M6"); at + 1 < text.size(); ++at) {
    const bool begins = text[at - 1] == '\n' || text[at - 1] == ' ';
    const bool number = std::isdigit(static_cast<unsigned char>(text[at + 1])) != 0 || text[at + 1] == '-';
    if (begins && number && letters.find(text[at]) != std::string::npos) words.push_back(at);
  }
  return words;
}

std::string with_another_place(std::string text, Random& random) {
  const std::vector<std::size_t> words = words_of(text, "XYZ");
  const std::size_t at = words[random.below(words.size())];
  const std::size_t end = text.find_first_not_of("-.0123456789", at + 1);
  const double value = std::stod(text.substr(at + 1, end - at - 1));
  const double by = random.between(0.3, 9) * (random.below(2) == 0 ? 1 : -1);
  return text.replace(at, end - at, text[at] + trimmed(value + by, 3));
}

/// Feeds become rapids, or the other way round, until the next such word.
std::string with_another_motion(std::string text, Random& random) {
  std::vector<std::size_t> words = words_of(text, "G");
  std::erase_if(words, [&](std::size_t at) {
    return text[at + 1] > '1' || std::isdigit(static_cast<unsigned char>(text[at + 2]));
  });
  char& motion = text[words[random.below(words.size())] + 1];
  motion = motion == '0' ? '1' : '0';
  return text;
}

std::string without_a_line(std::string text, Random& random) {
  const std::vector<std::size_t> words = words_of(text, "GXYZ");
  const std::size_t begin = text.rfind('\n', words[random.below(words.size())]) + 1;
  return text.erase(begin, text.find('\n', begin) + 1 - begin);
}

/// A good program with one thing changed.
std::string spoilt(const std::string& text, Random& random) {
  const std::uint64_t kind = random.below(4);
  if (kind == 0) return with_another_motion(text, random);
  return kind == 1 ? without_a_line(text, random) : with_another_place(text, random);
}

/// Nothing where no control takes the program.
std::optional<CheckResult> checked(const Part& part, const std::string& program, const PlanOptions& options) {
  try {
    return check_program(part, program, "spoilt.ngc", options);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

TEST(TSlotColumns, NoProgramIsCleanThatColumnsShowToBeWrong) {
  Random random(12);
  int wrong = 0, clean = 0;
  for (int i = 0; i < 200; ++i) {
    const Scene scene = scene_of(random);
    const auto options = options_of(scene.cutters);
    const Part part = part_of(scene);
    const std::string program = spoilt(plan_part(part, options).program, random);
    const std::optional<CheckResult> result = checked(part, program, options);
    if (!result) continue;
    Plate plate;
    plate.run(result->toolpath, scene.cutters);
    const bool is_wrong = plate.was_touched() || greatest_error(plate, scene) > 0.02;
    const Verdict verdict = verdict_of(result->findings);
    wrong += is_wrong ? 1 : 0;
    clean += verdict == Verdict::kClean ? 1 : 0;
    EXPECT_TRUE(!is_wrong || verdict == Verdict::kFaulty) << i << "\n" << program;
  }
  EXPECT_GT(wrong, 60);
  EXPECT_GT(clean, 10);
}

/// A step along the side of the plate, cleared by the disc alone: what it leaves standing over air is left, whatever lies under it.
TEST(TSlotColumns, InPartsWithoutUndercutsWhatStandsOverADiscIsNotTakenForCut) {
  Random random(13);
  const Cutters cutters{12, 20, 5, 10};
  int wrong = 0, clean = 0;
  for (int i = 0; i < 60; ++i) {
    const double depth = tenths(random.between(2, 14));
    const Part part =
        drawn(box("STOCK_D30", 0, 0, 100, 60) + box("POCKET_D" + trimmed(depth, 1), 0, 0, 100, 12));
    std::string body = "G21 G90 G17 G40 G49 G80 G94 G54 G61\nT2 M6\nG43 H2\nM3 S1500\nG0 Z10\n";
    for (const double z : {-2.5, -5.0, -7.5, -10.0, -12.0, -depth}) {
      const bool is_last = z == -depth;
      if (z < -depth || (!is_last && random.below(2) == 0)) continue;
      body += "G0 X-12 Y2\nG1 Z" + trimmed(z, 2) + " F300\nX112 F400\nG0 Z10\n";
    }
    const auto result = checked(part, body + "M5\nM30\n", options_of(cutters));
    ASSERT_TRUE(result);
    Plate plate;
    plate.run(result->toolpath, cutters);
    double error = plate.was_touched() ? 1 : 0;
    for (const Column& column : plate.columns()) {
      if (std::abs(column.at().y - 12) < 2 * kNear) continue;
      const double high = column.at().y < 12 ? -depth : kTop;
      const bool is_right =
          column.stands().size() == 1 && std::abs(column.stands().front().second - high) < 1e-6;
      error = std::max(error, is_right ? 0.0 : 1.0);
    }
    const Verdict verdict = verdict_of(result->findings);
    wrong += error > 0 ? 1 : 0;
    clean += verdict == Verdict::kClean ? 1 : 0;
    EXPECT_TRUE(error <= 0 || verdict == Verdict::kFaulty) << depth << "\n" << body;
    EXPECT_TRUE(depth > cutters.height || verdict == Verdict::kClean) << body << faults_of(result->findings);
  }
  EXPECT_GT(wrong, 10);
  EXPECT_GT(clean, 5);
}

}  // namespace
}  // namespace clearcut::pipeline
