#include "read/tools/tool_library.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "base/error.h"

namespace clearcut::read {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

ToolLibrary read(const std::string& text, const std::string& name, const ToolOptions& options = {}) {
  return read_tool_library_text(text, name, options);
}

int said(const ToolLibrary& library, Severity severity, const std::string& text) {
  const auto& items = library.diagnostics.items();
  return static_cast<int>(std::count_if(items.begin(), items.end(), [&](const Diagnostic& d) {
    return d.severity == severity && d.what.find(text) != std::string::npos;
  }));
}

std::string refusal(const std::string& text, const std::string& name) {
  try {
    read(text, name);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "not refused";
}

TEST(Tools, OurOwnFormat) {
  const ToolLibrary library = read(R"(
[[tool]]
number = 4
name = "rougher"
diameter = 10
teeth = 3
feed = 1200
plunge_feed = 300
spindle = 8000
stepdown = 3
[[tool]]
kind = "bullnose"
diameter = 6
corner_radius = 1
center_cutting = false
[[tool]]
number = 4
kind = "ball"
diameter = 3
)",
                                   "tools.toml");
  ASSERT_EQ(library.tools.size(), 3u);
  EXPECT_EQ(library.tools[0].tool.number, 4);
  ASSERT_EQ(library.tools[0].presets.size(), 1u);
  EXPECT_DOUBLE_EQ(library.tools[0].presets[0].cutting.feed->mm_per_min(), 1200);
  EXPECT_DOUBLE_EQ(*library.tools[0].presets[0].stepdown, 3);
  EXPECT_EQ(library.tools[1].tool.kind, ToolKind::kBullNoseEndMill);
  EXPECT_FALSE(library.tools[1].tool.center_cutting);
  EXPECT_DOUBLE_EQ(library.tools[2].tool.corner_radius, 1.5);
  EXPECT_EQ(library.tools[1].tool.number, 5);  // had none
  EXPECT_EQ(library.tools[2].tool.number, 6);  // its own was taken
  EXPECT_EQ(said(library, Severity::kNote, "got the number"), 2);
  EXPECT_EQ(said(library, Severity::kNote, "tool 2 of the list got the number 5: it had none"), 1);
}

TEST(Tools, LinuxcncTable) {
  const std::string table =
      "T1 P1 Z0.5 D6.0 ;6 mm end mill\n\n; only a comment\nT2 P2 X0 D+3.175 Z-1.25 ;ball nose\nT3 P3 D8 ;M8 "
      "tap\nt5 p5 d0 ;empty\n";
  const ToolLibrary library = read(table, "tool.tbl");
  ASSERT_EQ(library.tools.size(), 2u);
  EXPECT_DOUBLE_EQ(library.tools[0].tool.diameter, 6);
  EXPECT_EQ(library.tools[0].tool.name, "6 mm end mill");
  EXPECT_EQ(library.tools[1].tool.kind, ToolKind::kBallEndMill);
  EXPECT_EQ(said(library, Severity::kWarning, "millimetres assumed"), 1);
  EXPECT_EQ(said(library, Severity::kSkipped, "tap"), 1);
  EXPECT_EQ(said(library, Severity::kSkipped, "no usable diameter"), 1);
  EXPECT_DOUBLE_EQ(read(table, "tool.tbl", {"in"}).tools[0].tool.diameter, 6 * 25.4);
}

TEST(Tools, FusionLibraryInInches) {
  const ToolLibrary library = read(R"({"data": [
   {"type": "flat end mill", "unit": "inches", "description": "1/4 flat", "post-process": {"number": 7},
    "geometry": {"DC": 0.25, "NOF": 3, "LCF": 0.75, "RE": 0},
    "start-values": {"presets": [{"name": "Aluminium", "n": 18000, "v_f": 60, "v_f_plunge": 20, "v_f_ramp": 30,
      "stepdown": 0.1, "use-stepdown": true, "stepover": 0.1, "use-stepover": true, "tool-coolant": "flood"}]}},
   {"type": "chamfer mill", "unit": "inches", "description": "45", "geometry": {"DC": 0.5}},
   {"type": "holder", "unit": "inches"}]})",
                                   "library.json");
  ASSERT_EQ(library.tools.size(), 1u);
  const LibraryTool& tool = library.tools[0];
  EXPECT_EQ(tool.tool.number, 7);
  EXPECT_NEAR(tool.tool.diameter, 6.35, 1e-12);
  EXPECT_EQ(tool.tool.teeth, 3);
  EXPECT_NEAR(*tool.tool.flute_length, 19.05, 1e-12);
  ASSERT_EQ(tool.presets.size(), 1u);
  EXPECT_NEAR(tool.presets[0].cutting.feed->mm_per_min(), 1524, 1e-9);
  EXPECT_NEAR(*tool.presets[0].stepdown, 2.54, 1e-12);
  EXPECT_NEAR(*tool.presets[0].stepover, 0.4, 1e-12);
  EXPECT_EQ(tool.presets[0].cutting.coolant, Coolant::kFlood);
  EXPECT_EQ(said(library, Severity::kSkipped, "it states no angle of its flanks"), 1);
}

