// All readers on broken files and on those that other programs write.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/error.h"
#include "base/file.h"
#include "base/units.h"
#include "order/tsplib.h"
#include "read/gcode/gcode.h"
#include "read/gcode/laying.h"
#include "read/job/job_file.h"
#include "read/job/machine_file.h"
#include "read/job/read_part.h"
#include "support/command.h"
#include "support/data.h"
#include "support/read_parts.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;
using test_support::area_of;
using test_support::depth_2;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string refusal(const std::string& path, const ReadOptions& options = depth_2()) {
  try {
    read::read_part(path, options);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "not refused";
}

TEST(ReadPart, WhatCannotBeReadGivesOneLineWithTheFileAndWhatToDo) {
  const test_support::ScratchFolder folder;
  EXPECT_THAT(refusal(folder.path("absent.dxf")), HasSubstr("no such file"));
  EXPECT_THAT(refusal(folder.path("")), HasSubstr("is a folder"));
  for (const char* name : {"empty.dxf", "empty.svg", "empty.json", "empty.stp", "empty.toml", "empty"}) {
    EXPECT_THAT(refusal(folder.file(name, " \n")), HasSubstr("the file is empty")) << name;
  }
  const std::string binary(
      "\x7f"
      "ELF\0\1\2\0",
      8);
  for (const char* name : {"b.dxf", "b.svg", "b.json", "b.stpnc", "b"}) {
    EXPECT_THAT(refusal(folder.file(name, binary)), HasSubstr("binary file")) << name;
  }
  EXPECT_THAT(refusal(folder.file("b.drl", "T\7\2\x80T\4")), HasSubstr("binary file"));
  EXPECT_THAT(refusal(folder.file("c.drl", "M48\nMETRIC\n%\nJ\xe4ger\n")), HasSubstr("'J?ger'"));
  EXPECT_THAT(refusal(folder.file("w.svg", "\xff\xfe<")), HasSubstr("UTF-16"));
  EXPECT_THAT(refusal(folder.file("noise.xyz", "what is this")), HasSubstr("unknown kind of file"));
  // EAGLE's drill files begin with a % and have a name of their own.
  EXPECT_THAT(refusal(folder.file("board.drd", "%\nM48\nM72\nT01C0.0236\n%\nT01\nX1Y1\n")),
              HasSubstr("cut short"));
  EXPECT_THAT(
      refusal(folder.file("solid.step",
                          "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
                          "FILE_NAME('','',(''),(''),'','','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\n"
                          "ENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\nENDSEC;\n"
                          "END-ISO-10303-21;\n")),
      StartsWith(folder.path("solid.step")));
}

TEST(ReadPart, ContentDecidesWhereTheNameDoesNot) {
  const test_support::ScratchFolder folder;
  const fs::path examples = fs::path(CLEARCUT_SOURCE_DIR) / "examples";
  for (const char* name : {"bracket.dxf", "bracket.svg", "bracket.json"}) {
    const std::string copy = folder.file(std::string(name) + ".txt", read_file((examples / name).string()));
    EXPECT_NEAR(area_of(read::read_part(copy, depth_2())), area_of(read::read_part(examples / name, {})),
                1e-6)
        << name;
  }
}

/// Every file of the corpus is read, or refused in one line.
TEST(Corpus, EveryFileIsReadOrRefused) {
  const fs::path corpus = fs::path(CLEARCUT_SOURCE_DIR) / "tests" / "corpus";
  int read = 0, refused = 0;
  for (const char* kind : {"outline", "dxf", "svg", "edges", "gerber", "excellon"}) {
    ASSERT_TRUE(fs::is_directory(corpus / kind)) << kind;
    for (const auto& entry : fs::directory_iterator(corpus / kind)) {
      try {
        read::read_part(entry.path(), depth_2());
        ++read;
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << entry.path();
        ++refused;
      }
    }
  }
  EXPECT_GT(read, 10);
  EXPECT_GT(refused, 5);
}

/// Drawings as other programs write them, with areas computed by hand, mm2.
TEST(Corpus, HabitsOfOtherProgramsGiveTheRightAreas) {
  struct Row {
    const char* file;
    double area;
  };
  const double bow = 4 * std::atan(0.5), wide = 4 * std::atan(1.5), flat = 4 * std::atan(0.3);
  const auto segment = [](double chord, double bulge, double angle) {
    const double r = chord * (1 + bulge * bulge) / (4 * bulge);
    return r * r * (angle - std::sin(angle)) / 2;
  };
  const Row rows[] = {
      {"dxf/blocks_mirror.dxf", 150 * 120 - 3 * (60 + 4.5 * kPi)},  // the block by scales of -2 and 1
      {"dxf/neg_bulge.dxf", 2400 - segment(40, 0.5, bow) + segment(60, 1.5, wide)},
      {"dxf/extr_negz.dxf", 2400 + segment(60, 0.3, flat) - 12.5 * kPi},
      {"dxf/overlap.dxf", 2400},
      {"dxf/touch_self.dxf", 2400 - 200},
      {"dxf/zero_len.dxf", 2400},
      {"dxf/hole_touch.dxf", 2400 - 100 * kPi},
      {"dxf/dup_end_closed.dxf", 2400},
      {"dxf/gaps.dxf", 2400},
      {"svg/use_symbol.svg", 20 * 20 + 8 * 4 * 2 * 1},
      {"svg/vb_off.svg", 60 * 40 * 4},
      {"svg/vb_par.svg", 60 * 40 * 1.25 * 1.25},
      {"svg/nested_tf.svg", 20 * 10},
      {"svg/rxry.svg", 2400 - (4 - kPi) * 30 * 5},
      {"svg/hole_touch.svg", 2400 - 100 * kPi},
      {"svg/arcflags.svg", 900 * kPi},
  };
  const fs::path corpus = fs::path(CLEARCUT_SOURCE_DIR) / "tests" / "corpus";
  for (const Row& row : rows)
    EXPECT_NEAR(area_of(read::read_part(corpus / row.file, depth_2())), row.area, 0.05) << row.file;
}

/// The same for jobs and tool libraries.
TEST(Corpus, EveryJobAndToolLibraryIsReadOrRefused) {
  const fs::path corpus = fs::path(CLEARCUT_SOURCE_DIR) / "tests" / "corpus";
  int read = 0, refused = 0;
  for (const std::string kind : {"job", "tools", "machine"}) {
    ASSERT_TRUE(fs::is_directory(corpus / kind)) << kind;
    for (const auto& entry : fs::directory_iterator(corpus / kind)) {
      try {
        if (kind == "job") {
          read::read_job(entry.path());
        } else if (kind == "machine") {
          read::read_machine(entry.path());
        } else {
          read::read_tool_library(entry.path(), {});
        }
        ++read;
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << entry.path();
        ++refused;
      }
    }
  }
  EXPECT_GE(read, 7);
  EXPECT_GE(refused, 8);
}

/// The same for points and tours, for programs that lay a line, and for Klartext without its first line.
TEST(Corpus, EveryTourAndKlartextIsReadOrRefused) {
  const fs::path corpus = fs::path(CLEARCUT_SOURCE_DIR) / "tests" / "corpus";
  int read = 0, refused = 0;
  for (const std::string kind : {"tsplib", "klartext", "laying"}) {
    ASSERT_TRUE(fs::is_directory(corpus / kind)) << kind;
    for (const auto& entry : fs::directory_iterator(corpus / kind)) {
      const std::string text = read_file(entry.path().string());
      const std::string name = entry.path().string();
      try {
        if (kind == "klartext") {
          read::gcode::read_gcode(text.starts_with("0") ? text : "0 BEGIN PGM A MM\n" + text, name);
        } else if (kind == "laying") {
          read::gcode::read_laying(text, name);
        } else if (name.ends_with(".tour")) {
          order::read_tsplib_tour(text, name, 6);
        } else {
          order::read_tsplib(text, name);
        }
        ++read;
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << name;
        ++refused;
      }
    }
  }
  EXPECT_GE(read, 4);
  EXPECT_GE(refused, 8);
}

}  // namespace
}  // namespace clearcut
