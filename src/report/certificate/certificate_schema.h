// The JSON Schema of certificates, and the check of a certificate against it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace clearcut::report {

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
