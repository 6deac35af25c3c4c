// The JSON Schema of certificates, and whether one keeps to it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace clearcut::report {

/// docs/certificate.schema.json.
const char* certificate_schema();

/// Where `json` departs from `schema`, a sentence each: "/faults/0/kind: ...". Knows the words that our schema uses: type,
/// enum, pattern (of 64 hexadecimal digits), minimum, required, properties, items, allOf and $ref into $defs.
std::vector<std::string> schema_faults(const nlohmann::ordered_json& json,
                                       const nlohmann::ordered_json& schema);

/// Every field that differs: "/verdict: \"CLEAN\" is now \"FAULTY\"".
std::vector<std::string> differences(const nlohmann::ordered_json& before, const nlohmann::ordered_json& now);

}  // namespace clearcut::report
