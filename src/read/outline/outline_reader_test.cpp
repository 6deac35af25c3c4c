#include "read/outline/outline_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/units.h"
#include "read/common/data_value.h"

namespace clearcut::read {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

Part read(const std::string& text) {
  return read_outline_json(text, "plate.json", Tolerances{});
}

std::string message_of(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(OutlineJson, SquareIsOnePocketWithOneWorkingstep) {
  const Part part = read(R"({"name": "square", "units": "mm",
    "outer": [[0, 0, 0], [50, 0, 0], [50, 50, 0], [0, 50, 0]], "islands": [], "top": 1, "depth": 2})");
  EXPECT_EQ(part.name, "square");
  EXPECT_FALSE(part.stock);
  EXPECT_TRUE(part.tools.empty());
  ASSERT_EQ(part.features.size(), 1u);
  const Feature& pocket = part.features[0];
  EXPECT_EQ(pocket.kind, FeatureKind::kClosedPocket);
  EXPECT_DOUBLE_EQ(area(pocket.target), 2500);
  EXPECT_DOUBLE_EQ(pocket.top_z, 1);
  EXPECT_DOUBLE_EQ(pocket.floor_z, -1);
  ASSERT_EQ(part.workplan.size(), 1u);
  EXPECT_EQ(part.workplan[0].feature, 0);
}

TEST(OutlineJson, BulgesAreArcsAndIslandsAreCutOut) {
  const Part part =
      read(R"({"outer": [[-10, 0, 1], [10, 0, 1]], "islands": [[[-2, 0, -1], [2, 0, -1]]], "depth": 1})");
  EXPECT_NEAR(area(part.features[0].target), kPi * (100 - 4), 1e-9);
}

TEST(OutlineJson, AnIslandInAnIslandIsAPocketAgain) {
  const Part part = read(R"({"outer": [[0,0],[90,0],[90,90],[0,90]], "depth": 1,
    "islands": [[[10,10],[80,10],[80,80],[10,80]], [[20,20],[70,20],[70,70],[20,70]]]})");
  EXPECT_EQ(part.features[0].target.size(), 2u);
  EXPECT_DOUBLE_EQ(area(part.features[0].target), 8100 - 4900 + 2500);
}

TEST(OutlineJson, InchesBecomeMillimetres) {
  const Part part = read(R"({"units": "in", "outer": [[0,0],[1,0],[1,1],[0,1]], "depth": 0.5, "top": 1})");
  EXPECT_DOUBLE_EQ(area(part.features[0].target), 25.4 * 25.4);
  EXPECT_DOUBLE_EQ(part.features[0].top_z, 25.4);
  EXPECT_DOUBLE_EQ(part.features[0].floor_z, 12.7);
}

TEST(OutlineJson, ListOfPocketsGivesOneFeatureEachWithUniqueNames) {
  const Part part = read(R"({"units": "mm", "pockets": [
    {"outer": [[0,0],[9,0],[9,9],[0,9]], "depth": 1, "name": "a"},
    {"outer": [[20,0],[29,0],[29,9],[20,9]], "depth": 2, "name": "a", "slope_rad": 0.1},
    {"outer": [[40,0],[49,0],[49,9],[40,9]], "depth": 3}]})");
  ASSERT_EQ(part.features.size(), 3u);
  EXPECT_EQ(part.features[1].name, "a_2");
  EXPECT_EQ(part.features[2].name, "pocket3");
  EXPECT_DOUBLE_EQ(part.features[1].wall_slope.radians(), 0.1);
  EXPECT_EQ(part.workplan.size(), 3u);
}

TEST(OutlineJson, UnknownKeysAreNotedNotRefused) {
  const Part part =
      read(R"({"units": "mm", "outer": [[0,0],[9,0],[9,9],[0,9]], "depth": 1, "colour": "red"})");
  ASSERT_EQ(part.diagnostics.items().size(), 1u);
  EXPECT_EQ(part.diagnostics.items()[0].severity, Severity::kNote);
  EXPECT_THAT(part.diagnostics.items()[0].what, HasSubstr("colour"));
}

