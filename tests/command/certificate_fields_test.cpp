// The certificate says all it promises, and the scallop of drafted walls is what was asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "pipeline/run.h"
#include "pipeline/texts.h"
#include "read/job/read_part.h"
#include "report/certificate/certificate.h"
#include "resolve/values/plan_options.h"

namespace clearcut {
namespace {

PlanResult plan_example(PlanOptions options) {
  const std::string file = std::string(CLEARCUT_SOURCE_DIR) + "/examples/fishhead.p21";
  options.strategy = "contour";
  return pipeline::plan_part(read::read_part(file, {}), options);
}

void expect_figures(const nlohmann::json& json, const std::string& where) {
  for (const char* key :
       {"clean", "feed_mm", "rapid_mm", "plunge_mm", "turns", "turn_angle_deg", "retracts", "time_s",
        "time_naive_s", "uncut_mm2", "uncut_thickness_mm", "uncut_at", "gouge_mm", "gouge_at",
        "unreachable_mm2", "rapid_in_material", "air_cut_mm", "lower_bound_mm"}) {
    EXPECT_TRUE(json.contains(key)) << where << ": " << key;
  }
  for (const char* key : {"max_deg", "mean_deg", "over_limit_mm", "histogram", "climb_percent"})
    EXPECT_TRUE(json.at("engagement").contains(key)) << where << ": " << key;
}

TEST(CertificateFields, AreAllThereInAllAndPerFeatureAndLayer) {
  PlanOptions options;
  options.shop.material = "aluminium";
  const auto result = plan_example(options);
  const auto json = nlohmann::json::parse(report::certificate_json(result.part, result.findings, {}));
  for (const char* key : {"version", "seed", "inputs", "features", "faults"})
    EXPECT_TRUE(json.contains(key)) << key;
  expect_figures(json, "all");
  EXPECT_GT(json.at("load").at("max_force_n").get<double>(), 0);
  ASSERT_FALSE(json.at("features").empty());
  for (const auto& feature : json.at("features")) {
    expect_figures(feature, feature.at("name").get<std::string>());
    ASSERT_FALSE(feature.at("layers").empty()) << feature.at("name");
    for (const auto& layer : feature.at("layers")) expect_figures(layer, "layer");
  }
}

/// The bound of a level from the certificate alone; docs/report.md, `length_bound`.
double bound_from(const nlohmann::json& bound) {
  const double radius = bound.at("cutter_radius_mm").get<double>(), disc = std::acos(-1.0) * radius * radius;
  double area = bound.at("area_mm2").get<double>(), crossings = 0;
  std::vector<double> widths{0, 0};
  for (const auto& point : bound.at("points")) area += point.at("mm2").get<double>();
  for (const auto& ring : bound.at("rings")) {
    area -= ring.at("mm2").get<double>();
    widths.push_back(ring.at("radius_mm").get<double>() - radius);
    crossings += 2 * widths.back();
  }
  if (bound.at("rings").empty()) return (area - bound.at("paths").get<double>() * disc) / (2 * radius);
  std::sort(widths.rbegin(), widths.rend());
  area = std::max(area, 0.0);
  return crossings - widths[0] +
         (area - std::max(2 * radius * widths[1], std::min(area, disc))) / (2 * radius);
}

TEST(LengthBound, IsTheSumOfWhatTheCertificateLists) {
  // An open block with an arm half as wide as the cutter, in two levels.
  const auto part =
      read::read_part_text(R"({"name": "BLOCK", "units": "mm", "kind": "open_pocket", "top": 0, "depth": 4,
      "outer": [[0, 0], [60, 0], [60, 20], [120, 20], [120, 24], [60, 24], [60, 40], [0, 40]], "islands": [],
      "allowed": [{"outer": [[-20, -20], [140, -20], [140, 60], [-20, 60]], "islands": []}]})",
                           "block.json", {});
  PlanOptions options;
  options.strategy = "zigzag";
  options.tools = {resolve::parse_tool("endmill:6")};
  options.stepdown = 2;
  const auto result = pipeline::plan_part(part, options);
  const auto json = nlohmann::json::parse(pipeline::write_certificate(result, options, std::string()));
  double sum = 0;
  std::size_t points = 0;
  for (const auto& feature : json.at("features")) {
    const auto& bound = feature.at("length_bound");
    EXPECT_NEAR(bound_from(bound), bound.at("mm").get<double>(), 1e-3) << feature.at("name");
    for (const auto& layer : feature.at("layers")) {
      EXPECT_EQ(layer.at("lower_bound_mm"), bound.at("mm"));
      sum += bound.at("mm").get<double>();
    }
    points += bound.at("points").size();
  }
  EXPECT_NEAR(json.at("lower_bound_mm").get<double>(), sum, 1e-3);
  EXPECT_GE(points, 4u);
  EXPECT_LT(json.at("lower_bound_mm").get<double>(), json.at("feed_mm").get<double>());
}

TEST(DraftedWalls, StandNoMoreThanTheScallopAskedForOffTheWall) {
  PlanOptions options;
  options.strategy = "contour";
  options.scallop = 0.3;
  const auto part = read::read_part(std::string(CLEARCUT_SOURCE_DIR) + "/examples/fishhead_sloped.p21", {});
  const auto result = pipeline::plan_part(part, options);
  EXPECT_TRUE(result.findings.all.clean);
  for (const auto& feature : result.findings.features) {
    if (feature.name != "POCKET3") continue;
    ASSERT_GT(feature.layers.size(), 2u);
    double highest = 0;
    for (std::size_t i = 1; i < feature.layers.size(); ++i)
      highest = std::max(highest, (feature.layers[i - 1].z - feature.layers[i].z) * std::sin(0.785));
    EXPECT_LE(highest, 0.3 + 1e-3);
    EXPECT_GT(highest, 0.27) << "and not for more layers than needed";
    ASSERT_TRUE(feature.scallop);
    EXPECT_NEAR(feature.scallop->height_mm, highest, 1e-3);
    EXPECT_EQ(feature.scallop->asked_mm, 0.3);
    const auto json = nlohmann::json::parse(report::certificate_json(result.part, result.findings, {}));
    for (const auto& one : json.at("features")) {
      EXPECT_EQ(one.contains("scallop_mm"), one.at("name") == "POCKET3") << one.at("name");
      if (one.contains("scallop_mm")) {
        EXPECT_EQ(one.at("scallop_asked_mm").get<double>(), 0.3);
      }
    }
  }
}

}  // namespace
}  // namespace clearcut
