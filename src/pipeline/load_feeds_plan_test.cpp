// Feeds that follow the load: checked from the program's text by a raster that knows nothing of how engagement is computed elsewhere.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "pipeline/program_feeds.h"
#include "pipeline/test_drawings.h"
#include "read/gcode/words/lines.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

/// mm; side of a cell, and greatest distance between places on the path.
constexpr double kCell = 0.02, kStep = 0.1;

/// The material of one layer as cells, true where it stands; x and y from 0 to `size`, mm.
class Cells {
 public:
  explicit Cells(double size)
      : count_(static_cast<int>(size / kCell)), stands_(static_cast<std::size_t>(count_) * count_, 1) {}

  bool stands(Vec2 p) const {
    const int x = place(p.x), y = place(p.y);
    return x >= 0 && y >= 0 && x < count_ && y < count_ && stands_[index(x, y)] != 0;
  }
  /// Returns the area that goes, mm2.
  double take(Vec2 center, double radius) {
    std::size_t taken = 0;
    const int low = std::max(0, place(center.y - radius)),
              high = std::min(count_ - 1, place(center.y + radius));
    for (int y = low; y <= high; ++y) {
      const double dy = (y + 0.5) * kCell - center.y, square = radius * radius - dy * dy;
      if (square <= 0) continue;
      const double half = std::sqrt(square);
      // Of cells whose middle is within the circle.
      const int from = std::max(0, place(center.x - half + kCell / 2));
      const int to = std::min(count_ - 1, place(center.x + half - kCell / 2));
      for (int x = from; x <= to; ++x) {
        taken += stands_[index(x, y)];
        stands_[index(x, y)] = 0;
      }
    }
    return static_cast<double>(taken) * kCell * kCell;
  }

 private:
  static int place(double v) { return static_cast<int>(std::floor(v / kCell)); }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * count_ + x; }

  int count_;
  std::vector<unsigned char> stands_;
};

struct Loads {
  double chip = 0;     ///< mm/min: greatest advance of the circle into what stands
  double removal = 0;  ///< mm2/min
};

/// The greatest loads of all level feed moves. A chip is seen where, two cells within the circle, stands what it did not reach one step
/// before; advances of less than half of the step are not.
Loads greatest_loads(const Toolpath& toolpath, double radius, double size) {
  constexpr int kPoints = 720;
  Cells cells(size);
  Loads most;
  for (const Section& section : toolpath.sections) {
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind) || move.is_vertical()) continue;
      const double feed = move.feed.mm_per_min();
      const int steps = std::max(1, static_cast<int>(std::ceil(move.path.length() / kStep)));
      const double step = move.path.length() / steps;
      for (int i = 1; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const Vec2 center = move.path.at(t), along = move.path.tangent_at(t);
        const bool level = move.z_from == move.z_to && step > 0.06;
        for (int k = 0; level && k < kPoints; ++k) {
          const Vec2 out = direction_of(2 * kPi * k / kPoints);
          const double forward = dot(out, along);
          if (feed * forward <= most.chip || !cells.stands(center + out * (radius - 2 * kCell))) continue;
          most.chip = feed * forward;
        }
        const double taken = cells.take(center, radius);
        if (level) most.removal = std::max(most.removal, feed * taken / step);
      }
    }
  }
  return most;
}

Part small_pocket() {
  return drawn(outline("POCKET_D2", {{{1, 1}}, {{29, 1}}, {{29, 17}, 0.5}, {{16, 27}}, {{1, 20}}}));
}

PlanOptions adaptive(std::optional<FeedBy> by) {
  PlanOptions options = with({"endmill:6"});
  options.strategy = "adaptive";
  options.engagement_deg = 60;
  options.entry = EntryKind::kHelix;
  options.shop.feed_by = by;
  return options;
}

/// By how much the raster may say more: cells at the rim are whole or not there.
constexpr double kOfRaster = 1.06;

TEST(LoadFeeds, NoMoveIsAboveTheReferenceByARaster) {
  const PlanResult plain = plan_part(small_pocket(), adaptive({}));
  const PlanResult chip = plan_part(small_pocket(), adaptive(FeedBy::kChip));
  const PlanResult removal = plan_part(small_pocket(), adaptive(FeedBy::kRemoval));
  for (const PlanResult* one : {&plain, &chip, &removal})
    EXPECT_TRUE(one->findings.faults.empty()) << faults_of(one->findings);
  EXPECT_LE(greatest_loads(chip.toolpath, 3, 30).chip, 1000 * kOfRaster);
  EXPECT_LE(greatest_loads(removal.toolpath, 3, 30).removal, 3000 * kOfRaster);
  EXPECT_LE(chip.findings.all.time_s, 0.97 * plain.findings.all.time_s);
  EXPECT_LE(removal.findings.all.time_s, 0.75 * plain.findings.all.time_s);
  EXPECT_FALSE(plain.findings.all.reference_load);
  ASSERT_TRUE(chip.findings.all.reference_load);
  EXPECT_LE(chip.findings.all.reference_load->share, 1.005);
  EXPECT_GT(chip.findings.all.reference_load->share, 0.95);
}

