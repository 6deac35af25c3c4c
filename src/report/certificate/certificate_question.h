// The part of a certificate that says what was asked: part, tools, limits, machine, and what was taken for granted.
#pragma once

#include <nlohmann/json.hpp>

#include "report/certificate/certificate.h"

namespace clearcut::report {

/// Rounded to 1e-6, so that the same figure has the same text whatever order it was summed in; null where not finite.
nlohmann::ordered_json certificate_number(double value);

nlohmann::ordered_json certificate_question(const Part& part, const Findings& findings,
                                            const CertificateInfo& info);

/// SHA-256 of a certificate without its `seal`.
std::string seal_of(nlohmann::ordered_json certificate);

}  // namespace clearcut::report
