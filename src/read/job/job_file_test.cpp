#include "read/job/job_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "read/job/machine_file.h"
#include "read/job/read_part.h"

namespace clearcut::read {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A folder with two pockets, "a" and "b", beside the job.
class Job : public ::testing::Test {
 protected:
  /// Tests run side by side, each in a process and a folder of its own.
  Job() : folder_(fs::path(::testing::TempDir()) / ("clearcut_job_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    write("plate.json",
          R"({"units": "mm", "pockets": [{"name": "a", "outer": [[0,0],[30,0],[30,20],[0,20]], "depth": 4},
                           {"name": "b", "outer": [[50,0],[80,0],[80,20],[50,20]], "depth": 8}]})");
  }
  ~Job() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  std::string job_path() const { return (folder_ / "job.toml").string(); }
  JobFile job(const std::string& text) const { return read_job_text(text, job_path()); }
  Part part(const std::string& text) const { return part_of_job(job(text), {}); }
  std::string refusal(const std::string& text) const {
    try {
      part(text);
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      return std::string(error.what()).substr(folder_.string().size() + 1);
    }
    return "not refused";
  }
  fs::path folder_;
};

const std::string kPart = "[part]\nfile = \"plate.json\"\n";
const std::string kTools =
    "[[tool]]\nnumber = 1\ndiameter = 6\nfeed = 800\nspindle = 9000\n[[tool]]\nnumber = 2\ndiameter = 3\n";

TEST_F(Job, TheShortestJobIsThePart) {
  const Part read = part(kPart);
  EXPECT_EQ(read.workplan.size(), 2u);
  EXPECT_TRUE(read.tools.empty());
  EXPECT_FALSE(read.stock);
}

TEST_F(Job, StockByRangesOrMargin) {
  const Part ranges = part(kPart + "[stock]\nx = [-5, 90]\ny = [-5, 30]\nz = [-20, 0]\n");
  EXPECT_EQ(ranges.stock->plan.max, (Vec2{90, 30}));
  EXPECT_EQ(ranges.stock->z_bottom, -20);
  const Part margin = part(kPart + "[stock]\nmargin = 2\nz = [-20, 0]\n");
  EXPECT_EQ(margin.stock->plan.min, (Vec2{-2, -2}));
  EXPECT_EQ(margin.stock->plan.max, (Vec2{82, 22}));
}

TEST_F(Job, PlanThenOperationsThenTheirPresetsBelow) {
  const Part read = part(
      kPart + kTools +
      "[plan]\nstepdown = 2\nallowance = 0.2\nstepover = 0.4\nentry = \"ramp\"\nspindle = 12000\n"
      "[[operation]]\nfeature = \"B\"\ntool = 2\nstepover = \"1.5mm\"\nfeed = 400\nstrategy = \"zigzag\"\n");
  ASSERT_EQ(read.tools.size(), 2u);
  const Operation &a = read.workplan[0].operation, &b = read.workplan[1].operation;
  EXPECT_EQ(read.tools[static_cast<std::size_t>(a.tool)].number, 1);
  EXPECT_EQ(read.tools[static_cast<std::size_t>(b.tool)].number, 2);
  EXPECT_DOUBLE_EQ(a.cutting.feed->mm_per_min(), 800);  // the tool's
  EXPECT_DOUBLE_EQ(b.cutting.feed->mm_per_min(), 400);
  EXPECT_DOUBLE_EQ(*a.cutting.spindle_rpm, 12000);  // the plan goes before the tool
  EXPECT_DOUBLE_EQ(*a.stepover, 0.4);
  EXPECT_DOUBLE_EQ(*b.stepover, 0.5);
  EXPECT_EQ(b.strategy_hint, "zigzag");
  EXPECT_EQ(*a.entry, EntryKind::kRamp);
  EXPECT_DOUBLE_EQ(b.allowance_side, 0.2);
}

