// Words that set up a control: what each post writes, and how the reader takes it back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "base/error.h"
#include "post/post.h"
#include "read/gcode/gcode.h"
#include "support/controllers.h"
#include "support/independent/grbl.h"
#include "support/random/random_toolpaths.h"

namespace clearcut {
namespace {

using test_support::options_for;
using ::testing::HasSubstr;

/// One cut 5 mm long below z 0 in each section, 10 mm apart.
Toolpath cuts(const std::vector<Coolant>& coolants) {
  Toolpath path;
  double x = 0;
  for (const Coolant coolant : coolants) {
    Section section;
    section.label = "CUT";
    section.tool_number = 1;
    section.spindle_rpm = 5000;
    section.coolant = coolant;
    Move down{Edge::line({x, 0}, {x, 0}), 5, -1, MoveKind::kPlunge, MmPerMin::of(100)};
    Move along{Edge::line({x, 0}, {x + 5, 0}), -1, -1, MoveKind::kCut, MmPerMin::of(300)};
    Move up{Edge::line({x + 5, 0}, {x + 5, 0}), -1, 5, MoveKind::kRetract, MmPerMin::of(300)};
    section.moves = {down, along, up};
    path.sections.push_back(std::move(section));
    x += 10;
  }
  return path;
}

/// The blocks that are among `wanted`, without their Klartext numbers, joined by blanks.
std::string blocks_among(const std::string& program, const std::vector<std::string>& wanted) {
  std::istringstream lines(program);
  std::string found;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find_first_not_of("0123456789 ");
    if (first == std::string::npos) continue;
    line.erase(0, first);
    if (std::find(wanted.begin(), wanted.end(), line) == wanted.end()) continue;
    found += (found.empty() ? "" : " ") + line;
  }
  return found;
}

std::string coolant_of(const std::vector<Coolant>& coolants, const std::string& dialect) {
  return blocks_among(post::write_program(cuts(coolants), Part{}, options_for(dialect, false)),
                      {"M7", "M8", "M9", "M83", "M84"});
}

std::string conditions_of(const std::string& text, const std::string& dialect) {
  read::gcode::ReadControllerOptions reading;
  reading.dialect = read::gcode::dialect_named(dialect);
  std::string names;
  for (const Condition& one : read::gcode::read_gcode(text, "test", reading).conditions)
    names += (names.empty() ? "" : " ") + one.name;
  return names;
}

constexpr Coolant kOff = Coolant::kOff, kFlood = Coolant::kFlood, kMist = Coolant::kMist,
                  kBoth = Coolant::kBoth;

TEST(CoolantWords, LeadFromOneToTheNext) {
  for (const std::string& dialect : post::post_dialects()) {
    SCOPED_TRACE(dialect);
    EXPECT_EQ(coolant_of({kOff}, dialect), "");
    EXPECT_EQ(coolant_of({kFlood, kFlood}, dialect), "M8 M9");
    if (dialect == "haas") continue;
    EXPECT_EQ(coolant_of({kMist}, dialect), "M7 M9");
    EXPECT_EQ(coolant_of({kBoth}, dialect), "M8 M7 M9");
    EXPECT_EQ(coolant_of({kFlood, kBoth, kMist, kFlood}, dialect), "M8 M7 M9 M7 M9 M8 M9");
  }
  EXPECT_EQ(coolant_of({kMist}, "haas"), "M83 M84");
  EXPECT_EQ(coolant_of({kBoth}, "haas"), "M8 M83 M84 M9");
  EXPECT_EQ(coolant_of({kFlood, kBoth, kMist, kFlood}, "haas"), "M8 M83 M9 M84 M8 M9");
}

TEST(CoolantWords, AreReadBackInEveryDialect) {
  const std::vector<Coolant> coolants{kFlood, kBoth, kMist, kOff, kMist, kFlood, kOff, kBoth, kOff};
  for (const std::string& dialect : post::post_dialects()) {
    SCOPED_TRACE(dialect);
    const std::string text = post::write_program(cuts(coolants), Part{}, options_for(dialect, false));
    read::gcode::ReadControllerOptions reading;
    reading.dialect = read::gcode::dialect_named(dialect);
    reading.hand_tools = {1};
    std::vector<Coolant> got;
    for (const Section& section : read::gcode::read_gcode(text, "test", reading).toolpath.sections)
      if (feed_length(section) > 0) got.push_back(section.coolant);
    EXPECT_EQ(got, coolants);
  }
}

/// Flood asks for nothing; mist only where not every such control has it.
TEST(CoolantWords, ThatAControlNeedNotHaveAreConditions) {
  for (const test_support::Controller& one : test_support::controllers()) {
    const std::string dialect(one.name), condition(one.mist_condition);
    SCOPED_TRACE(dialect);
    const auto program = [&](Coolant coolant) {
      return post::write_program(cuts({coolant}), Part{}, options_for(dialect, false));
    };
    EXPECT_EQ(conditions_of(program(kFlood), dialect), "");
    EXPECT_EQ(conditions_of(program(kMist), dialect), condition);
    EXPECT_EQ(conditions_of(program(kBoth), dialect), condition);
  }
}

TEST(CoolantWords, GrblTakesMistWhereItWasBuiltWithIt) {
  const std::string text = post::write_program(cuts({kBoth}), Part{}, options_for("grbl", false));
  EXPECT_TRUE(test_support::grbl_faults(text, true).empty());
  const auto faults = test_support::grbl_faults(text);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].error, 20);
  EXPECT_EQ(faults[0].text, "M7");
}

