// The certificate as JSON: the part that states the question (part, tools, limits, machine, assumptions), the seal,
// and the JSON Schema with the check of a certificate against it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/results/findings.h"
#include "report/certificate/certificate.h"

namespace clearcut::report {

/// Keys name, text, line (0: none) and met_by ("" while the condition is open).
nlohmann::ordered_json condition_json(const Condition& condition);

/// Rounded to 1e-6, so that the same figure has the same text for any order of summation; null if not finite.
nlohmann::ordered_json certificate_number(double value);

/// Keys role, name, sha256.
nlohmann::ordered_json certificate_file(const CertificateFile& file);

nlohmann::ordered_json certificate_question(const Part& part, const Findings& findings,
                                            const CertificateInfo& info);

/// What every check takes for granted, a sentence each.
nlohmann::ordered_json certificate_assumptions();

/// SHA-256 of a certificate without its `seal`.
std::string seal_of(nlohmann::ordered_json certificate);

/// docs/certificate.schema.json.
const char* certificate_schema();

/// Departures of `json` from `schema`, a sentence each: "/faults/0/kind: ...". Supports the keywords used by the
/// schema here: type, enum, pattern (of 64 hexadecimal digits), minimum, required, properties, items, allOf and $ref
/// into $defs.
std::vector<std::string> schema_faults(const nlohmann::ordered_json& json,
                                       const nlohmann::ordered_json& schema);

/// Every differing field: "/verdict: \"CLEAN\" is now \"FAULTY\"".
std::vector<std::string> differences(const nlohmann::ordered_json& before, const nlohmann::ordered_json& now);

}  // namespace clearcut::report
