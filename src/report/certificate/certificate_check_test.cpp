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

CertificateInfo info_of_plan() {
  CertificateInfo info;
  info.version = "1.2.3";
  info.command = "plan";
  info.inputs.push_back({"part", "part.json", std::string(64, 'a')});
  return info;
}

Findings clean_findings() {
  Findings findings = sample::findings();
  findings.faults.clear();
  findings.conditions.clear();
  const auto clear = [](Figures& figures) {
    figures.clean = true;
    figures.gouge_mm = figures.uncut_thickness_mm = figures.uncut_mm2 = 0;
    figures.rapid_in_material = 0;
  };
  clear(findings.all);
  for (FeatureFindings& feature : findings.features) {
    clear(feature.figures);
    findings.all.max_axial_mm = std::max(findings.all.max_axial_mm, feature.figures.max_axial_mm);
    for (LayerFindings& layer : feature.layers) {
      clear(layer.figures);
      findings.all.max_axial_mm = std::max(findings.all.max_axial_mm, layer.figures.max_axial_mm);
    }
  }
  return findings;
}

/// What is said of that certificate once somebody has changed it.
std::string said(const std::function<void(Json&)>& change, const Findings& findings = clean_findings()) {
  Json json = Json::parse(certificate_json(sample::part(), findings, info_of_plan()));
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
  faulty.all.gouge_mm = 5;
  faulty.faults.push_back({FaultKind::kGouge, "", {}, 5, "too deep"});
  EXPECT_EQ(said([](Json&) {}, faulty), "");
}

TEST(Contradictions, OfFiguresAndVerdict) {
  EXPECT_THAT(said([](Json& json) { json["gouge_mm"] = 5; }), HasSubstr("/gouge_mm: is 5"));
  EXPECT_THAT(said([](Json& json) { json["uncut_thickness_mm"] = 0.5; }), HasSubstr("/uncut_thickness_mm"));
  EXPECT_THAT(said([](Json& json) { json["rapid_in_material"] = 1; }), HasSubstr("/rapid_in_material"));
  for (const char* figure : {"gouge_mm", "uncut_thickness_mm"})
    EXPECT_THAT(said([&](Json& json) { json[figure] = nullptr; }), HasSubstr("is no number, and was asked"));
  EXPECT_THAT(said([](Json& json) { json["features"][0]["gouge_mm"] = 0.25; }),
              HasSubstr("/features/0/gouge_mm: is more than that of the whole"));
  EXPECT_THAT(said([](Json& json) { json["features"][0]["layers"][0]["rapid_in_material"] = 2; }),
              HasSubstr("/features/0/layers/0/rapid_in_material"));
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

TEST(Contradictions, KeysThatComeTwice) {
  const std::string text = certificate_json(sample::part(), clean_findings(), info_of_plan());
  std::string doubled = text;
  doubled.insert(doubled.find("\"gouge_mm\""), "\"gouge_mm\": 0, ");
  EXPECT_THAT(certificate_contradictions(text), IsEmpty());
  EXPECT_THAT(certificate_contradictions(doubled),
              ::testing::Contains(HasSubstr("\"gouge_mm\" comes twice")));
}

}  // namespace
}  // namespace clearcut::report