/// What other programs say: through the tool is flood, Haas's shower is, too.
TEST(CoolantWords, OfOtherProgramsAreRead) {
  const auto coolant_as = [](const std::string& words, const std::string& dialect) {
    read::gcode::ReadControllerOptions reading;
    reading.dialect = read::gcode::dialect_named(dialect);
    const std::string text = "G21 G61 G17 G90 G0 X0. Y0. Z5.\n" + words + "\nG1 X5. F100.\nM30\n";
    return read::gcode::read_gcode(text, "test", reading).toolpath.sections.back().coolant;
  };
  EXPECT_EQ(coolant_as("M7 M8", "linuxcnc"), kBoth);
  EXPECT_EQ(coolant_as("M7\nM8\nM9", "linuxcnc"), kOff);
  EXPECT_EQ(coolant_as("M7", "haas"), kFlood);
  EXPECT_EQ(coolant_as("M88", "haas"), kFlood);
  EXPECT_EQ(coolant_as("M83\nM8\nM9", "haas"), kMist);
  EXPECT_EQ(coolant_as("M83\nM8\nM84", "haas"), kFlood);
  EXPECT_EQ(coolant_as("M83", "fanuc"), kOff);
}

// ------------------------------------------------------------------------------------- work offsets

std::string program_at(const std::string& offset, const std::string& dialect) {
  PostOptions options = options_for(dialect, false);
  options.work_offset = *work_offset_named(offset);
  return post::write_program(cuts({kOff}), Part{}, options);
}

