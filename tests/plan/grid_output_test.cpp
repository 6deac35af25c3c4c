// The grid model: what is written, and the command.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "base/file.h"
#include "pipeline/elements.h"
#include "read/outline/read_elements.h"
#include "report/picture/grid_picture.h"
#include "support/command.h"
#include "support/element_jobs.h"

namespace clearcut {
namespace {

using test_support::kExample;
using test_support::rectangle;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// --- What is written.

TEST(PointTable, SavesOneLineForEveryPoint) {
  const auto job = read::read_elements(kExample);
  const auto result = pipeline::plan_elements(job, {});
  const std::string csv = report::points_csv(job, result.points);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 1365);
  EXPECT_THAT(
      csv, HasSubstr("point,element,id,kind,column,row,x,y,tool,diameter,depth,feed,spindle,reduced,visit\n"
                     "1,1,middle,rectangle,15,15,15,15,1,6,4,800,5300,0,\n"));
}

std::size_t occurrences(const std::string& text, const std::string& of) {
  std::size_t count = 0;
  for (auto at = text.find(of); at != std::string::npos; at = text.find(of, at + 1)) ++count;
  return count;
}

TEST(GridPicture, DrawsEverySquareAndEveryReducedOne) {
  const auto job = read::read_elements(kExample);
  const auto result = pipeline::plan_elements(job, {});
  const std::string svg = report::grid_picture(job, result.points, result.plan.toolpath);
  EXPECT_EQ(occurrences(svg, "<rect"), 1u + 3u + 1365u + 180u) << "page, stocks, squares, reduced squares";
  EXPECT_EQ(occurrences(svg, "<path"), 10u) << "swept area and centre line of five pockets";
}

TEST(ElementsCommand, WritesEverythingAndSaysThatMaterialIsLeft) {
  const test_support::ScratchFolder folder;
  const auto run = test_support::run_clearcut({"elements", kExample, "-o", folder.path("p.ngc"), "--svg",
                                               folder.path("p.svg"), "--certificate", folder.path("p.json"),
                                               "--points", folder.path("p.csv")});
  EXPECT_EQ(run.exit_code, 1) << run.err;
  EXPECT_THAT(folder.names(), ::testing::UnorderedElementsAre("p.ngc", "p.svg", "p.json", "p.csv"));
  EXPECT_THAT(run.out, HasSubstr("uncut: middle"));
  EXPECT_THAT(read_file(folder.path("p.json")), HasSubstr("\"uncut_thickness_mm\""));
}

TEST(ElementsCommand, TakesElementsAsOptionsInTheOrderTyped) {
  const test_support::ScratchFolder folder;
  const auto run = test_support::run_clearcut({"elements",
                                               "--hole",
                                               "12,12,9:id=first",
                                               "--line",
                                               "25,5,25,35:id=second",
                                               "--hole",
                                               "12,30,9:T2",
                                               "--slot",
                                               "35,8,35,30,6:T2",
                                               "--arc",
                                               "45,8,45,30,11,ccw:T2",
                                               "--pocket",
                                               "60,5,20,20",
                                               "--tool",
                                               "endmill:6",
                                               "--tool",
                                               "endmill:4",
                                               "--depth",
                                               "2",
                                               "-o",
                                               folder.path("p.ngc"),
                                               "--certificate",
                                               folder.path("p.json")});
  EXPECT_NE(run.exit_code, 2) << run.err;
  EXPECT_LT(run.out.find("first"), run.out.find("second"));
  EXPECT_LT(run.out.find("second"), run.out.find("element 3"));
  EXPECT_THAT(read_file(folder.path("p.json")), HasSubstr("\"gouge_mm\": 0"));
}

TEST(ElementsCommand, RefusesBadElementsInOneLineAndWritesNothing) {
  const test_support::ScratchFolder folder;
  const std::vector<std::vector<std::string>> bad{
      {"--hole", "12,12"}, {"--hole", "12,12,9", kExample}, {"--hole", "12,12,3", "--tool", "endmill:6"}};
  for (const auto& options : bad) {
    std::vector<std::string> arguments{"elements", "--depth", "2", "-o", folder.path("p.ngc")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const auto run = test_support::run_clearcut(arguments);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    EXPECT_TRUE(folder.names().empty());
  }
}

TEST(ElementsCommand, RefusesBadJobsInOneLineAndWritesNothing) {
  const test_support::ScratchFolder folder;
  const auto job = folder.file("bad.toml", "[stock]\nx = [0, 9]\ny = [0, 9]\nz = [-1, 0]\n");
  const auto run = test_support::run_clearcut({"elements", job, "-o", folder.path("p.ngc")});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1);
  EXPECT_THAT(run.err, HasSubstr("has no elements"));
  EXPECT_THAT(folder.names(), ElementsAre("bad.toml"));
}

}  // namespace
}  // namespace clearcut