/// Coarse digits move paths by micrometres, which makes thin chips thicker.
TEST(LoadFeeds, NoMoveIsAboveTheReferenceWhereDigitsAreCoarse) {
  for (const bool inch : {false, true}) {
    PlanOptions options = with({"endmill:1"});
    options.strategy = "contour";
    options.shop.feed_by = FeedBy::kChip;
    options.shop.material = "steel";
    options.post.dialect = "siemens";
    options.post.inch = inch;
    const Part part =
        drawn(outline("POCKET_D1", {{{0.31, 0.17}}, {{9.7, 2.3}, 0.3}, {{8.1, 9.9}}, {{1.3, 7.7}, 0.2}}));
    const PlanResult result = plan_part(part, options);
    EXPECT_EQ(faults_of(result.findings), "") << inch;
  }
}

TEST(LoadFeeds, TheCapHoldsEverywhere) {
  PlanOptions options = adaptive(FeedBy::kRemoval);
  options.shop.feed_cap = MmPerMin::of(1300);
  const PlanResult result = plan_part(small_pocket(), options);
  EXPECT_TRUE(result.findings.faults.empty()) << faults_of(result.findings);
  double fastest = 0;
  for (const Section& section : result.toolpath.sections)
    for (const Move& move : section.moves)
      if (move.feed.mm_per_min() < 5000) fastest = std::max(fastest, move.feed.mm_per_min());  // ways back
  EXPECT_EQ(fastest, 1300);
}

TEST(LoadFeeds, AProgramThatIsFasterIsAtFaultOnce) {
  const PlanResult plain = plan_part(small_pocket(), adaptive({}));
  PlanOptions options = with({"endmill:6"});
  options.shop.feed_by = FeedBy::kRemoval;
  options.shop.reference_feed = MmPerMin::of(400);
  const CheckResult slow = check_program(small_pocket(), plain.program, "p.ngc", options);
  const auto count = std::count_if(slow.findings.faults.begin(), slow.findings.faults.end(),
                                   [](const Fault& one) { return one.kind == FaultKind::kAboveReference; });
  EXPECT_GE(count, 1);
  EXPECT_LE(count, 2) << "of the removal rate, and of the cap\n" << faults_of(slow.findings);
  EXPECT_THAT(faults_of(slow.findings), HasSubstr("of the removal rate of the reference"));
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string without_feed(const std::string& line) {
  const auto word = read::gcode::feed_word_in(line);
  if (!word) return line;
  std::size_t from = word->begin - 1;
  while (from > 0 && line[from - 1] == ' ') --from;
  return line.substr(0, from) + line.substr(word->end);
}

/// Line ends stay, too.
TEST(ProgramFeeds, ChangeFWordsAlone) {
  const std::string slots =
      "G0 X-10 Y0 Z5 S8000 M3\nZ-2\nG1 X40 F600 (slot)\nY2\nX-10\nG0 Z5\nX-10 Y20\nZ-2\nG1 X40\nG0 Z5\nM2";
  for (const std::string& begin :
       {std::string("G21 G90 G17 T1 M6\n"), std::string("G21 G90 G17 T1 M6 ( F1 )\r\n")}) {
    const std::string program = begin + slots;
    PlanOptions options = with({"endmill:6"});
    options.shop.feed_by = FeedBy::kRemoval;
    ProgramQuestion question;
    question.stock = Stock{{{0, -20}, {30, 40}}, -10, 0};
    question.dialect = Dialect::kLinuxCnc;
    const ProgramFeeds feeds = feeds_of_program(question, program, "p.ngc", options);
    const auto was = lines_of(program), is = lines_of(feeds.program);
    ASSERT_EQ(was.size(), is.size());
    for (std::size_t i = 0; i < was.size(); ++i) EXPECT_EQ(without_feed(was[i]), without_feed(is[i]));
    // A slot removes twice what half the cutter does; the way back at 2 mm beside it takes 2 of 3 mm.
    EXPECT_THAT(feeds.program, HasSubstr("G1 X40 F295 (slot)"));
    EXPECT_THAT(feeds.program, HasSubstr("X-10 F886"));
    EXPECT_EQ(feeds.reference_feeds.at(1), MmPerMin::of(600));
    EXPECT_TRUE(feeds.after.findings.faults.empty()) << faults_of(feeds.after.findings);
    EXPECT_FALSE(has(feeds.before.findings, FaultKind::kAboveReference));
  }
}

TEST(ProgramFeeds, NeedARuleAndGCode) {
  const std::string program = "G21 G90 T1 M6\nG0 X0 Y0 Z5 S8000 M3\nG1 Z-1 F200\nX30 F600\nM2\n";
  ProgramQuestion question;
  question.stock = Stock{{{0, -20}, {30, 40}}, -10, 0};
  EXPECT_THROW(feeds_of_program(question, program, "p.ngc", with({"endmill:6"})), InputError);
  PlanOptions options = with({"endmill:6"});
  options.shop.feed_by = FeedBy::kChip;
  const std::string klartext =
      "BEGIN PGM A MM\n1 TOOL CALL 1 Z S8000\n2 L X+0 Y+0 Z+5 FMAX M3\n3 L Z-1 F200\n4 L X+30 F600\n5 "
      "M2\nEND PGM A MM\n";
  EXPECT_THROW(feeds_of_program(question, klartext, "p.h", options), InputError);
}

}  // namespace
}  // namespace clearcut::pipeline