std::string refusal_at(const std::string& offset, const std::string& dialect) {
  try {
    program_at(offset, dialect);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// As what it is read, besides what must hold.
std::vector<Section> sections_of(const std::string& text, const std::string& dialect) {
  read::gcode::ReadControllerOptions reading;
  reading.dialect = read::gcode::dialect_named(dialect);
  reading.hand_tools = {1};
  return read::gcode::read_gcode(text, "test", reading).toolpath.sections;
}

void expect_same_motion(const std::string& text, const std::string& other, const std::string& dialect) {
  const auto a = sections_of(text, dialect), b = sections_of(other, dialect);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t s = 0; s < a.size(); ++s) {
    ASSERT_EQ(a[s].moves.size(), b[s].moves.size());
    for (std::size_t m = 0; m < a[s].moves.size(); ++m) {
      EXPECT_EQ(a[s].moves[m].path.to, b[s].moves[m].path.to);
      EXPECT_EQ(a[s].moves[m].z_to, b[s].moves[m].z_to);
    }
  }
}

/// Every offset that a control has is written in its words and is one condition, as G55 is; all others are refused in one line.
TEST(WorkOffsets, AreThoseOfTheControl) {
  for (const test_support::Controller& one : test_support::controllers()) {
    const std::string dialect(one.name);
    for (const std::string_view word : test_support::all_work_offsets()) {
      const std::string offset(word);
      SCOPED_TRACE(dialect + " " + offset);
      const auto& has = one.work_offsets;
      const bool known = std::find(has.begin(), has.end(), word) != has.end();
      if (!known) {
        EXPECT_THAT(refusal_at(offset, dialect),
                    HasSubstr(dialect + " has no " + offset + ": " + std::string(one.work_offsets_said)));
        continue;
      }
      const std::string text = program_at(offset, dialect);
      const std::string blocks = "\n" + text;
      EXPECT_THAT(blocks, HasSubstr(offset.find(' ') == std::string::npos ? " " + offset + " "
                                                                          : "\n" + offset + "\n"));
      EXPECT_EQ(conditions_of(text, dialect), condition_of(*work_offset_named(offset)));
      expect_same_motion(text, program_at("G54", dialect), dialect);
      EXPECT_TRUE(dialect != "grbl" || test_support::grbl_faults(text).empty());
    }
  }
}

TEST(WorkOffsets, AreNamedInAnyCaseWithOrWithoutBlanks) {
  EXPECT_EQ(words_of(*work_offset_named("g54.1p12")), "G54.1 P12");
  EXPECT_EQ(words_of(*work_offset_named("G154 P 7")), "G154 P7");
  EXPECT_EQ(words_of(*work_offset_named("g15h12")), "G15 H12");
  for (const char* wrong : {"", "G53", "G60", "G59.4", "G54 P2", "G54.1", "G54.1 P0", "G54.1 P-1",
                            "G154 P1.5", "G504", "G600", "G505 P1", "G15", "G15 P1", "G15 H0"})
    EXPECT_FALSE(work_offset_named(wrong)) << wrong;
}

// --------------------------------------------------------------------------------------- end position

std::string program_to(const EndPosition& end, const std::string& dialect) {
  PostOptions options = options_for(dialect, false);
  options.end = end;
  return post::write_program(cuts({kOff, kOff}), Part{}, options);
}

const std::vector<std::string> kPlaceBlocks{
    "G91 G28 Z0", "G28 X0 Y0",         "G91 G28 Z0.",          "G28 X0. Y0.", "G90",
    "G30 P1",     "SUPA G0 Z0 D0",     "SUPA G0 X0 Y0 D0",     "G53 G0 Z0.",  "G53 G0 X0. Y0.",
    "M5",         "L Z+0 R0 FMAX M91", "L X+0 Y+0 R0 FMAX M91"};

/// What comes after the spindle has stopped for good, of those words.
std::string after_the_last_stop(const std::string& program) {
  const std::string found = blocks_among(program, kPlaceBlocks);
  return found.substr(found.rfind("M5") + 2);
}

TEST(EndPositions, HomeIsZFirstInTheWordsOfTheControl) {
  for (const test_support::Controller& one : test_support::controllers()) {
    const std::string dialect(one.name);
    SCOPED_TRACE(dialect);
    if (one.home.empty()) {
      EXPECT_THROW(program_to(*end_position_named("home"), dialect), InputError);
      continue;
    }
    const std::string text = program_to(*end_position_named("home"), dialect);
    EXPECT_EQ(after_the_last_stop(text), one.home);
    EXPECT_EQ(conditions_of(text, dialect), one.home_condition);
    EXPECT_TRUE(dialect != "grbl" || test_support::grbl_faults(text).empty());
  }
}

TEST(EndPositions, APlaceIsReachedAtTheSafeHeight) {
  for (const std::string& dialect : post::post_dialects()) {
    SCOPED_TRACE(dialect);
    const std::string text = program_to(*end_position_named("-20,30.5"), dialect);
    EXPECT_EQ(conditions_of(text, dialect), "");
    double highest = 0;
    const Move* last = nullptr;
    const auto sections = sections_of(text, dialect);
    for (const Section& section : sections) {
      for (const Move& move : section.moves) {
        if (!is_rapid(move.kind)) highest = std::max({highest, move.z_from, move.z_to});
        if (!move.is_vertical()) last = &move;
      }
    }
    ASSERT_NE(last, nullptr);
    EXPECT_TRUE(is_rapid(last->kind));
    EXPECT_EQ(last->path.to, (Vec2{-20, 30.5}));
    EXPECT_EQ(last->z_from, last->z_to);
    EXPECT_GE(last->z_to, highest);
    EXPECT_EQ(after_the_last_stop(text), after_the_last_stop(program_to({}, dialect)));
  }
}

TEST(EndPositions, NoneStaysOverTheLastCut) {
  for (const std::string& dialect : post::post_dialects()) {
    SCOPED_TRACE(dialect);
    const std::string text = program_to(*end_position_named("none"), dialect);
    EXPECT_EQ(after_the_last_stop(text), "");
    const Move last = sections_of(text, dialect).back().moves.back();
    EXPECT_EQ(last.path.to, (Vec2{15, 0}));
    EXPECT_GE(last.z_to, 5);
  }
}

TEST(EndPositions, ThatAreNoneAreRefused) {
  for (const char* wrong : {"", "there", "1", "1,", "1,2,3", "nan,0"})
    EXPECT_FALSE(end_position_named(wrong)) << wrong;
  EXPECT_EQ(name_of(*end_position_named("10,-20.5")), "10,-20.5");
  for (const std::string& dialect : post::post_dialects())
    EXPECT_THROW(program_to(*end_position_named("1e9,0"), dialect), InputError) << dialect;
}

}  // namespace
}  // namespace clearcut
