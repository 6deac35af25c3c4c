// Programs that go on after a stop: what is read from the text must be what the program as a whole would have done from there on.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <string>

#include "base/random.h"
#include "pipeline/resume/resume.h"
#include "pipeline/test_drawings.h"
#include "read/gcode/gcode.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

const std::string kPocket = R"(%
O0012
G17 G21 G40 G49 G80 G90 G94
G54
G64 P0.01
T1 M6
S12000 M3
G4 P2
G43 H1
M8
G0 Z25
G0 X20 Y20
Z5
G1 Z-2 F300
X40 F1000
Y30
X20
Y20
G0 Z5
G91
G0 X2 Y2
G1 Z-7 F200
X16 F900
G90
G3 X38 Y28 I0 J3
X34 Y28 I-2 J0
G1 X22
Y22
G0 Z25
G98
G81 X30 Y25 Z-4 R2 F100
X32
G80
M5 M9
M30
%
)";

ResumedProgram resumed_alone(const std::string& program, int line,
                             std::optional<Dialect> dialect = Dialect::kLinuxCnc) {
  ProgramQuestion question;
  question.stock = Stock{{{0, 0}, {60, 50}}, -10, 0};
  question.dialect = dialect;
  return resume_program(question, {line, {}}, program, "pocket.nc", with({"endmill:6", "endmill:6"}));
}

