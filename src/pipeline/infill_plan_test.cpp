// Areas filled by a line of constant width: planned, written, read back and proven; and what wrong programs are called.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "base/text.h"
#include "pipeline/infill.h"
#include "pipeline/test_drawings.h"
#include "read/gcode/laying.h"

namespace clearcut::pipeline {
namespace {

using ::testing::HasSubstr;

/// A plate with a round hole, and a rounded one beside it.
Part plates() {
  return drawn(box("POCKET_D1", 0, 0, 30, 20) + circle("ISLAND", {12, 10}, 4) +
               rounded_box("POCKET_D1", 34, 0, 50, 20, 5));
}

InfillOptions extruded(double width) {
  InfillOptions options;
  options.width = width;
  options.rate = 0.033;
  options.z = 0.2;
  return options;
}

std::string sentences(const LaidFindings& findings) {
  std::string text;
  for (const std::string& fault : findings.faults) text += fault + "\n";
  return text;
}

TEST(Infill, AreasAreCoveredByALineAndTheAmountIsTheStatedOne) {
  for (const double width : {0.4, 0.8}) {
    const InfillResult result = plan_infill(plates(), extruded(width));
    const LaidFindings& found = result.findings;
    EXPECT_TRUE(found.is_clean()) << sentences(found);
    EXPECT_EQ(found.uncut_mm2, 0);
    EXPECT_LE(found.over_share, 0.1);
    EXPECT_LT(found.outside_mm, 0.001);
    EXPECT_NEAR(found.amount, 0.033 * found.laid_mm, 1e-5 * found.laid_mm);
    EXPECT_NEAR(found.region_mm2, 30 * 20 - 16 * kPi + 16 * 20 - 25 * (4 - kPi), 0.01);
    // Neither arcs nor plunges: a layer of straight moves.
    for (const char* word : {"G2 ", "G3 ", "M4 "}) EXPECT_EQ(result.program.find(word), std::string::npos);
    for (const auto& move : read::gcode::read_laying(result.program, "a").moves) EXPECT_EQ(move.z, 0.2);
  }
}

TEST(Infill, ALaserHasItsPowerAlongTheLineAndNoneBetweenLines) {
  InfillOptions options = extruded(0.5);
  options.word = LayingWord::kPower;
  options.rate = 300;
  const InfillResult result = plan_infill(plates(), options);
  EXPECT_TRUE(result.findings.is_clean()) << sentences(result.findings);
  EXPECT_EQ(result.findings.amount, 300);
  EXPECT_THAT(result.program, HasSubstr(" S300"));
  EXPECT_EQ(result.program.find(" E"), std::string::npos);
}

TEST(Infill, EveryStrategyThatPlansCoversOrSaysWhatItLeaves) {
  int covers = 0;
  for (const std::string name : {"contour", "zigzag", "spiral", "adaptive", "tour", "lom-corrected", "rho"}) {
    InfillOptions options = extruded(1.5);
    options.strategy = name;
    options.most_over = 10;
    const LaidFindings found = plan_infill(drawn(box("POCKET_D1", 0, 0, 30, 20)), options).findings;
    EXPECT_LT(found.outside_mm, 0.001) << name;
    EXPECT_EQ(found.is_clean(), found.uncut_mm2 == 0) << name << sentences(found);
    covers += found.uncut_mm2 == 0 ? 1 : 0;
  }
  EXPECT_GE(covers, 5);
}

/// The program with another text in place of the first one, from a line on that begins so.
std::string changed(std::string program, const std::string& from, const std::string& to) {
  const auto at = program.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return program.replace(at, from.size(), to);
}

TEST(Infill, WrongProgramsAreFaulty) {
  const Part plate = drawn(box("POCKET_D1", 0, 0, 30, 20));
  InfillOptions options = extruded(2);
  options.strategy = "zigzag";
  options.most_over = 0.15;
  const std::string program = plan_infill(plate, options).program;
  const auto said_of = [&](const std::string& text, const InfillOptions& asked) {
    return sentences(check_infill(plate, text, "wrong.gcode", asked));
  };
  EXPECT_EQ(said_of(program, options), "");
  std::vector<std::string> lines = split(program, '\n');
  // A line that is travelled instead of laid leaves a strip bare.
  std::string bare;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto e = lines[i].find(" E");
    bare +=
        (i > lines.size() / 2 && i < lines.size() / 2 + 3 && e != std::string::npos ? lines[i].substr(0, e)
                                                                                    : lines[i]) +
        "\n";
  }
  EXPECT_THAT(said_of(bare, options), HasSubstr("left bare"));
  // The same layer twice.
  const std::string body = program.substr(program.find("G0 X"), program.find("M2") - program.find("G0 X"));
  EXPECT_THAT(said_of(changed(program, "M2", body + "M2"), options),
              HasSubstr("laid over what is covered already"));
  // Wider lines than the program was made for go over the edge, narrower ones leave gaps.
  InfillOptions other = options;
  other.width = 2.1;
  EXPECT_THAT(said_of(program, other), HasSubstr("over the edge"));
  other.width = 1.9;
  EXPECT_THAT(said_of(program, other), HasSubstr("left bare"));
  other = options;
  other.rate = 0.0334;
  EXPECT_THAT(said_of(program, other), HasSubstr("stated are"));
  other = options;
  other.z = 0.4;
  EXPECT_THAT(said_of(program, other), HasSubstr("the layer is at 0.4"));
  other = options;
  other.most_over = 0;
  EXPECT_THAT(said_of(program, other), HasSubstr("stated are 0 %"));
  other = options;
  other.word = LayingWord::kPower;
  EXPECT_THAT(said_of(program, other), HasSubstr("the other word"));
}

TEST(Infill, WhatCannotBeFilledIsRefused) {
  const auto refusal_of = [](const Part& part, const InfillOptions& options) -> std::string {
    try {
      plan_infill(part, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal_of(plates(), extruded(0)), HasSubstr("must be above 0"));
  EXPECT_THAT(refusal_of(plates(), extruded(40)), HasSubstr("wider than every place"));
  EXPECT_THAT(refusal_of(drawn(box("PROFILE_D1", 0, 0, 30, 20)), extruded(1)),
              HasSubstr("is no area to fill"));
}

}  // namespace
}  // namespace clearcut::pipeline