TEST_F(Job, ToolsThatNobodyNamesFollowFromSizeAndKind) {
  write("parts.json",
        R"({"units": "mm", "pockets": [{"name": "wide", "outer": [[0,0],[30,0],[30,20],[0,20]], "depth": 4},
                         {"name": "narrow", "outer": [[50,0],[80,0],[80,7],[50,7]], "depth": 4}]})");
  const std::string tools =
      "[[tool]]\nnumber = 1\nkind = \"drill\"\ndiameter = 5\n"
      "[[tool]]\nnumber = 2\nkind = \"vbit\"\ndiameter = 10\ntip_angle = 90\n"
      "[[tool]]\nnumber = 3\ndiameter = 8\nfeed = 900\n[[tool]]\nnumber = 4\ndiameter = 4\nfeed = 500\n";
  const Part chosen = part("[part]\nfile = \"parts.json\"\n" + tools);
  EXPECT_EQ(tool_of(chosen, chosen.workplan[0]).number, 3);
  EXPECT_EQ(tool_of(chosen, chosen.workplan[1]).number, 4);
  EXPECT_EQ(chosen.workplan[1].operation.cutting.feed, MmPerMin::of(500)) << "its own tool's";

  const Part named = part("[part]\nfile = \"parts.json\"\n" + tools +
                          "[[operation]]\nfeature = \"wide\"\ntool = 4\n[plan]\nstepdown = 1\n");
  EXPECT_EQ(tool_of(named, named.workplan[0]).number, 4);
}

TEST_F(Job, FinishingIsAStepOfItsOwnAndLeavesNothing) {
  const Part read =
      part(kPart + kTools +
           "[plan]\nallowance = 0.3\n[[operation]]\nfeature = \"*\"\nkind = \"finishing\"\ntool = 2\n");
  ASSERT_EQ(read.workplan.size(), 4u);
  EXPECT_DOUBLE_EQ(read.workplan[0].operation.allowance_side, 0.3);
  EXPECT_EQ(read.workplan[2].operation.kind, OperationKind::kFinishing);
  EXPECT_DOUBLE_EQ(read.workplan[2].operation.allowance_side, 0);
  EXPECT_EQ(read.workplan[2].name, "a_finish");
}

TEST_F(Job, SkippedFeaturesAreReported) {
  const Part read = part(kPart + "[[operation]]\nfeature = \"a\"\nskip = true\n");
  ASSERT_EQ(read.workplan.size(), 1u);
  EXPECT_EQ(read.diagnostics.items().back().condition, "left-out") << "the verdict is not clean in silence";
}

TEST_F(Job, AStatedSequenceIsTheOrderOfWork) {
  const Part read = part(kPart + "[plan]\nsequence = [\"b\", \"a\"]\n");
  ASSERT_EQ(read.workplan.size(), 2u);
  EXPECT_EQ(feature_of(read, read.workplan[0]).name, "b");
  EXPECT_FALSE(read.order_free);
  EXPECT_EQ(feature_of(part(kPart), part(kPart).workplan[0]).name, "a");
  try {
    part(kPart + "[plan]\nsequence = [\"none\"]\n");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("sequence: no feature is called 'none'"), std::string::npos);
  }
}

TEST_F(Job, MachineToolsLibraryAndOutput) {
  write("mill.toml", "name = \"mill\"\nrapid = 3000\ntravel = {x = [0, 300], y = [0, 200], z = [-50, 10]}\n");
  write("tools.toml", kTools);
  const JobFile read = job(
      kPart +
      "[machine]\nfile = \"mill.toml\"\nacceleration = 250\n[tools]\nlibrary = \"tools.toml\"\nuse = [2]\n"
      "[plan]\nobjective = \"turns\"\nseed = 7\naccept = [\"g55\"]\nengagement = 80\n[output]\nprogram = "
      "\"out.ngc\"\npost = "
      "\"grbl\"\n");
  EXPECT_EQ(read.machine.name, "mill");
  EXPECT_DOUBLE_EQ(read.machine.rapid.mm_per_min(), 3000);
  EXPECT_DOUBLE_EQ(read.machine.acceleration, 250);
  EXPECT_DOUBLE_EQ((*read.machine.travel)[2][0], -50);
  EXPECT_EQ(read.whole.post.dialect, "grbl");
  EXPECT_EQ(read.whole.seed, 7u);
  EXPECT_EQ(read.whole.accept, std::vector<std::string>{"g55"});
  const Part with_tools = part_of_job(read, {});
  ASSERT_EQ(with_tools.tools.size(), 1u);
  EXPECT_EQ(with_tools.tools[0].number, 2);
}

TEST_F(Job, TabsHaveShapesSpacingsAndPlaces) {
  const JobFile spaced = job(kPart + "[plan]\ntab_shape = \"triangular\"\ntab_spacing = 80\ntab_width = 3\n");
  EXPECT_EQ(spaced.whole.tabs.shape, TabShape::kTriangular);
  EXPECT_EQ(spaced.whole.tabs.spacing, 80);
  EXPECT_EQ(spaced.whole.tabs.width, 3);
  const JobFile chosen = job(kPart + "[plan]\ntab_at = [[1, -2.5], [40, 0]]\n");
  EXPECT_EQ(chosen.whole.tabs.shape, TabShape::kSquare);
  EXPECT_EQ(chosen.whole.tabs.at, (std::vector<Vec2>{{1, -2.5}, {40, 0}}));
  EXPECT_THAT(refusal(kPart + "[plan]\ntab_at = [1, 2]\n"), HasSubstr("is not a point"));
  EXPECT_THAT(refusal(kPart + "[plan]\ntab_shape = \"round\"\n"), HasSubstr("triangular"));
}