TEST(Tools, FusionNamesTheCoolant) {
  const auto coolant = [](const std::string& words) {
    const ToolLibrary library = read(R"({"data": [{"type": "flat end mill", "unit": "millimeters",
      "geometry": {"DC": 6}, "start-values": {"presets": [{"v_f": 60)" +
                                         words + "}]}}]}",
                                     "library.json");
    EXPECT_EQ(said(library, Severity::kWarning, "left off"), words.find("air") == std::string::npos ? 0 : 1);
    return library.tools.at(0).presets.at(0).cutting.coolant;
  };
  EXPECT_EQ(coolant(""), std::nullopt);
  EXPECT_EQ(coolant(R"(, "tool-coolant": "disabled")"), Coolant::kOff);
  EXPECT_EQ(coolant(R"(, "tool-coolant": "mist")"), Coolant::kMist);
  EXPECT_EQ(coolant(R"(, "tool-coolant": "flood and mist")"), Coolant::kBoth);
  EXPECT_EQ(coolant(R"(, "tool-coolant": "through tool")"), Coolant::kFlood);
  EXPECT_EQ(coolant(R"(, "tool-coolant": "air")"), Coolant::kOff);
}

TEST(Tools, FusionBringsConesTapersAndSlotCutters) {
  const ToolLibrary library = read(R"({"data": [
    {"type": "chamfer mill", "unit": "millimeters", "description": "C", "geometry": {"DC": 10, "TA": 45, "tip-diameter": 0.4}},
    {"type": "spot drill", "unit": "millimeters", "description": "S", "geometry": {"DC": 8, "SIG": 90}},
    {"type": "tapered mill", "unit": "inches", "description": "T", "geometry": {"DC": 0.125, "TA": 5, "LCF": 1}},
    {"type": "tapered mill", "unit": "millimeters", "description": "U", "geometry": {"DC": 3, "TA": 0.0872664626, "LCF": 20}},
    {"type": "tapered mill", "unit": "millimeters", "description": "B", "geometry": {"DC": 3, "TA": 5, "LCF": 20, "RE": 1.5}},
    {"type": "slot mill", "unit": "millimeters", "description": "K", "geometry": {"DC": 20, "LCF": 8, "shoulder-diameter": 10}},
    {"type": "slot mill", "unit": "millimeters", "description": "L", "geometry": {"DC": 20, "LCF": 8}}]})",
                                   "library.json");
  ASSERT_EQ(library.tools.size(), 5u);
  const auto tool = [&](std::size_t i) { return library.tools[i].tool; };
  EXPECT_NEAR(tool(0).tip_angle->degrees(), 90, 1e-9);
  EXPECT_NEAR(tool(0).tip_diameter, 0.4, 1e-12);
  EXPECT_NEAR(tool(1).tip_angle->degrees(), 90, 1e-9);
  EXPECT_EQ(tool(2).kind, ToolKind::kTapered);
  EXPECT_NEAR(radius_at(tool(2), 25.4), 1.5875 + 25.4 * std::tan(5 * std::acos(-1.0) / 180), 1e-9);
  EXPECT_NEAR(tool(3).tip_angle->degrees(), 10, 1e-6) << "radians of one side";
  EXPECT_EQ(said(library, Severity::kSkipped, "its tip is rounded"), 1);
  EXPECT_EQ(tool(4).kind, ToolKind::kTSlot);
  EXPECT_NEAR(radius_at(tool(4), 7.9), 10, 1e-12);
  EXPECT_NEAR(radius_at(tool(4), 8.1), 5, 1e-12);
  EXPECT_EQ(said(library, Severity::kSkipped, "states no neck"), 1);
}

TEST(Tools, OwnLibrariesStateTapersAndSlotCutters) {
  const std::string tapered = "[[tool]]\nkind = \"tapered\"\ndiameter = 3\n";
  const ToolLibrary library = read(tapered +
                                       "taper_angle = 5\nflute_length = 20\n[[tool]]\nkind = \"tslot\"\n"
                                       "diameter = 20\nflute_length = 8\nshank_diameter = 10\n",
                                   "t.toml");
  ASSERT_EQ(library.tools.size(), 2u);
  EXPECT_NEAR(library.tools[0].tool.tip_angle->degrees(), 10, 1e-9);
  EXPECT_NEAR(radius_at(library.tools[1].tool, 9), 5, 1e-12);
  EXPECT_THAT(refusal(tapered + "flute_length = 20\n", "t.toml"), HasSubstr("needs taper_angle"));
  EXPECT_THAT(refusal(tapered + "taper_angle = 5\n", "t.toml"), HasSubstr("flute_length"));
  EXPECT_THAT(refusal(tapered + "taper_angle = 50\nflute_length = 20\n", "t.toml"),
              HasSubstr("t.toml:4: taper_angle must lie between"));
  EXPECT_THAT(refusal("[[tool]]\ndiameter = 6\ntaper_angle = 5\n", "t.toml"), HasSubstr("not of this kind"));
  EXPECT_THAT(refusal("[[tool]]\nkind = \"tslot\"\ndiameter = 20\n", "t.toml"),
              HasSubstr("T-slot cutter needs"));
}