TEST(OutlineJson, BadFilesGiveOneLineWithFileAndLine) {
  const struct {
    const char* text;
    const char* place;
    const char* what;
  } cases[] = {
      {"", "plate.json:1: ", "not JSON"},
      {"{\n\"outer\": [[0,0],\n[9,0],,\n", "plate.json:3: ", "not JSON"},
      {"[1]", "plate.json:1: ", "must be an object"},
      {"{\"depth\": 1}", "plate.json:1: ", "\"outer\" is missing"},
      {"{\n\"outer\": [[0,0],[9,0],[9,9]]}", "plate.json:1: ", "\"depth\" is missing"},
      {"{\"depth\": 1,\n\"outer\": [[0,0],\n[9]\n,[9,9]]}", "plate.json:3: ", "a vertex must be"},
      {"{\"depth\": 1,\n\"outer\": [[0,0],\n[9,\"x\"],[9,9]]}", "plate.json:3: ", "y must be a number"},
      {"{\"units\": \"mm\", \"depth\":\n0\n, \"outer\": [[0,0],[9,0],[9,9]]}",
       "plate.json:2: ", "must be above 0"},
      {"{\"depth\": 0.0005, \"outer\": [[0,0],[9,0],[9,9]]}",
       "plate.json:1: ", "above 0.001: is the unit right?"},
      {"{\"depth\": 1, \"units\": \"furlong\", \"outer\": [[0,0],[9,0],[9,9]]}",
       "plate.json:1: ", "unknown unit"},
      {"{\"depth\": 1, \"outer\": [[0,0],[9,0],[9,1e300]]}", "plate.json: ", "beyond 1000 m"},
      {"{\"depth\": 1, \"outer\": [[0,0],[9,0],[9,1e999]]}", "plate.json:1: ", "not JSON"},
      {"{\"depth\": 1, \"outer\": [[0,0],[9,0],[0,0]]}", "plate.json: ", "no outline encloses"},
      {"{\"pockets\": []}", "plate.json:1: ", "at least one"},
  };
  for (const auto& bad : cases) {
    const std::string message = message_of(bad.text);
    EXPECT_THAT(message, StartsWith(bad.place)) << bad.text;
    EXPECT_THAT(message, HasSubstr(bad.what)) << bad.text;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
}

TEST(OutlineJson, DeepNestingIsRefusedNotFollowed) {
  EXPECT_THAT(message_of(std::string(100000, '[')), HasSubstr("nested deeper"));
}

TEST(DataValue, TomlKeysOfVeryManyPartsAreRefusedNotFollowed) {
  std::string key = "a", quoted = "\"a\"";
  for (int i = 0; i < 1000000; ++i) key += ".a", quoted += " . 'a'";
  for (const std::string& text : {key + " = 1", "[" + key + "]", "# note\n" + quoted + " = 1"}) {
    try {
      parse_toml(text, "x.toml");
      FAIL() << text.substr(0, 20);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("a key of more than 64 parts"));
    }
  }
  std::string numbers = "a = [1.5";
  for (int i = 0; i < 1000; ++i) numbers += ", 2.5";
  EXPECT_EQ(
      parse_toml(numbers + "]\nb = \"" + std::string(100, '.') + "\"", "x.toml").find("a")->items.size(),
      1001u);
}

TEST(DataValue, KnowsTheLineOfEveryValue) {
  const DataValue root = parse_json("{\n\"a\": 1\n,\n\"b\": [2,\n3]}", "x");
  EXPECT_EQ(root.find("a")->line, 2);
  EXPECT_EQ(root.find("b")->line, 4);
  EXPECT_EQ(root.find("b")->items[1].line, 5);
}

}  // namespace
}  // namespace clearcut::read