TEST_F(Job, MistakesGiveOneLineWithFileAndLine) {
  EXPECT_THAT(refusal(""), StartsWith("job.toml:1: [part] is missing"));
  EXPECT_THAT(refusal("[part]\n"), StartsWith("job.toml:1: [part]: file is missing"));
  EXPECT_THAT(refusal("[part]\nfile = 3\n"), StartsWith("job.toml:2: file must be text"));
  EXPECT_THAT(refusal("[part\n"), StartsWith("job.toml:1: not TOML"));
  EXPECT_THAT(refusal("[part]\nfile = \"gone.dxf\"\n"), HasSubstr("no such file"));
  EXPECT_THAT(refusal("[part]\nfile = \"job.toml\"\n"), HasSubstr("cannot be a job"));
  EXPECT_THAT(refusal(kPart + "[plan]\nstepdwon = 2\n"),
              StartsWith("job.toml:4: unknown key 'stepdwon' in [plan]; did you mean 'stepdown'?"));
  EXPECT_THAT(refusal(kPart + "[plan]\nstepdown = 0\n"), StartsWith("job.toml:4: stepdown: must be above 0"));
  EXPECT_THAT(refusal(kPart + "[plan]\nentry = \"dive\"\n"),
              HasSubstr("use one of helix, ramp, zigzag, plunge"));
  EXPECT_THAT(refusal(kPart + "[plans]\n"), HasSubstr("unknown key 'plans'; did you mean 'plan'?"));
  EXPECT_THAT(refusal(kPart + "[[operation]]\nfeature = \"c\"\n"),
              StartsWith("job.toml:3: no feature is called 'c'"));
  EXPECT_THAT(refusal(kPart + "[[operation]]\ntool = 9\n"), StartsWith("job.toml:3: tool 9 is unknown"));
  EXPECT_THAT(refusal(kPart + "[[operation]]\nfeature = \"a\"\ntabs = 3\n"),
              StartsWith("job.toml:5: tabs holds for all profiles and belongs in [plan]"));
  EXPECT_THAT(refusal(kPart + kTools + "[plan]\nstepover = \"wide\"\n"),
              HasSubstr("stepover 'wide' is unknown"));
  EXPECT_THAT(refusal(kPart + "[stock]\nx = [1, 2]\n"), HasSubstr("z is missing"));
  EXPECT_THAT(refusal(kPart + "[stock]\nz = [2, 1]\n"), StartsWith("job.toml:4: z must be [low, high]"));
  EXPECT_THAT(refusal(kPart + "[[operation]]\nskip = true\n"), HasSubstr("nothing is left to machine"));
  EXPECT_THAT(refusal(kPart + "made = 2020-01-01\n"), HasSubstr("job.toml:3: dates"));
}

/// A pointed tip, which engraves where nobody chooses, leaves no tabs in a line through the material.
TEST_F(Job, LinesThroughTheMaterialAreCutByAMillWhereTabsAreAskedFor) {
  write("lines.json",
        R"({"units": "mm", "stock": {"x": [0, 60], "y": [0, 40], "z": [-4, 0]}, "pockets": [
          {"name": "cut", "kind": "engraving", "line": [[5,5],[55,5],[55,35],[5,35]], "depth": 4},
          {"name": "mark", "kind": "engraving", "line": [[15,15],[45,15],[45,25]], "closed": false, "depth": 0.5}]})");
  const std::string text =
      "[part]\nfile = \"lines.json\"\n[[tool]]\nnumber = 1\nkind = \"vbit\"\ndiameter = 6\ntip_angle = 60\n"
      "[[tool]]\nnumber = 2\ndiameter = 3\n";
  const auto tools = [&](const std::string& plan) {
    const Part read = part(text + plan);
    std::vector<int> numbers;
    for (const Workingstep& step : read.workplan) numbers.push_back(tool_of(read, step).number);
    return numbers;
  };
  EXPECT_EQ(tools(""), (std::vector<int>{1, 1}));
  EXPECT_EQ(tools("[plan]\ntabs = 2\n"), (std::vector<int>{2, 1}));
}

