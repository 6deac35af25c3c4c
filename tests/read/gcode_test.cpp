// The corpus of programs: what loads, what is refused and why, and whether LinuxCNC's own interpreter would
// make the same motion of it.
#include "read/gcode/gcode.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "base/error.h"
#include "base/file.h"
#include "base/random.h"
#include "support/independent/rs274.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> corpus(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::directory_iterator(fs::path(CLEARCUT_SOURCE_DIR) / "tests/corpus/gcode" / folder)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Program load(const fs::path& file) {
  return read::gcode::read_gcode(read_file(file.string()), file.filename().string());
}

std::vector<Move> moves_of(const Toolpath& toolpath) {
  std::vector<Move> moves;
  for (const Section& section : toolpath.sections) {
    moves.insert(moves.end(), section.moves.begin(), section.moves.end());
  }
  return moves;
}

/// What every toolpath that was read promises: moves join exactly, arcs pass through their ends.
void expect_sound(const Toolpath& toolpath) {
  const std::vector<Move> moves = moves_of(toolpath);
  for (std::size_t k = 0; k < moves.size(); ++k) {
    const Move& move = moves[k];
    EXPECT_TRUE(std::isfinite(move.length())) << "line " << move.line;
    EXPECT_TRUE(!move.is_vertical() || move.z_from != move.z_to) << "line " << move.line;
    if (move.path.is_arc()) {
      EXPECT_NEAR(distance(move.path.from, move.path.center), distance(move.path.to, move.path.center), 1e-9);
    }
    if (k == 0) continue;
    EXPECT_EQ(moves[k - 1].path.to, move.path.from) << "line " << move.line;
    EXPECT_EQ(moves[k - 1].z_to, move.z_from) << "line " << move.line;
  }
}

TEST(GcodeCorpus, GoodProgramsLoad) {
  std::vector<fs::path> files = corpus("rs274");
  const std::vector<fs::path> others = corpus("other");
  files.insert(files.end(), others.begin(), others.end());
  ASSERT_GT(files.size(), 15U);
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.filename());
    const Program program = load(file);
    expect_sound(program.toolpath);
  }
}

TEST(GcodeCorpus, BadProgramsGiveTheMessageOfTheirFirstLine) {
  const std::vector<fs::path> files = corpus("bad");
  ASSERT_GT(files.size(), 20U);
  for (const fs::path& file : files) {
    const std::string text = read_file(file.string());
    const std::string wanted = text.substr(2, text.find('\n') - 2);
    try {
      load(file);
      ADD_FAILURE() << file.filename() << " was taken; wanted: " << wanted;
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), wanted);
    }
  }
}

/// Figures worked out by hand from the texts.
TEST(GcodeCorpus, OtherDialectsMeanWhatTheySay) {
  struct Row {
    const char* file;
    std::size_t sections;
    std::vector<int> tools;
    double cut_mm;  ///< all feed motion
    bool ended;
  };
  const std::vector<Row> rows{
      {"fanuc_tape.nc", 2, {3, 5}, 3 + 30 + kPi / 2 * 5 + 15 + 2 * 14, true},
      {"haas_probe_free.nc", 1, {1}, 25.4 * (1.125 + kPi + 0.5), true},
      {"grbl_router.nc", 2, {0, 2}, 6 + 50 + kPi / 2 * 10 + 50 + 7 + kPi * 20, true},
      {"marlin.gcode", 1, {0}, 6 + 20 + kPi / 2 * 10, true},
      {"mach.tap", 1, {1}, 25.4 * (0.3 + kPi / 2 + 0.5 + 1), true},
      {"vertical_lead.nc", 1, {4}, 1 + kPi / 2 + 19 + kPi / 2 * 5 + kPi / 2, true},
      {"klartext.H", 1, {3}, std::hypot(4 * kPi * 5, 4) + 2 * kPi * 5 + 10 + kPi / 2 * 10 + 10, true},
      {"klartext_inch.H", 1, {1}, 25.4 * 3.1, true},
      {"klartext_holes.H", 2, {5, 6}, 3 * (6 * 9 + 5.4) + 13 + 9.36 + 13 + 2.36 + 2 * 20, true},
      {"no_motion.nc", 0, {}, 0, true},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.file);
    const Program program = load(fs::path(CLEARCUT_SOURCE_DIR) / "tests/corpus/gcode/other" / row.file);
    EXPECT_EQ(program.ended, row.ended);
    ASSERT_EQ(program.toolpath.sections.size(), row.sections);
    double cut = 0;
    for (std::size_t s = 0; s < row.sections; ++s) {
      EXPECT_EQ(program.toolpath.sections[s].tool_number, row.tools[s]);
      cut += feed_length(program.toolpath.sections[s]);
    }
    EXPECT_NEAR(cut, row.cut_mm, 2e-3);
  }
}

// ------------------------------------------------------------------------- beside LinuxCNC's own interpreter

std::string mutated(std::string text, Random& random) {
  constexpr std::string_view kPieces = "GMXYZIJRFTSPQLON0123456789.-+();% \n/#[*E";
  const std::uint64_t changes = 1 + random.below(3);
  for (std::uint64_t n = 0; n < changes && !text.empty(); ++n) {
    const std::size_t at = random.below(text.size());
    switch (random.below(4)) {
      case 0:
        text[at] = kPieces[random.below(kPieces.size())];
        break;
      case 1:
        text.insert(at, 1, kPieces[random.below(kPieces.size())]);
        break;
      case 2:
        text.erase(at, 1 + random.below(8));
        break;
      default:
        text.insert(at, text.substr(random.below(text.size()), random.below(20)));
    }
  }
  return text;
}

/// Damaged programs are refused with their place, or read as something sound; never anything else.
TEST(GcodeCorpus, DamagedProgramsAreRefusedOrSound) {
  Random random(2024);
  std::vector<std::string> texts;
  for (const char* folder : {"rs274", "other"}) {
    for (const fs::path& file : corpus(folder)) texts.push_back(read_file(file.string()));
  }
  int read = 0, refused = 0;
  for (int n = 0; n < 6000; ++n) {
    const std::string text = mutated(texts[random.below(texts.size())], random);
    try {
      expect_sound(read::gcode::read_gcode(text, "damaged").toolpath);
      ++read;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).rfind("damaged:", 0), 0U) << error.what();
      ++refused;
    }
    if (HasFailure()) FAIL() << text;
  }
  EXPECT_GT(read, 1000);
  EXPECT_GT(refused, 1000);
}

/// The canonical output has four decimals, in program units.
double printed_tolerance(const fs::path& file) {
  return file.filename() == "inch.ngc" ? 25.4 * 2e-4 : 2e-4;
}

TEST(GcodeCorpus, MovesAsLinuxCncDoes) {
  CLEARCUT_SKIP_WITHOUT_RS274();
  const std::vector<fs::path> files = corpus("rs274");
  ASSERT_GT(files.size(), 8U);
  for (const fs::path& file : files) {
    SCOPED_TRACE(file.filename());
    const test_support::CanonProgram canon = test_support::run_rs274(read_file(file.string()));
    ASSERT_TRUE(canon.accepted) << canon.message;
    const double tolerance = file.filename() == "spiral_ends.ngc" ? 3e-3 : printed_tolerance(file);
    test_support::expect_same_motion(canon, load(file).toolpath, tolerance);
  }
}

}  // namespace
}  // namespace clearcut
