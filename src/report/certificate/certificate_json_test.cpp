#include "report/certificate/certificate_json.h"

#include <gtest/gtest.h>

#include "base/file.h"
#include "report/certificate/certificate.h"
#include "report/result.h"
#include "report/sample_job.h"

namespace clearcut::report {
namespace {

using Json = nlohmann::ordered_json;

Json sample_certificate() {
  CertificateInfo info;
  info.version = "1";
  info.command = "plan";
  info.inputs = {{"part", "a.dxf", std::string(64, '0')}};
  info.program = "G1 X1\n";
  Findings findings = sample::findings();
  findings.conditions.push_back({"g55", "G55 has its origin where the work's is", 7});
  return Json::parse(certificate_json(sample::part(), findings, info));
}

Json schema() {
  return Json::parse(certificate_schema());
}

TEST(CertificateSchema, IsTheOneInTheDocuments) {
  EXPECT_EQ(read_file(std::string(CLEARCUT_SOURCE_DIR) + "/docs/certificate.schema.json"),
            certificate_schema());
}

TEST(CertificateSchema, HoldsForCertificates) {
  for (const std::string& fault : schema_faults(sample_certificate(), schema())) ADD_FAILURE() << fault;
}

/// Every field that is taken out is missed, or no field that is asked for.
TEST(CertificateSchema, MissesWhatIsTakenOut) {
  const Json whole = sample_certificate();
  for (const auto& [name, value] : whole.items()) {
    Json less = whole;
    less.erase(name);
    EXPECT_FALSE(schema_faults(less, schema()).empty()) << name;
    Json other = whole;
    other[name] = Json::array({Json::array()});
    EXPECT_FALSE(schema_faults(other, schema()).empty()) << name;
  }
}

TEST(CertificateSeal, BreaksWithEveryField) {
  const Json whole = sample_certificate();
  EXPECT_EQ(whole.at("seal"), seal_of(whole));
  const Json flat = whole.flatten();
  for (const auto& [path, value] : flat.items()) {
    if (path == "/seal" || value.is_structured()) continue;
    Json altered = whole;
    altered[Json::json_pointer(path)] = value.is_number() ? Json(value.get<double>() + 1e-6) : Json("other");
    EXPECT_NE(altered.at("seal"), seal_of(altered)) << path;
    ASSERT_EQ(differences(whole, altered).size(), 1U) << path;
    EXPECT_EQ(differences(whole, altered).front().substr(0, path.size()), path);
  }
}

TEST(MotionText, LeavesOutWhatMovesNothing) {
  EXPECT_EQ(motion_text("%\n(A) G1 X1 ; b\n\nM2\r\n"), "%\nG1 X1\nM2\n");
  EXPECT_EQ(motion_text("12 ; CERTIFICATE: CLEAN\n13 L X+1 R0 FMAX\n"), "L X+1 R0 FMAX\n");
  EXPECT_NE(motion_text("G1 X1\n"), motion_text("G1 X2\n"));
}

}  // namespace
}  // namespace clearcut::report