TEST_F(Job, TheWrittenJobIsReadAsItStands) {
  Part plate = read_part(folder_ / "plate.json", {});
  plate.features[0].name = "quote\"d";
  plate.tools = {Tool{3, "T3", ToolKind::kEndMill, 6, 0, 2, std::nullopt, true}};
  const std::string text = job_text(plate, "plate.json");
  EXPECT_THAT(text, HasSubstr("\"quote\\\"d\""));
  const Part again = part(text);
  EXPECT_EQ(again.features.size(), 2u);
  ASSERT_EQ(again.tools.size(), 1u);
  EXPECT_EQ(again.tools[0].number, 3);
}

Tool tool_of(int number, ToolKind kind, double diameter) {
  Tool tool;
  tool.number = number;
  tool.name = "T" + std::to_string(number);
  tool.kind = kind;
  tool.diameter = diameter;
  return tool;
}

TEST_F(Job, TheWrittenJobHoldsAllOfEachTool) {
  Tool mill = tool_of(1, ToolKind::kEndMill, 6), tap = tool_of(2, ToolKind::kTap, 5);
  mill.teeth = 3;
  mill.flute_length = 12;
  mill.max_spindle_rpm = 9000;
  mill.stickout = 30;
  mill.holder_diameter = 40;
  mill.shank_diameter = 8;
  mill.high_speed_steel = true;
  mill.coated = true;
  tap.pitch = 0.8;
  tap.left_hand = tap.floating = true;
  Tool bit = tool_of(3, ToolKind::kVBit, 8), rows = tool_of(4, ToolKind::kThreadMill, 10);
  bit.tip_angle = Radians::of_degrees(60);
  bit.tip_diameter = 0.2;
  rows.pitch = 1.5;
  rows.flute_length = 18;
  rows.high_speed_steel = false;
  Part plate = read_part(folder_ / "plate.json", {});
  plate.tools = {mill, tap, bit, rows};
  const Part again = part(job_text(plate, "plate.json"));
  ASSERT_EQ(again.tools.size(), plate.tools.size());
  for (std::size_t i = 0; i < plate.tools.size(); ++i) {
    const Tool &wrote = plate.tools[i], &read = again.tools[i];
    EXPECT_EQ(read.kind, wrote.kind);
    EXPECT_EQ(read.diameter, wrote.diameter);
    EXPECT_EQ(read.teeth, wrote.teeth);
    EXPECT_EQ(read.flute_length, wrote.flute_length);
    EXPECT_EQ(read.max_spindle_rpm, wrote.max_spindle_rpm);
    EXPECT_EQ(read.stickout, wrote.stickout);
    EXPECT_EQ(read.holder_diameter, wrote.holder_diameter);
    EXPECT_EQ(read.shank_diameter, wrote.shank_diameter);
    EXPECT_EQ(read.high_speed_steel, wrote.high_speed_steel);
    EXPECT_EQ(read.coated, wrote.coated);
    EXPECT_EQ(read.pitch, wrote.pitch);
    EXPECT_EQ(read.left_hand, wrote.left_hand);
    EXPECT_EQ(read.floating, wrote.floating);
    ASSERT_EQ(read.tip_angle.has_value(), wrote.tip_angle.has_value());
    if (read.tip_angle) {
      EXPECT_NEAR(read.tip_angle->degrees(), wrote.tip_angle->degrees(), 1e-6);
    }
    EXPECT_EQ(read.tip_diameter, wrote.tip_diameter);
  }
}

/// Every commented line of a written job is valid when its # is taken away.
TEST_F(Job, TheKeysInTheCommentsExist) {
  write("tools.toml", kTools);
  write("mill.toml", "rapid = 3000\n");
  std::string text = job_text(read_part(folder_ / "plate.json", {}), "plate.json");
  std::string opened;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = text.find('\n', start);
    std::string line = text.substr(start, end - start);
    const bool is_key =
        line.rfind("# ", 0) == 0 && (line.find(" = ") != std::string::npos || line.find("[") == 2);
    const bool example = line.find("Lines after") != std::string::npos ||
                         line.find("Features found") != std::string::npos ||
                         line.find("POCKET*\"\n") != std::string::npos;
    if (is_key && !example) line = line.substr(2);
    opened += line + "\n";
    start = end + 1;
  }
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (std::size_t at; (at = opened.find(from)) != std::string::npos;) opened.replace(at, from.size(), to);
  };
  replace("preset = \"Aluminium\"", "");
  replace("feature = \"POCKET*\"", "feature = \"a\"");
  const JobFile read = job(opened);
  EXPECT_EQ(read.read.layers, std::vector<std::string>{"POCKET*"});
  EXPECT_EQ(read.operations.size(), 1u);
  EXPECT_TRUE(read.machine.travel);
}