TEST(Tools, FreecadBitWithUnitsAndCommas) {
  const ToolLibrary library =
      read(R"({"version": 2, "name": "2mm", "shape": "endmill.fcstd", "shape-type": "Endmill",
    "parameter": {"Diameter": "2,00 mm", "CuttingEdgeHeight": "0.5 in", "Flutes": "3", "Chipload": "0.04 mm",
                  "SpindleDirection": "Reverse"}, "attribute": {}})",
           "2mm.fctb");
  ASSERT_EQ(library.tools.size(), 1u);
  EXPECT_DOUBLE_EQ(library.tools[0].tool.diameter, 2);
  EXPECT_DOUBLE_EQ(*library.tools[0].tool.flute_length, 12.7);
  EXPECT_EQ(library.tools[0].tool.teeth, 3);
  EXPECT_FALSE(library.tools[0].presets[0].cutting.spindle_clockwise);
  EXPECT_EQ(said(library, Severity::kNote, "Chipload is not used"), 1);
  EXPECT_THAT(
      refusal(R"({"name": "V", "shape": "v-bit.fcstd", "parameter": {"Diameter": "6 mm"}})", "v.fctb"),
      HasSubstr("tool 'V' was dropped: it states no angle"));
  const ToolLibrary bit = read(R"({"name": "V", "shape": "v-bit.fcstd", "parameter": {"Diameter": "6 mm",
    "CuttingEdgeAngle": "60,00 \u00b0", "TipDiameter": "0.10 mm"}})",
                               "v.fctb");
  ASSERT_EQ(bit.tools.size(), 1u);
  EXPECT_NEAR(bit.tools[0].tool.tip_angle->degrees(), 60, 1e-9);
  EXPECT_NEAR(bit.tools[0].tool.tip_diameter, 0.1, 1e-12);
  EXPECT_THAT(
      refusal(R"({"name": "P", "shape": "probe.fcstd", "parameter": {"Diameter": "6 mm"}})", "p.fctb"),
      HasSubstr("tool 'P' of shape 'PROBE' was dropped"));
}

TEST(Tools, FreecadLibraryFindsItsBits) {
  const fs::path folder = fs::path(::testing::TempDir()) / ("clearcut_tools_" + std::to_string(getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder / "Bit");
  fs::create_directories(folder / "Library");
  std::ofstream(folder / "Bit" / "a.fctb")
      << R"({"name": "a", "shape": "ballend.fcstd", "parameter": {"Diameter": "3 mm"}})";
  std::ofstream(folder / "Library" / "l.fctl")
      << R"({"label": "l", "version": 1, "tools": [{"nr": 9, "path": "a.fctb"}, {"nr": 2, "path": "gone.fctb"}]})";
  const ToolLibrary library = read_tool_library(folder / "Library" / "l.fctl", {});
  ASSERT_EQ(library.tools.size(), 1u);
  EXPECT_EQ(library.tools[0].tool.number, 9);
  EXPECT_EQ(library.tools[0].tool.kind, ToolKind::kBallEndMill);
  EXPECT_THAT(library.files, ElementsAre(EndsWith("a.fctb")));
  EXPECT_EQ(said(library, Severity::kSkipped, "'gone.fctb' was not found"), 1);
  fs::remove_all(folder);
}

TEST(Tools, BadLibrariesGiveOneLine) {
  EXPECT_THAT(refusal("[[tool]]\ndiameter = 6\nteth = 3\n", "t.toml"),
              StartsWith("t.toml:3: unknown key 'teth' in [[tool]]; did you mean 'teeth'?"));
  EXPECT_THAT(refusal("[[tool]]\ndiameter = -6\n", "t.toml"),
              StartsWith("t.toml:2: diameter must be above 0"));
  EXPECT_THAT(refusal("[[tool]]\nnumber = 1\n", "t.toml"), HasSubstr("diameter is missing"));
  EXPECT_THAT(refusal("[[tool]]\nkind = \"saw\"\ndiameter = 6\n", "t.toml"),
              HasSubstr("t.toml:2: kind 'saw' is unknown; use one of endmill"));
  EXPECT_THAT(refusal("[[tool]]\ndiameter = \n", "t.toml"), StartsWith("t.toml:2: not TOML"));
  EXPECT_THAT(refusal("", "t.toml"), HasSubstr("no usable tool"));
  EXPECT_THAT(refusal("hello world", "t.tbl"), StartsWith("t.tbl:1: 'hello world' is no word like T1"));
  EXPECT_THAT(refusal("{}", "t.json"), HasSubstr("not a Fusion tool library"));
  EXPECT_THAT(refusal("[]", "t.fctb"), HasSubstr("not a FreeCAD tool bit"));
  EXPECT_THAT(refusal("{\"tools\": 3}", "t.fctl"), HasSubstr("not a FreeCAD tool library"));
  EXPECT_THAT(refusal("x", "t.xlsx"), HasSubstr("unknown kind of tool library"));
}

}  // namespace
}  // namespace clearcut::read
