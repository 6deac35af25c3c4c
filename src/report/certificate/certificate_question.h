// The part of a certificate that states the question: part, tools, limits, machine, and assumptions.
#pragma once

#include <nlohmann/json.hpp>

#include "report/certificate/certificate.h"

namespace clearcut::report {

/// Rounded to 1e-6, so that the same figure has the same text for any order of summation; null if not finite.
nlohmann::ordered_json certificate_number(double value);

nlohmann::ordered_json certificate_question(const Part& part, const Findings& findings,
                                            const CertificateInfo& info);

/// SHA-256 of a certificate without its `seal`.
std::string seal_of(nlohmann::ordered_json certificate);

}  // namespace clearcut::report