std::string refusal_of(const std::string& program, int line) {
  try {
    resumed_alone(program, line);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Resume, BringsTheControlIntoTheStateBeforeTheLine) {
  const ResumedProgram resumed = resumed_alone(kPocket, 16);
  EXPECT_TRUE(resumed.after.findings.faults.empty()) << faults_of(resumed.after.findings);
  EXPECT_EQ(resumed.program.substr(0, resumed.program.find("Y30\n")),
            "%\nO0012\n(RESUMED BEFORE LINE 16)\nG17 G21 G40 G80 G90 G94\nG54\nG64 P0.01\nT1 M6\nS12000 M3\n"
            "G4 P2\nG0 G43 H1 Z25.\nG0 X40. Y20.\nM8\nG0 Z2.\nG1 Z-2. F100\nG1 Z-2. F1000\n");
  EXPECT_EQ(resumed.program.substr(resumed.program.find("Y30\n")), kPocket.substr(kPocket.find("Y30\n")));
  // Counting on from a place, at a feed that is slower than any before; nothing but G91 is in the way.
  const ResumedProgram counting = resumed_alone(kPocket, 23);
  EXPECT_TRUE(counting.after.findings.faults.empty()) << faults_of(counting.after.findings);
  EXPECT_THAT(counting.program,
              HasSubstr("G0 X20.939 Y20.939\nM8\nG0 Z2.\nG1 Z-2. F100\nG1 X22. Y22. F200\nG91\nX16 F900\n"));
}

/// Beside a wall the cutter comes down where it touches nothing, and goes straight to where the pass goes on.
TEST(Resume, ComesDownBesideTheWallThatItGoesOnCutting) {
  const std::string program =
      "G17 G21 G90 G94\nG54\nT1 M6\nS9000 M3\nG0 X20 Y20\nZ5\nG1 Z-2 F200\nX40 F800\nY24\nX20\nY20\nG0 "
      "Z25\nM30\n";
  const ResumedProgram resumed = resumed_alone(program, 10);
  EXPECT_TRUE(resumed.after.findings.faults.empty()) << faults_of(resumed.after.findings);
  EXPECT_THAT(resumed.program,
              HasSubstr("G0 X40. Y24.\nG0 Z2.\nG1 Z-2. F200\nG1 Z-2. F800\nX20\nY20\n"));  // in a slot
  const ResumedProgram along = resumed_alone(program, 11);
  EXPECT_THAT(along.program, HasSubstr("G0 Z2.\nG1 Z-2. F200\nG1 X20. Y24. F800\nY20\n"));
  EXPECT_TRUE(along.after.findings.faults.empty()) << faults_of(along.after.findings);
}

/// What the lines above cut counts as cut, and only that: a rapid through it is none through material.
TEST(Resume, WhatWasCutBeforeIsTakenAway) {
  std::string low = kPocket;
  low.replace(low.find("G0 X2 Y2"), 8, "G0 X2 Z-7");  // along the slot that line 15 cut
  const auto at = low.find("G1 Z-7 F200");
  low.replace(at, 11, "G1 Y2 F200");
  EXPECT_TRUE(has(resumed_alone(low, 16).after.findings, FaultKind::kRapidInMaterial) ==
              has(resumed_alone(low, 14).after.findings, FaultKind::kRapidInMaterial));
  const ResumedProgram late = resumed_alone(kPocket, 29);
  EXPECT_TRUE(late.after.findings.faults.empty()) << faults_of(late.after.findings);
}

TEST(Resume, NamesTheNearestLineThatServes) {
  EXPECT_THAT(refusal_of(kPocket, 26),
              HasSubstr("among arcs whose word stands in a line before; the nearest line that "
                        "serves is --line 25"));
  EXPECT_THAT(refusal_of(kPocket, 32),
              HasSubstr("within a drilling or tapping cycle; the nearest line that serves "
                        "is --line 31"));
  EXPECT_THAT(refusal_of(kPocket, 33), HasSubstr("nothing moves from here on"));
  EXPECT_THAT(refusal_of(kPocket, 99), HasSubstr("nothing is run from here on"));
  std::string changed = kPocket;
  changed.replace(changed.find("G91\n"), 4, "T2 M6\nM3\nG43 H2\nG91\n");
  EXPECT_THAT(refusal_of(changed, 21),
              HasSubstr("the word for the new length (G43); the nearest line that serves is "
                        "--line 20"));
  std::string shifted = kPocket;
  shifted.replace(shifted.find("G91\n"), 4, "G92 Z5\nG91\n");
  EXPECT_THAT(refusal_of(shifted, 24), HasSubstr("(G92, G10); the nearest line that serves is --line 20"));
  std::string computed = kPocket;
  computed.replace(computed.find("G91\n"), 4, "#1 = 2\nG91\n");
  EXPECT_THAT(
      refusal_of(computed, 24),
      HasSubstr("after lines that compute or call subprograms; the nearest line that serves is --line 20"));
  EXPECT_EQ(refusal_of(computed, 16), "none");
}

/// The rest of a program is read with the radii that the whole is read with.
TEST(Resume, ProgramsWithCompensatedPassesAreServedBeforeThem) {
  PlanOptions options = with({"endmill:6"});
  options.shop.finish = "walls";
  options.shop.compensation = "wear";
  options.shop.spring_passes = 1;
  const Part part = read::read_part_text(
      R"({"units": "mm", "pockets": [{"name": "P", "depth": 3, "outer": [[0, 0], [40, 0], [40, 30], [0, 30]]}]})",
      "pocket.json", {});
  const PlanResult plan = plan_part(part, options);
  const auto line_of = [&](std::size_t at) {
    return 1 + static_cast<int>(std::count(plan.program.begin(),
                                           plan.program.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  };
  const auto resumed_at = [&](int line) {
    return resume_program({&part, std::nullopt, std::nullopt, std::nullopt}, {line, std::nullopt},
                          plan.program, "p.ngc", options);
  };
  const int compensated = line_of(plan.program.find("G41"));
  EXPECT_EQ(faults_of(resumed_at(compensated - 2).after.findings), "");
  try {
    resumed_at(line_of(plan.program.rfind("G41")));
    FAIL() << "what D held in the pass before is not known";
  } catch (const InputError& error) {
    EXPECT_THAT(
        std::string(error.what()),
        HasSubstr(fmt::format("behind line {}, from which on it compensates for wear", compensated + 1)));
  }
}

const std::string kKlartext = R"(0 BEGIN PGM POCKET MM
1 BLK FORM 0.1 Z X+0 Y+0 Z-10
2 BLK FORM 0.2 X+60 Y+50 Z+0
3 CYCL DEF 32.0 TOLERANCE
4 CYCL DEF 32.1 T0.01
5 TOOL CALL 1 Z S12000 F500
6 M3
7 L X+20 Y+20 R0 FMAX M8
8 L Z+5 R0 FMAX
9 L Z-2 R0 F300
10 L X+40 F1000
11 L Y+30
12 L X+20
13 L Y+20
14 CC X+30 Y+25
15 L X+25 Y+25
16 C X+35 Y+25 DR+
17 CP IPA+90 DR+
18 RND R1
19 L Y+28
20 L Z+25 R0 FMAX
21 CYCL DEF 200 DRILLING ~
  Q200=+2 ~
  Q201=-4 ~
  Q206=+100 ~
  Q202=+4 ~
  Q210=+0 ~
  Q203=+0 ~
  Q204=+25 ~
  Q211=+0
22 L X+30 Y+25 R0 FMAX M99
23 L X+32 R0 FMAX M99
24 L Z+50 R0 FMAX
25 CALL LBL 1
26 M30
27 LBL 1
28 L X+5 R0 FMAX
29 LBL 0
30 END PGM POCKET MM
)";

ResumedProgram klartext_resumed(int line) {
  return resumed_alone(kKlartext, line, Dialect::kHeidenhain);
}
std::string klartext_refused(int line) {
  try {
    klartext_resumed(line);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

/// What the program itself says of its tools holds for the resumed one as well.
TEST(ResumeKlartext, DefinitionsOfToolsAreRepeated) {
  std::string program = kKlartext;
  const std::string definition = "TOOL DEF 1 L+0 R+3";
  program.insert(program.find("5 TOOL CALL"), "5 " + definition + "\n");
  const ResumedProgram resumed = resumed_alone(program, 13, Dialect::kHeidenhain);
  EXPECT_LT(resumed.program.find(definition), resumed.program.find("TOOL CALL 1"));
}

TEST(ResumeKlartext, BringsTheControlIntoTheStateBeforeTheLine) {
  const ResumedProgram resumed = klartext_resumed(12);
  EXPECT_EQ(faults_of(resumed.after.findings), "");
  EXPECT_EQ(
      resumed.program.substr(0, resumed.program.find("11 L Y+30")),
      "0 BEGIN PGM POCKET MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-10\n2 BLK FORM 0.2 X+60 Y+50 Z+0\n3 ; RESUMED "
      "BEFORE LINE 12\n4 CYCL DEF 32.0 TOLERANCE\n5 CYCL DEF 32.1 T0.01\n6 TOOL CALL 1 Z S12000 F500\n7 "
      "M3\n8 L Z+50 R0 FMAX\n9 L X+40 Y+20 R0 FMAX\n10 M8\n11 L Z+2 R0 FMAX\n12 L Z-2 R0 F100\n13 L Z-2 "
      "F1000\n");
  EXPECT_THAT(resumed.program, ::testing::EndsWith(kKlartext.substr(kKlartext.find("11 L Y+30"))));
}

TEST(ResumeKlartext, BringsThePoleAndTheCycleBack) {
  EXPECT_THAT(klartext_resumed(17).program, HasSubstr(" CC X+30 Y+25\n"));
  EXPECT_EQ(faults_of(klartext_resumed(17).after.findings), "");
  const ResumedProgram hole = klartext_resumed(32);
  EXPECT_THAT(hole.program, HasSubstr(" CYCL DEF 200 DRILLING ~\nQ200=+2 ~\n"));
  EXPECT_EQ(faults_of(hole.after.findings), "");
}

TEST(ResumeKlartext, NamesTheNearestLineThatServes) {
  EXPECT_THAT(klartext_refused(19), HasSubstr("goes on from the move before"));
  EXPECT_THAT(klartext_refused(24),
              HasSubstr("within the definition of a cycle; the nearest line that serves"));
  EXPECT_THAT(klartext_refused(33), HasSubstr("none"));
  EXPECT_THAT(klartext_refused(35), HasSubstr("after lines that compute or call"));
}

const std::string kSinumerik = R"(%_N_POCKET_MPF
;$PATH=/_N_WKS_DIR
G17 G710 G90 G94 G500
SOFT FFWON
CYCLE832(0.02,_ROUGH,1)
T="MILL" M6
S12000 M3
G4 F2
G0 X20 Y20 D1
Z5 M8
G1 Z-2 F300
X40 F1000
Y30
X20
CYCLE832(0,_OFF,1)
G642 CTOL=0.01
Y20
BRISK
X22
G0 Z5
TRANS X10
G0 X12 Y20
TRANS
MCALL CYCLE81(25,0,2,-4)
G0 X30 Y25
X32
MCALL
G0 Z25
T="DRILL" M6
S3000 M3
G0 X50 Y40 D1
Z5
G1 Z-1 F100
Z5 F300
R1=5
M30
)";

ResumedProgram sinumerik_resumed(int line) {
  return resumed_alone(kSinumerik, line, Dialect::kSiemens);
}
std::string sinumerik_refused(int line) {
  try {
    sinumerik_resumed(line);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(ResumeSinumerik, BringsTheControlIntoTheStateBeforeTheLine) {
  const ResumedProgram resumed = sinumerik_resumed(13);
  EXPECT_EQ(faults_of(resumed.after.findings), "");
  EXPECT_EQ(resumed.program.substr(0, resumed.program.find("Y30\n")),
            "%_N_POCKET_MPF\n;$PATH=/_N_WKS_DIR\n; RESUMED BEFORE LINE 13\nG17 G710 G90 G94\nG500\n"
            "CYCLE832(0.02,_ROUGH,1)\nSOFT\nFFWON\nT=\"MILL\" M6\nS12000 M3\nG4 F2\nG0 D1 Z25.\n"
            "G0 X40. Y20.\nM8\nG0 Z2.\nG1 Z-2. F300\nG1 Z-2. F1000\n");
  EXPECT_THAT(resumed.program, ::testing::EndsWith(kSinumerik.substr(kSinumerik.find("Y30\n"))));
  // The way of rounding corners and of driving is the last one.
  EXPECT_THAT(sinumerik_resumed(19).program, HasSubstr("G642 CTOL=0.01\nFFWON\nBRISK\n"));
}

TEST(ResumeSinumerik, ToolsKeepTheNumbersOfTheirNames) {
  const ResumedProgram resumed = sinumerik_resumed(33);
  EXPECT_THAT(resumed.program, HasSubstr("; T=\"DRILL\" IS T2\n; T=\"MILL\" IS T1\n"));
  EXPECT_THAT(resumed.program, HasSubstr("T=\"DRILL\" M6\nS3000 M3\n"));
  EXPECT_EQ(resumed.tool, 2);
  EXPECT_EQ(resumed.after.toolpath.sections.back().tool_number, 2);
}

TEST(ResumeSinumerik, NamesTheNearestLineThatServes) {
  EXPECT_THAT(sinumerik_refused(22), HasSubstr("(G68, G51.1, G16, TRANS, ROT, cycles 7 and 10); the nearest "
                                               "line that serves is --line 21"));
  EXPECT_THAT(sinumerik_refused(26),
              HasSubstr("within a drilling or tapping cycle; the nearest line that serves is --line 24"));
  EXPECT_EQ(sinumerik_refused(27), "none");
  EXPECT_THAT(sinumerik_refused(36), HasSubstr("after lines that compute or call"));
}

TEST(Resume, APlaceIsPassedByTheFirstMoveThatRunsThere) {
  ProgramQuestion question;
  question.stock = Stock{{{0, 0}, {60, 50}}, -10, 0};
  question.dialect = Dialect::kLinuxCnc;
  Stop stop;
  stop.place = {{40.02, 25, -2}};
  const ResumedProgram resumed = resume_program(question, stop, kPocket, "pocket.nc", with({"endmill:6"}));
  EXPECT_EQ(resumed.line, 16);
  EXPECT_EQ(resumed.passes, 1);
  EXPECT_NEAR(resumed.beside_mm, 0.02, 1e-9);
  stop.place = {{55, 25, -2}};
  try {
    resume_program(question, stop, kPocket, "pocket.nc", with({"endmill:6"}));
    ADD_FAILURE() << "no refusal";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("line 25 comes nearest, 14 mm beside"));
  }
}

/// What the control holds at a move, told.
std::string told_state(const ControlTable& control, const Toolpath& toolpath, int line) {
  std::size_t index = 0;
  for (const Section& section : toolpath.sections)
    for (const Move& move : section.moves) {
      if (move.line < line || is_rapid(move.kind)) {
        ++index;
        continue;
      }
      const ControlState* const state = control.at(index);
      if (!state) return "none";
      return fmt::format("T{} {} S{} {} {} {} {} F{}", state->tool, static_cast<int>(state->spindle),
                         state->spindle_rpm, static_cast<int>(state->coolant),
                         static_cast<int>(state->length.kind), state->length.h,
                         static_cast<int>(state->path.mode), move.feed.mm_per_min());
    }
  return "end";
}

/// The names of the open ones.
std::string conditions_of(const Findings& findings) {
  std::set<std::string> names;
  for (const Condition& one : findings.conditions)
    if (one.met_by.empty()) names.insert(one.name);
  return fmt::format("{}", fmt::join(names, " "));
}

/// The same for a program that begins anew: a change of tools before the stop is not made again.
std::string conditions_kept(const Findings& before, const Findings& after) {
  const bool changes = conditions_of(after).find("m6") != std::string::npos;
  Findings kept = before;
  std::erase_if(kept.conditions, [&](const Condition& one) { return one.name == "m6" && !changes; });
  return conditions_of(kept);
}

/// What is wrong, without lines of programs.
std::string kinds_of(const Findings& findings) {
  std::multiset<std::string> kinds;
  for (const Fault& fault : findings.faults)
    kinds.insert(fmt::format("{} {} {:.4f}", name_of(fault.kind), fault.feature, fault.size));
  return fmt::format("{}", fmt::join(kinds, "; "));
}

struct Counted {
  int served = 0, refused = 0;
};

/// Stops at random lines of one program.
void stop_at_random(const Part& part, const PlanResult& planned, const PlanOptions& options, int stops,
                    Random& random, Counted& counted) {
  ProgramQuestion question;
  question.part = &part;
  question.dialect = read::gcode::dialect_named(options.post.dialect);
  const CheckResult whole = check_program(part, planned.program, "plan.nc", options, question.dialect);
  const auto lines = static_cast<int>(std::count(planned.program.begin(), planned.program.end(), '\n'));
  for (int k = 0; k < stops; ++k) {
    const int line = 1 + static_cast<int>(random.below(static_cast<std::uint64_t>(lines)));
    try {
      const ResumedProgram resumed =
          resume_checked(whole, question, {line, {}}, planned.program, "plan.nc", options);
      ++counted.served;
      const Findings &before = resumed.before.findings, &after = resumed.after.findings;
      ASSERT_EQ(kinds_of(after), kinds_of(before))
          << faults_of(after) << options.post.dialect << " line " << line << "\n"
          << resumed.program.substr(0, 600);
      ASSERT_EQ(conditions_of(after), conditions_kept(before, after))
          << texts_of(after) << options.post.dialect << " line " << line << "\n"
          << resumed.program.substr(0, 600);
      ASSERT_NEAR(after.all.uncut_thickness_mm, before.all.uncut_thickness_mm, 1e-6);
      const int now = resumed.line + resumed.new_lines;
      ASSERT_EQ(told_state(resumed.after.control, resumed.after.toolpath, now),
                told_state(resumed.before.control, resumed.before.toolpath, resumed.line))
          << options.post.dialect << " line " << line << "\n"
          << resumed.program.substr(0, 600);
    } catch (const InputError& error) {
      ++counted.refused;
      const std::string what = error.what();
      const bool is_known = what.find("the nearest line that serves") != std::string::npos ||
                            what.find("from here on") != std::string::npos;
      ASSERT_TRUE(is_known) << options.post.dialect << " line " << line << ": " << what;
    }
  }
}

/// Stops of the random test; more by the environment variable.
int random_stops() {
  const char* asked = std::getenv("CLEARCUT_RANDOM_STOPS");
  return asked ? std::atoi(asked) : 1;
}

TEST(Resume, RandomStopsMakeTheSamePart) {
  const Part part = drawn(box("STOCK_D12", 0, 0, 60, 36) + rounded_box("POCKET_D4", 5, 5, 22, 19, 4) +
                          circle("DRILL_D12", {43.18, 12.7}, 2.5) + circle("DRILL_D12", {43.18, 25.4}, 2.5) +
                          circle("DRILL_D12", {50.8, 20.32}, 2.5));
  Random random(49);
  Counted counted;
  for (const std::string& dialect : controller_names()) {
    for (const bool inch : {false, true}) {
      if (inch && dialect == "marlin") continue;
      PlanOptions options = with({"endmill:6", "drill:5"});
      options.post.dialect = dialect;
      options.post.inch = inch;
      options.cutting.coolant = Coolant::kFlood;
      const PlanResult planned = plan_part(part, options);
      stop_at_random(part, planned, options, random_stops(), random, counted);
      if (HasFatalFailure()) return;
    }
  }
  if (random_stops() > 10) printf("%d stops served, %d refused\n", counted.served, counted.refused);
  EXPECT_GT(counted.served, counted.refused);
}

}  // namespace
}  // namespace clearcut::pipeline
