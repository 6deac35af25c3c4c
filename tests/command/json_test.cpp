// What programs that run the command read: the JSON of compare, tools and info.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "support/command.h"

namespace clearcut {
namespace {

using test_support::run_clearcut;
using test_support::ScratchFolder;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

const std::string kExamples = std::string(CLEARCUT_SOURCE_DIR) + "/examples/";
const std::string kSquare = R"({"name": "square", "units": "mm",
  "outer": [[0, 0, 0], [50, 0, 0], [50, 50, 0], [0, 50, 0]], "islands": [], "top": 0, "depth": 2})";

TEST(Json, ComparesStrategies) {
  const ScratchFolder folder;
  const auto part = folder.file("square.json", kSquare);
  const auto result = run_clearcut({"compare", part, "--tool", "endmill:16", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json.at("schema"), "clearcut-compare-1");
  EXPECT_EQ(json.at("part"), "square");
  int fastest = 0;
  for (const auto& one : json.at("strategies")) {
    EXPECT_FALSE(one.at("strategy").get<std::string>().empty());
    if (!one.at("planned").get<bool>()) continue;
    fastest += one.at("fastest").get<bool>() ? 1 : 0;
    for (const char* field : {"feed_mm", "lower_bound_mm", "time_s", "published_time_s", "uncut_thickness_mm",
                              "uncut_mm2", "gouge_mm", "engagement_max_deg", "engagement_mean_deg"})
      EXPECT_TRUE(one.at(field).is_number()) << field;
  }
  EXPECT_EQ(fastest, 1);
}

TEST(Json, ComparesTools) {
  const ScratchFolder folder;
  const auto part = folder.file("square.json", kSquare);
  const auto result = run_clearcut({"tools", part, "--tool", "endmill:60", "--tool", "endmill:12", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json.at("schema"), "clearcut-tools-1");
  ASSERT_EQ(json.at("tools").size(), 2U);
  EXPECT_EQ(json["tools"][0].at("tool").at("diameter_mm"), 12);
  EXPECT_TRUE(json["tools"][0].at("fastest"));
  EXPECT_FALSE(json["tools"][1].at("fits"));
  EXPECT_FALSE(json["tools"][1].at("refusal").get<std::string>().empty());
  EXPECT_TRUE(json.at("sequence").at("time_s").is_number());
}

TEST(Json, SaysWhatAPartHolds) {
  const auto json = nlohmann::json::parse(run_clearcut({"info", kExamples + "fishhead.p21", "--json"}).out);
  EXPECT_EQ(json.at("schema"), "clearcut-info-1");
  EXPECT_FALSE(json.at("features").empty());
  EXPECT_TRUE(json["features"][0].at("largest_cutter_mm").is_null()) << "the face is open: any cutter fits";
  EXPECT_NEAR(json["features"][3].at("largest_cutter_mm").get<double>(), 35, 0.01);
  const auto path = json["features"][0].at("path").get<std::string>();
  EXPECT_TRUE(path.starts_with("M") && path.ends_with("Z")) << path;
  EXPECT_EQ(json.at("features").size(), json.at("workingsteps").size());
  EXPECT_TRUE(json.at("asks").empty());
}

/// Whoever asks the question can offer its answers; each of them answers it.
TEST(Json, HoldsTheAnswersToAQuestion) {
  const ScratchFolder folder;
  const auto lwpolyline = [](const std::string& layer, int size) {
    std::string text = "0\nLWPOLYLINE\n8\n" + layer + "\n90\n4\n70\n1\n";
    for (const auto& [x, y] : {std::pair{-size, -size}, {size, -size}, {size, size}, {-size, size}})
      text += "10\n" + std::to_string(x) + "\n20\n" + std::to_string(y) + "\n";
    return text;
  };
  const auto drawing = [&](const std::string& outer, const std::string& inner) {
    return folder.file("drawing.dxf",
                       "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" +
                           lwpolyline(outer, 30) + lwpolyline(inner, 10) + "0\nENDSEC\n0\nEOF\n");
  };
  using Answers = std::vector<std::string>;
  for (const auto& [outer, inner, wanted] :
       {std::tuple{"A", "A", Answers{"profile:outer", "pocket:outer"}},
        std::tuple{"POCKET_D8", "POCKET_D4", Answers{"step:POCKET_D4", "ignore:POCKET_D4"}}}) {
    const auto file = drawing(outer, inner);
    const auto json = nlohmann::json::parse(run_clearcut({"info", file, "--json"}).out);
    Answers found;
    for (const auto& one : json.at("answers")) {
      found.push_back(one.at("value"));
      const auto answered = nlohmann::json::parse(
          run_clearcut({"info", file, "--json", one.at("option").get<std::string>(), found.back()}).out);
      EXPECT_TRUE(answered.at("answers").empty()) << found.back();
      EXPECT_NE(answered.at("asks"), json.at("asks")) << found.back();
    }
    EXPECT_EQ(found, wanted);
  }
}

/// Whoever shows the outlines needs no reader of drawings of his own.
TEST(Json, HoldsTheCurvesOfADrawing) {
  const ScratchFolder folder;
  const auto drawing =
      folder.file("disc.svg", R"(<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="20mm"
    viewBox="0 0 40 20"><rect x="1" y="2" width="30" height="10"/><circle cx="36" cy="10" r="3"/></svg>)");
  const auto json = nlohmann::json::parse(run_clearcut({"info", drawing, "--json"}).out);
  ASSERT_EQ(json.at("outlines").size(), 2U);
  for (const auto& one : json.at("outlines")) {
    const std::string path = one.at("path");
    if (one.at("diameter_mm").is_null()) {
      for (const char* corner : {"1 8", "31 8", "31 18", "1 18"}) EXPECT_THAT(path, HasSubstr(corner));
      EXPECT_EQ(std::count(path.begin(), path.end(), 'L'), 4) << path;
    } else {
      EXPECT_THAT(path, HasSubstr("A3 3 0 0")) << "true arcs of less than half a turn";
    }
    EXPECT_THAT(path, ContainsRegex("^M.*Z$"));
  }
}

}  // namespace
}  // namespace clearcut
