// Certificates whose fields contradict each other, whoever sealed them.
#include "report/certificate/certificate_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "report/certificate/certificate.h"
#include "report/sample_job.h"

namespace clearcut::report {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

CertificateInfo info_of_check() {
  CertificateInfo info;
  info.version = "1.2.3";
  info.command = "verify";
  info.inputs.push_back({"part", "part.json", std::string(64, 'a')});
  return info;
}

/// Figures that may be true together: `parts` equal parts of a cut of 100 mm.
Figures clean_figures(int parts) {
  Figures figures;
  figures.feed_mm = 100.0 / parts;
  figures.rapid_mm = 20.0 / parts;
  figures.time_naive_s = 8.0 / parts;
  figures.time_s = 10.0 / parts;
  figures.max_axial_mm = 2;
  figures.engagement.max_deg = 95;
  figures.engagement.max_at = Place{{30, 15}, -2, 12};
  figures.engagement.mean_deg = 94;
  figures.engagement.histogram_mm[9] = 80.0 / parts;
  figures.engagement.climb_mm = 80.0 / parts;
  figures.clean = true;
  return figures;
}

Findings clean_findings() {
  Findings findings = sample::findings();
  findings.faults.clear();
  findings.conditions.clear();
  findings.all = clean_figures(1);
  for (FeatureFindings& feature : findings.features) {
    feature.figures = clean_figures(2);
    for (LayerFindings& layer : feature.layers) layer.figures = clean_figures(4);
  }
  return findings;
}

/// What is said of that certificate once somebody has changed it.
std::string said(const std::function<void(Json&)>& change, const Findings& findings = clean_findings()) {
  Json json = Json::parse(certificate_json(sample::part(), findings, info_of_check()));
  change(json);
  std::string text;
  for (const std::string& one : certificate_contradictions(json.dump())) text += one + "\n";
  return text;
}

TEST(Contradictions, AreNotInCertificatesAsTheyAreWritten) {
  EXPECT_EQ(said([](Json&) {}), "");
  Findings open = clean_findings();
  open.conditions.push_back({"g55", "G55 lies where the work's zero is", 3});
  EXPECT_EQ(said([](Json&) {}, open), "");
  Findings faulty = clean_findings();
  for (Figures* figures : {&faulty.all, &faulty.features[0].figures}) {
    figures->gouge_mm = 5;
    figures->gouge_at = Place{{30, 15}, -2, 12};
    figures->clean = false;
  }
  faulty.faults.push_back({FaultKind::kGouge, "", {}, 5, "too deep"});
  EXPECT_EQ(said([](Json&) {}, faulty), "");
}

TEST(Contradictions, OfFiguresAndVerdict) {
  EXPECT_THAT(said([](Json& json) { json["gouge_mm"] = 5; }), HasSubstr("/gouge_mm: is 5"));
  EXPECT_THAT(said([](Json& json) { json["uncut_thickness_mm"] = 0.5; }), HasSubstr("/uncut_thickness_mm"));
  EXPECT_THAT(said([](Json& json) { json["rapid_in_material"] = 1; }), HasSubstr("/rapid_in_material"));
  for (const char* figure : {"gouge_mm", "uncut_thickness_mm"})
    EXPECT_THAT(said([&](Json& json) { json[figure] = nullptr; }),
                HasSubstr("is no number, and no fault says why"));
  EXPECT_THAT(said([](Json& json) { json["features"][0]["gouge_mm"] = 0.25; }),
              HasSubstr("/gouge_mm: is not the greatest of its parts"));
  EXPECT_THAT(said([](Json& json) { json["features"][0]["layers"][0]["rapid_in_material"] = 2; }),
              HasSubstr("/features/0/rapid_in_material: is not the sum of its parts"));
  EXPECT_THAT(said([](Json& json) { json["question"]["limits"]["engagement_deg"] = 60; }),
              HasSubstr("/engagement/max_deg"));
}

TEST(Contradictions, OfVerdictFaultsAndConditions) {
  Findings faulty = clean_findings();
  faulty.faults.push_back({FaultKind::kTooDeep, faulty.features[0].name, {}, 5, "too deep"});
  EXPECT_THAT(said([](Json& json) { json["verdict"] = "CLEAN"; }, faulty),
              HasSubstr("/verdict: is \"CLEAN\""));
  EXPECT_THAT(said([](Json& json) { json["clean"] = true; }, faulty), HasSubstr("/clean"));
  EXPECT_THAT(said([](Json& json) { json["features"][0]["clean"] = true; }, faulty),
              HasSubstr("/features/0/clean"));
  EXPECT_THAT(said([](Json& json) { json["verdict"] = "FAULTY"; }), HasSubstr("/verdict"));
  EXPECT_THAT(said([](Json& json) { json["clean"] = false; }), HasSubstr("/clean: is false"));
  Findings open = clean_findings();
  open.conditions.push_back({"g55", "G55 lies where the work's zero is", 3});
  EXPECT_THAT(said([](Json& json) { json["verdict"] = "CLEAN"; }, open), HasSubstr("CONDITIONAL"));
  EXPECT_THAT(said([](Json& json) { json["conditions"][0]["met_by"] = "accepted"; }, open),
              HasSubstr("CLEAN"));
}

TEST(Contradictions, OfWhatItRestsOn) {
  EXPECT_THAT(said([](Json& json) { json["inputs"] = Json::array(); }), HasSubstr("/inputs"));
  EXPECT_THAT(said([](Json& json) { json["verdict"] = "CLEAN AS FAR AS CAN BE SAID WITHOUT A PART"; }),
              HasSubstr("/verdict"));
}

TEST(Contradictions, OfFiguresThatCannotBeTrueTogether) {
  EXPECT_THAT(said([](Json& json) { json["uncut_mm2"] = json["features"][0]["uncut_mm2"] = 500; }),
              HasSubstr("/uncut_mm2: is there, and nothing is wider than the limit"));
  EXPECT_THAT(said([](Json& json) { json["time_s"] = nullptr; }), HasSubstr("/time_s: is no number"));
  EXPECT_THAT(said([](Json& json) { json["time_s"] = 3; }),
              HasSubstr("/time_s: is not the sum of its parts"));
  EXPECT_THAT(said([](Json& json) { json["features"].erase(1); }),
              HasSubstr("/features: are 1, and the workplan has 2"));
  EXPECT_THAT(said([](Json& json) { json["features"][0]["engagement"]["mean_deg"] = 20; }),
              HasSubstr("/features/0/engagement/mean_deg: is not the mean of the histogram"));
}

TEST(Contradictions, OfLimitsThatNobodyAskedFor) {
  for (const char* name : {"uncut_mm", "gouge_mm", "fit_mm"})
    EXPECT_THAT(said([&](Json& json) { json["question"]["limits"][name] = 2; }), HasSubstr(name));
  const auto limited = [](const char* typed) {
    return said([&](Json& json) {
      json["question"]["arguments"] = {"part.json", "--engagement", typed};
      json["question"]["limits"]["engagement_deg"] = 120;
    });
  };
  EXPECT_EQ(limited("120"), "");
  EXPECT_THAT(limited("60"), HasSubstr("/question/limits/engagement_deg: is 120"));
}

TEST(Contradictions, KeysThatComeTwice) {
  const std::string text = certificate_json(sample::part(), clean_findings(), info_of_check());
  std::string doubled = text;
  doubled.insert(doubled.find("\"gouge_mm\""), "\"gouge_mm\": 0, ");
  EXPECT_THAT(certificate_contradictions(text), IsEmpty());
  EXPECT_THAT(certificate_contradictions(doubled),
              ::testing::Contains(HasSubstr("\"gouge_mm\" comes twice")));
}

}  // namespace
}  // namespace clearcut::report
