// The certificate of a program that lays a line over an area.
#pragma once

#include <string>
#include <vector>

#include "model/results/certificate_basis.h"
#include "model/results/laid_findings.h"
#include "report/certificate/certificate.h"

namespace clearcut::report {

/// Shape   JSON; docs/howto-infill.md lists its fields.
/// Units   in the names of the fields; numbers rounded to 1e-6.
std::string laid_certificate(const LaidFindings& findings, const LaidCertificateInfo& info);

/// The same for people: some lines, the last "verdict: CLEAN" or "verdict: FAULTY".
std::string laid_table(const LaidFindings& findings);

}  // namespace clearcut::report
