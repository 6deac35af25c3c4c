// Words that a shop asks for in its programs, and controls that have none of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <tuple>

#include "base/error.h"
#include "post/post.h"

namespace clearcut::post {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// One straight cut with each of two tools.
std::string program(const PostOptions& options, double feed = 300, double rpm = 8000) {
  Part part;
  Toolpath toolpath;
  for (const int number : {1, 2}) {
    Tool tool;
    tool.number = number;
    tool.diameter = 6;
    part.tools.push_back(tool);
    Section section;
    section.tool_number = number;
    section.spindle_rpm = rpm;
    section.moves = {
        {Edge::line({0, 0}, {0, 0}), 5, -1, MoveKind::kPlunge, MmPerMin::of(100), 0},
        {Edge::line({0, 0}, {10, 0}), -1, -1, MoveKind::kCut, MmPerMin::of(feed), 0},
        {Edge::line({10, 0}, {10, 0}), -1, 5, MoveKind::kRapid, {}, 0},
    };
    toolpath.sections.push_back(section);
  }
  return write_program(toolpath, part, options);
}

PostOptions post_for(const char* dialect) {
  PostOptions options;
  options.dialect = dialect;
  return options;
}

std::string refusal(const PostOptions& options, double feed = 300, double rpm = 8000) {
  try {
    program(options, feed, rpm);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ProgramWords, NumbersThatNoMachineTakesAreNamedForWhatTheyAre) {
  PostOptions options = post_for("grbl");
  EXPECT_THAT(refusal(options, 1e8), HasSubstr("a feed (mm/min) in operation"));
  EXPECT_THAT(refusal(options, 300, 1e8), HasSubstr("the spindle's speed (rpm) in operation"));
  options.spindle_wait = Seconds::of(3600);
  EXPECT_EQ(refusal(options), "");
  options.spindle_wait = Seconds::of(1e9);
  EXPECT_THAT(refusal(options), HasSubstr("--spindle-wait"));
}

TEST(ProgramWords, WorkOffsetStandsInTheSafeStart) {
  PostOptions options = post_for("linuxcnc");
  EXPECT_THAT(program(options), HasSubstr(" G54 "));
  options.work_offset = {570};
  EXPECT_THAT(program(options), HasSubstr(" G57 "));
  EXPECT_THAT(program(options), Not(HasSubstr("G54")));
}

TEST(ProgramWords, ProgramNumberIsTheOWord) {
  PostOptions options = post_for("fanuc");
  options.program_name = "bracket";
  EXPECT_THAT(program(options), HasSubstr("%\nO0001 (BRACKET)\n"));
  options.program_number = 1234;
  EXPECT_THAT(program(options), HasSubstr("%\nO1234 (BRACKET)\n"));
  options.program_name = std::string(100, 'a');
  EXPECT_THAT(program(options), HasSubstr("%\nO1234\n(AAA")) << "too long for the block";
  options.program_number = 12345;
  EXPECT_THAT(refusal(options), HasSubstr("--program-number"));
  options.dialect = "haas";
  EXPECT_THAT(program(options), HasSubstr("%\nO12345\n"));
}

TEST(ProgramWords, KlartextNamesKeepTheirWordsApart) {
  PostOptions options = post_for("heidenhain");
  options.program_name = "two sided: set-up 1";
  EXPECT_THAT(program(options), HasSubstr("BEGIN PGM TWO_SIDED_SET-UP_1 MM"));
  options.program_name = "a name that is longer than a TNC shows";
  EXPECT_THAT(program(options), HasSubstr("BEGIN PGM A_NAME_THAT_IS_LONGER_TH MM"));
}

TEST(ProgramWords, LongCommentsGoOnBehindAWord) {
  PostOptions options = post_for("heidenhain");
  options.header = {"TOOL CHANGE T8: TAP D0.2362 IN = 6 MM PITCH 0.0394 IN = 1 MM FLOATING HOLDER"};
  EXPECT_THAT(program(options), HasSubstr(" = 1 MM\n2 ; FLOATING HOLDER\n"));
  options = post_for("grbl");
  options.header = {std::string(70, 'A') + " BBBB CCCC " + std::string(100, 'D')};
  EXPECT_THAT(program(options), HasSubstr("A BBBB)\n(CCCC)\n(DDD"));
}

/// One tool that turns about one centre in two operations.
std::string two_turns(const char* dialect) {
  Toolpath toolpath;
  Section section;
  section.tool_number = 1;
  section.spindle_rpm = 1000;
  section.workingstep = 0;
  const MmPerMin feed = MmPerMin::of(100);
  section.moves = {
      {Edge::line({2, 0}, {2, 0}), 5, 0, MoveKind::kPlunge, feed, 0},
      {Edge::arc({2, 0}, {0, 2}, {0, 0}, Turn::kCounterClockwise), 0, 0, MoveKind::kCut, feed, 0},
      {Edge::line({0, 2}, {0, 2}), 0, 5, MoveKind::kRapid, {}, 0},
  };
  toolpath.sections = {section, section};
  return write_program(toolpath, Part{}, post_for(dialect));
}

TEST(ProgramWords, OperationsSayAgainWhatIsModalInThePath) {
  std::string text = two_turns("heidenhain");
  text.erase(0, text.find("OPERATION 2"));
  EXPECT_THAT(text, HasSubstr(" CC X+0 Y+0\n"));
  for (const char* dialect : {"linuxcnc", "grbl", "haas", "mach4"}) {
    text = two_turns(dialect);
    text.erase(0, text.find("OPERATION 2"));
    text.erase(0, text.find('\n') + 1);
    EXPECT_THAT(text, ::testing::StartsWith("G0 Z10")) << dialect;
  }
}

/// The end of a helix lies beside the grid by less than a step, which is no reason to leave a thread askew.
TEST(ProgramWords, KlartextGoesStraightUpFromTheEndOfAHelix) {
  Toolpath toolpath;
  Section section;
  section.tool_number = 1;
  section.spindle_rpm = 1000;
  const MmPerMin feed = MmPerMin::of(100);
  section.moves = {
      {Edge::line({2, 0}, {2, 0}), 5, 0, MoveKind::kPlunge, feed, 0},
      {Edge::arc({2, 0}, {-1.2, 1.6}, {0, 0}, Turn::kCounterClockwise), 0, -1, MoveKind::kCut, feed, 0},
      {Edge::line({-1.2, 1.6}, {-1.2, 1.6}), -1, 5, MoveKind::kRapid, {}, 0},
      {Edge::line({-1.2, 1.6}, {7, 1.6}), 5, 5, MoveKind::kRapid, {}, 0},
  };
  toolpath.sections.push_back(section);
  const std::string text = write_program(toolpath, Part{}, post_for("heidenhain"));
  EXPECT_THAT(text, HasSubstr("CP IPA+126.8699 IZ-1 DR+"));
  EXPECT_THAT(text, HasSubstr(" L Z+5 R0 FMAX\n"));
  EXPECT_THAT(text, HasSubstr(" L X+7 Y+1.6 R0 FMAX\n")) << "the next move in plan says both";
}

TEST(ProgramWords, BlocksAreNumberedInTens) {
  PostOptions options = post_for("haas");
  // Without them the work of each tool alone has its number.
  std::string plain = program(options);
  for (const char* of_tool : {"\nN1 ", "\nN2 "}) plain.erase(plain.find(of_tool) + 1, 3);
  options.block_numbers = true;
  std::istringstream numbered(program(options));
  std::string line, without;
  int next = 10;
  while (std::getline(numbered, line)) {
    if (line.starts_with("N")) {
      const std::string word = "N" + std::to_string(next) + " ";
      ASSERT_TRUE(line.starts_with(word)) << line;
      line.erase(0, word.size());
      next += 10;
    } else {
      EXPECT_THAT(std::string("(%O"), HasSubstr(line.substr(0, 1))) << line;
    }
    without += line + "\n";
  }
  EXPECT_EQ(without, plain);
}

TEST(ProgramWords, ToolsPutInByHandAreTouchedOffBeforeTheProgramGoesOn) {
  EXPECT_THAT(program(post_for("grbl")), HasSubstr("T2\n(TOUCH OFF Z WITH THIS TOOL)\nM0\n"));
  EXPECT_THAT(program(post_for("marlin")),
              HasSubstr("; TOUCH OFF Z WITH THIS TOOL\nM0 INSERT T2, TOUCH OFF Z\n"));
  EXPECT_THAT(program(post_for("linuxcnc")), Not(HasSubstr("TOUCH OFF")));
}

/// What stands between the call of the second tool and its first cut.
std::string at_second_tool(const PostOptions& options) {
  const std::string text = program(options);
  const std::size_t begin = text.find("T2 M6\n");
  return text.substr(begin, text.find("G1 ", begin) - begin);
}

TEST(ProgramWords, FanucAndHaasCanBeEnteredAtEveryToolAfterAReset) {
  PostOptions options = post_for("fanuc");
  options.work_offset = {550};
  EXPECT_THAT(at_second_tool(options),
              HasSubstr("T2 M6\nG17 G40 G55 G80 G90 G94\nG61\nM3 S8000\nG0 X0. Y0.\nG43 H2"));
  options.work_offset = {541, 7};
  EXPECT_THAT(at_second_tool(options), HasSubstr("T2 M6\nG17 G40 G80 G90 G94\nG54.1 P7\nG61\n"));
  options = post_for("haas");
  EXPECT_THAT(at_second_tool(options), HasSubstr("T2 M6\nG17 G40 G54 G80 G90 G94\nG187 P2 E0.0005\n"));
  // The others begin in modes of their own, or run through what comes before.
  EXPECT_THAT(at_second_tool(post_for("mach3")), Not(HasSubstr("G54")));
  EXPECT_THAT(at_second_tool(post_for("linuxcnc")), Not(HasSubstr("G54")));
}

TEST(ProgramWords, OptionalStopComesBeforeEveryToolButTheFirst) {
  for (const auto& [dialect, first, second] :
       {std::tuple{"linuxcnc", "T1 M6", "T2 M6"}, std::tuple{"heidenhain", "TOOL CALL 1 ", "TOOL CALL 2 "}}) {
    SCOPED_TRACE(dialect);
    PostOptions options = post_for(dialect);
    EXPECT_THAT(program(options), Not(HasSubstr("M1\n")));
    options.optional_stop = true;
    const std::string text = program(options);
    const auto stop = text.find("M1\n");
    ASSERT_NE(stop, std::string::npos);
    EXPECT_EQ(text.find("M1\n", stop + 1), std::string::npos);
    EXPECT_LT(text.find(first), stop);
    EXPECT_LT(stop, text.find(second));
  }
}

TEST(ProgramWords, ControlsWithoutThemRefuseThem) {
  for (const char* dialect : {"heidenhain", "marlin"}) {
    PostOptions options = post_for(dialect);
    options.work_offset = {550};
    EXPECT_THAT(refusal(options), HasSubstr("--work-offset")) << dialect;
    options = post_for(dialect);
    options.block_numbers = true;
    EXPECT_THAT(refusal(options), HasSubstr("--block-numbers")) << dialect;
  }
  for (const char* dialect : {"marlin", "grbl"}) {
    PostOptions options = post_for(dialect);
    options.optional_stop = true;
    EXPECT_THAT(refusal(options), HasSubstr("--optional-stop")) << dialect;
  }
  for (const char* dialect : {"heidenhain", "marlin", "grbl"}) {
    PostOptions options = post_for(dialect);
    options.program_number = 7;
    EXPECT_THAT(refusal(options), HasSubstr("--program-number")) << dialect;
  }
}

/// A hole as link::drill_hole() makes it: over its centre at 10 mm, down, out again.
Section drilled(Vec2 center, double depth, int workingstep) {
  const Edge at = Edge::line(center, center);
  Section section;
  section.label = "HOLE" + std::to_string(workingstep + 1);
  section.workingstep = workingstep;
  section.tool_number = 1;
  section.spindle_rpm = 3000;
  section.moves = {{at, 10, 1, MoveKind::kRapid, {}, 0},
                   {at, 1, -depth, MoveKind::kPlunge, MmPerMin::of(100), 0},
                   {at, -depth, 10, MoveKind::kRapid, {}, 0}};
  return section;
}

Part with_steps(std::size_t count) {
  Part part;
  Tool tool;
  tool.number = 1;
  tool.kind = ToolKind::kDrill;
  tool.diameter = 5;
  part.tools = {tool};
  part.features.resize(count);
  part.workplan.resize(count);
  for (std::size_t i = 0; i < count; ++i) part.workplan[i].feature = static_cast<int>(i);
  return part;
}

int count_of(const std::string& text, const std::string& what) {
  int count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(ProgramWords, HolesAlikeAreOneCycleAndTheirPlaces) {
  Toolpath toolpath;
  for (int i = 0; i < 3; ++i) toolpath.sections.push_back(drilled({10.0 * i, 5}, 6, i));
  toolpath.sections.push_back(drilled({40, 5}, 8, 3));  // deeper
  for (const char* dialect : {"haas", "fanuc", "mazak", "tormach"}) {
    const std::string text = write_program(toolpath, with_steps(4), post_for(dialect));
    EXPECT_EQ(count_of(text, "G81"), 2) << text;
    EXPECT_EQ(count_of(text, "\nG80\n"), 2) << text;
    const char* point = std::string(dialect) == "tormach" ? "" : ".";
    EXPECT_THAT(text, HasSubstr(std::string("(OPERATION 2: HOLE2)\nX10") + point + " Y5" + point + "\n" +
                                "(OPERATION 3: HOLE3)\nX20" + point + " Y5" + point + "\nG80\n"));
  }
  EXPECT_EQ(count_of(write_program(toolpath, with_steps(4), post_for("linuxcnc")), "G81"), 4);
}

TEST(ProgramWords, ACycleEndsBeforeAnythingElse) {
  Part part = with_steps(3);
  part.workplan[1].stops = {{StopKind::kHalt, "TURN THE CLAMP"}};
  Toolpath toolpath;
  for (int i = 0; i < 3; ++i) toolpath.sections.push_back(drilled({10.0 * i, 5}, 6, i));
  EXPECT_EQ(count_of(write_program(toolpath, part, post_for("haas")), "G81"), 2);
  toolpath.sections[2].spindle_rpm = 2000;
  EXPECT_EQ(count_of(write_program(toolpath, part, post_for("haas")), "G81"), 3);
  toolpath.sections[2].coolant = Coolant::kFlood;
  const std::string text = write_program(toolpath, part, post_for("haas"));
  EXPECT_LT(text.rfind("G80\n", text.find("M8")), text.find("M8"));
}

TEST(ProgramWords, ToolsHaveNumbersAndTheNextOneIsCalledAhead) {
  for (const char* dialect : {"haas", "fanuc", "mazak"}) {
    const std::string text = program(post_for(dialect));
    EXPECT_THAT(text, HasSubstr("\nN1 G")) << dialect;
    EXPECT_THAT(text, HasSubstr("\nN2 G")) << dialect;
    EXPECT_THAT(text, Not(HasSubstr("N3 "))) << dialect;
    EXPECT_THAT(text, HasSubstr("T1 M6\nT2\n")) << dialect;
    EXPECT_THAT(text, Not(HasSubstr("T2 M6\nT"))) << dialect;
    EXPECT_EQ(count_of(text, "\nG53 G0 Y0.\n") + count_of(text, "\nG28 Y0.\n"), 1)
        << dialect << ": the table comes forward at the end";
  }
  PostOptions options = post_for("haas");
  options.block_numbers = true;
  EXPECT_THAT(program(options), Not(HasSubstr("\nN1 ")));
  EXPECT_THAT(program(post_for("linuxcnc")), Not(HasSubstr("\nN")));
}

TEST(ProgramWords, HaasIsToldWhatRoughsAndWhatFinishes) {
  Part part = with_steps(3);
  part.tools[0].kind = ToolKind::kEndMill;
  part.workplan[1].feature = 0;  // finishes what the first one roughs
  part.workplan[1].operation.kind = OperationKind::kFinishing;
  Toolpath toolpath;
  for (int i = 0; i < 3; ++i) {
    Section section = drilled({0, 0}, 1, i);
    section.moves.insert(section.moves.begin() + 2,
                         {Edge::line({0, 0}, {10, 0}), -1, -1, MoveKind::kCut, MmPerMin::of(300), 0});
    section.moves.back().path = Edge::line({10, 0}, {10, 0});
    toolpath.sections.push_back(section);
  }
  const std::string text = write_program(toolpath, part, post_for("haas"));
  const std::size_t rough = text.find("G187 P1 E"), fine = text.find("G187 P3 E"),
                    whole = text.find("G187 P2 E");
  ASSERT_NE(whole, std::string::npos) << text;
  EXPECT_LT(rough, fine);
  EXPECT_LT(fine, whole);
}

}  // namespace
}  // namespace clearcut::post
