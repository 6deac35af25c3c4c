// A part keeps its program on the way through another format.
#include <gtest/gtest.h>

#include "base/files/file.h"
#include "pipeline/run.h"
#include "post/part/stepnc_writer.h"
#include "read/read_part.h"
#include "resolve/prepare.h"
#include "support/data.h"
#include "support/drawings.h"
#include "support/programs.h"

namespace clearcut {
namespace {

namespace fs = std::filesystem;

struct Drawing {
  std::string file;
  std::string text;
  const char* tool;
};

Drawing drawing(const fs::path& file, const char* tool) {
  return {file.filename().string(), read_file(file.string()), tool};
}

std::vector<Drawing> drawings() {
  std::vector<Drawing> all{drawing(fs::path(CLEARCUT_SOURCE_DIR) / "examples/bracket.dxf", "endmill:6"),
                           drawing(fs::path(CLEARCUT_SOURCE_DIR) / "examples/bracket.svg", "endmill:6"),
                           {"bulges.dxf", test_support::bulges_dxf(), "endmill:20"},
                           {"necks.dxf", test_support::narrow_necks_dxf(), "endmill:2"}};
  if (const auto data = test_support::data_folder()) {
    all.push_back(drawing(*data / "drawings/bulge-polylines.dxf", "endmill:20"));
    all.push_back(drawing(*data / "drawings/vslot-narrow-necks.dxf", "endmill:2"));
    all.push_back(drawing(*data / "drawings/gear-endpoint-gaps.dxf", "endmill:2"));
  }
  return all;
}

/// The program without its header, whose first lines name the part's file and format.
std::string program_of(const Part& part, const resolve::PlanOptions& options) {
  const std::string program = pipeline::plan_part(part, options).program;
  return program.substr(program.find("G21"));
}

TEST(Convert, ADrawingAsStepNcHasTheSameProgram) {
  for (const Drawing& drawing : drawings()) {
    read::ReadOptions reading;
    reading.depth_if_missing = 2;
    const Part drawn = read::read_part_text(drawing.text, drawing.file, reading);
    resolve::PlanOptions options;
    options.tools = {resolve::parse_tool(drawing.tool)};
    const std::string wanted = program_of(drawn, options);
    const Part stepnc =
        read::read_part_text(post::write_stepnc(resolve::with_tools(drawn, options)), "again.p21", {});
    EXPECT_EQ(test_support::first_difference(program_of(stepnc, options), wanted), "") << drawing.file;
  }
}

}  // namespace
}  // namespace clearcut
