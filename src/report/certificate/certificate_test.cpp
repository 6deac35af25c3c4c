#include "report/certificate/certificate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "report/sample_job.h"

namespace clearcut::report {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

CertificateInfo info() {
  CertificateInfo info;
  info.version = "1.2.3";
  info.seed = 18446744073709551615ULL;
  info.command = "plan";
  info.machine.name = "small mill";
  return info;
}

Json certificate(const Findings& findings) {
  return Json::parse(certificate_json(sample::part(), findings, info()));
}

std::vector<std::string> keys_of(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& item : json.items()) keys.push_back(item.key());
  return keys;
}

TEST(Certificate, HasEveryPromisedFieldForTheWholeEachFeatureAndEachLayer) {
  const Json json = certificate(sample::findings());
  const std::vector<std::string> promised = {
      "clean",        "feed_mm",        "rapid_mm",           "plunge_mm",
      "turns",        "turn_angle_deg", "retracts",           "time_s",
      "time_naive_s", "uncut_mm2",      "uncut_thickness_mm", "uncut_at",
      "gouge_mm",     "gouge_at",       "unreachable_mm2",    "rapid_in_material",
      "engagement",   "air_cut_mm",     "lower_bound_mm"};
  const Json& feature = json.at("features").at(1);
  for (const Json& figures : {json, feature, feature.at("layers").at(1)}) {
    EXPECT_THAT(keys_of(figures), testing::IsSupersetOf(promised));
    EXPECT_THAT(keys_of(figures.at("engagement")),
                testing::IsSupersetOf({"max_deg", "mean_deg", "over_limit_mm", "histogram"}));
    EXPECT_EQ(figures.at("engagement").at("histogram").size(), 18u);
  }
  EXPECT_THAT(keys_of(json), testing::IsSupersetOf({"version", "seed", "inputs", "program", "question",
                                                    "verdict", "conditions", "seal"}));
}

TEST(Certificate, FiguresAreTheFindings) {
  const Json json = certificate(sample::findings());
  EXPECT_EQ(json["feed_mm"], 2000.5);
  EXPECT_EQ(json["features"][0]["feed_mm"], 1000.25);
  EXPECT_EQ(json["features"][0]["layers"][1]["z"], -4);
  EXPECT_EQ(json["features"][1]["name"], "SLOT <2>");
  EXPECT_EQ(json["gouge_at"]["line"], 12);
  EXPECT_EQ(json["uncut_at"]["x"], 66.5);
  EXPECT_EQ(json["engagement"]["histogram"][9], 640.5);
  EXPECT_EQ(json["clean"], false);
  EXPECT_EQ(json["seed"], 18446744073709551615ULL);
  EXPECT_EQ(json["part"], "sample <part> & \"name\"");
}

TEST(Certificate, FaultsSayWhatWhereAndWhy) {
  const Json fault = certificate(sample::findings()).at("faults").at(0);
  EXPECT_THAT(keys_of(fault), testing::IsSupersetOf({"kind", "feature", "place", "line", "text"}));
  EXPECT_EQ(fault["kind"], name_of(FaultKind::kUncut));
  EXPECT_EQ(fault["place"]["y"], 56.5);
  EXPECT_EQ(fault["size_mm"], 0.25);
  EXPECT_EQ(fault["text"], "0.25 mm left in the <corner>");
}

TEST(Certificate, WhatIsUnknownIsNullAndNeverClean) {
  Findings findings = sample::findings();
  findings.all.clean = true;
  findings.faults.clear();
  findings.all.uncut_at.reset();
  EXPECT_TRUE(certificate(findings)["clean"]);
  EXPECT_TRUE(certificate(findings)["uncut_at"].is_null());
  findings.all.uncut_thickness_mm = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(certificate(findings)["uncut_thickness_mm"].is_null());
  EXPECT_FALSE(certificate(findings)["clean"]);
  findings.all.uncut_thickness_mm = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(certificate(findings)["clean"]);
}

TEST(Certificate, IsTheSameTextEachTimeWithoutSummationNoise) {
  Findings findings = sample::findings();
  findings.all.feed_mm = 0.1 + 0.2;
  findings.all.rapid_mm = -1e-12;
  const std::string text = certificate_json(sample::part(), findings, info());
  EXPECT_EQ(text, certificate_json(sample::part(), findings, info()));
  EXPECT_THAT(text, HasSubstr("\"feed_mm\": 0.3,"));
  EXPECT_THAT(text, HasSubstr("\"rapid_mm\": 0.0,"));
}

TEST(Certificate, NamesThatAreNotUtf8DoNotBreakIt) {
  Part part = sample::part();
  part.name =
      "a\xff"
      "b\n\"";
  const Json json = Json::parse(certificate_json(part, sample::findings(), info()));
  EXPECT_EQ(json["part"],
            "a\xef\xbf\xbd"
            "b\n\"");
}

TEST(Certificate, ListsTheStrategiesConsideredForAFeature) {
  Findings findings;
  findings.features.resize(2);
  findings.features[0].workingstep = 0;
  findings.features[1].workingstep = 1;
  CertificateInfo shown = info();
  shown.selections = {
      {"pocket",
       1,
       {{"zigzag", "", Outcome::kKept, 12.5, 200, 0}, {"spiral", "0.5", Outcome::kCannotWin, 0, 0, 14}}}};
  const auto json = nlohmann::json::parse(certificate_json(Part{}, findings, shown));
  EXPECT_FALSE(json["features"][0].contains("strategy"));
  const auto& feature = json["features"][1];
  EXPECT_EQ(feature["strategy"], "zigzag");
  ASSERT_EQ(feature["candidates"].size(), 2u);
  EXPECT_EQ(feature["candidates"][0]["time_s"], 12.5);
  EXPECT_EQ(feature["candidates"][1]["outcome"], "cannot win");
  EXPECT_EQ(feature["candidates"][1]["least_s"], 14);
}

}  // namespace
}  // namespace clearcut::report
