// Functions of include/clearcut/infill.h, by calls of the stages.
#include "pipeline/infill.h"

#include <clearcut/infill.h>

#include <utility>

#include "report/certificate/laid_certificate.h"

namespace clearcut {

LaidFindings check_infill(const Part& part, const std::string& program, const std::string& file_name,
                          const InfillOptions& options) {
  return pipeline::check_infill(part, program, file_name, options);
}

InfillResult plan_infill(const Part& part, const InfillOptions& options) {
  return pipeline::plan_infill(part, options);
}

std::string laid_certificate(const LaidFindings& findings, const LaidCertificateInfo& info) {
  return report::laid_certificate(findings, info);
}

std::string laid_table(const LaidFindings& findings) {
  return report::laid_table(findings);
}

}  // namespace clearcut
