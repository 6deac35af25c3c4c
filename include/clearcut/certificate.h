// Certificates that were read back: their schema, their seal, and where two of them differ.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/file.h"

namespace clearcut {

/// Contradictions between the fields of a certificate valid by its schema, a sentence each: a verdict that does not
/// follow from faults and conditions, figures beyond their limits without a fault, parts of the work with more than
/// the whole, a repeated key, no input. A seal does not exclude these: anybody can compute one.
std::vector<std::string> certificate_contradictions(std::string_view certificate);

/// Every differing field: "/verdict: \"CLEAN\" is now \"FAULTY\"". Fields named in `left_out`, as paths from the top
/// ("/question/arguments"; "/inputs/*/name" for every item of a list), are not compared. Throws InputError on text
/// that is no JSON.
std::vector<std::string> certificate_differences(std::string_view before, std::string_view now,
                                                 const std::set<std::string>& left_out = {});

/// Departures of a certificate from docs/certificate.schema.json, a sentence each: "/faults/0/kind: ...". For text
/// that is no JSON object, one sentence.
std::vector<std::string> certificate_faults(std::string_view certificate);

/// Whether the seal is the SHA-256 of all other fields: false once any of them was changed.
bool seal_holds(std::string_view certificate);

}  // namespace clearcut