TEST(MachineFile, TravelIsOfTheMachineWhereTheWorkLiesInIt) {
  std::string text = "[travel]\nx = [0, 300]\ny = [0, 200]\nz = [-80, 0]\n";
  EXPECT_DOUBLE_EQ(home_z(read_machine_text(text, "mill.toml")), 0);
  text += "[places]\nstart = [0, 0, 0]\ng28 = [0, 0, 0]\ng30 = [0, 0, 0]\n";
  for (int g = 54; g < 60; ++g) text += "g" + std::to_string(g) + " = [10, 20, -60]\n";
  const Machine machine = read_machine_text(text, "mill.toml");
  EXPECT_DOUBLE_EQ(home_z(machine), 60);
  EXPECT_DOUBLE_EQ(work_zero(machine, 1), 20);
  EXPECT_EQ(machine.places->stated_origins, 6);
  EXPECT_EQ(read_machine_text(text + "\"g59.1\" = [1, 2, 3]\n", "mill.toml").places->stated_origins, 7);
  EXPECT_THROW(read_machine_text(text + "\"g59.2\" = [1, 2, 3]\n", "mill.toml"), InputError);
}

/// Offsets that the machine file does not state are those of LinuxCNC's file of parameters.
TEST_F(Job, PlacesComeFromTheFileOfParameters) {
  std::string values;
  for (const int first : {5161, 5181, 5221, 5241, 5261, 5281, 5301, 5321})
    for (int axis = 0; axis < 3; ++axis)
      values += std::to_string(first + axis) + "\t" + std::to_string(first - 5000 + axis) + ".500000\n";
  write("linuxcnc.var", "5210\t0\n" + values);
  const std::string machine = (folder_ / "mill.toml").string();
  const std::string text = "[places]\nstart = [0, 0, 0]\ng55 = [1, 2, 3]\nparameters = \"linuxcnc.var\"\n";
  const Machine read = read_machine_text(text, machine);
  ASSERT_TRUE(read.places);
  EXPECT_EQ(read.places->reference[0], 161.5);
  EXPECT_EQ(read.places->origins[0][2], 223.5);
  EXPECT_EQ(read.places->origins[1][1], 2) << "what is stated comes first";
  EXPECT_EQ(read.places->stated_origins, 6);
  write("linuxcnc.var", "5210\t1\n" + values);
  EXPECT_THROW(read_machine_text(text, machine), InputError) << "a shift by G92";
  write("linuxcnc.var", values + "5230\t0\n5250\t30\n");
  EXPECT_THROW(read_machine_text(text, machine), InputError) << "G55 turned by 30 degrees";
  write("linuxcnc.var", "5221\n");
  EXPECT_THROW(read_machine_text(text, machine), InputError);
}

TEST_F(Job, CopiesAreKeysOfThePlan) {
  const JobFile read = job(kPart + "[plan]\ncopies = \"3x2\"\ngap = 4\n");
  EXPECT_EQ(read.whole.copies.grid, "3x2");
  EXPECT_EQ(read.whole.copies.gap, 4);
  EXPECT_FALSE(read.whole.copies.sheet);
  const JobFile sheet = job(kPart + "[plan]\nnest = \"600x400\"\nnest_with = [\"lid.dxf:4\"]\n");
  EXPECT_THAT(sheet.whole.copies.with, testing::ElementsAre((folder_ / "lid.dxf:4").string()));
  EXPECT_THAT(refusal(kPart + "[plan]\nnest_with = [\"lid.dxf:0\"]\n"),
              HasSubstr("a file and a number of parts"));
  EXPECT_THAT(refusal(kPart + "[plan]\ncopies = \"3\"\n"), HasSubstr("columns and rows"));
  EXPECT_THAT(refusal(kPart + "[plan]\nnest = \"600\"\n"), HasSubstr("the width and height of a sheet"));
}

TEST(MachineFile, UnknownKeysAreRefused) {
  EXPECT_THROW(read_machine_text("accelaration = 3\n", "mill.toml"), InputError);
  EXPECT_THROW(read_machine_text("travel = {x = [0, 1]}\n", "mill.toml"), InputError);
  EXPECT_DOUBLE_EQ(read_machine_text("max_feed = 900\n", "mill.toml").max_feed->mm_per_min(), 900);
}

}  // namespace
}  // namespace clearcut::read
