// What the certificates of all commands say they rest on.
#pragma once

#include <string>
#include <vector>

#include "read/gcode/dialect.h"
#include "report/certificate.h"
#include "resolve/plan_options.h"

namespace clearcut::cli {

/// The arguments of the subcommand that runs, as typed.
void remember_arguments(std::vector<std::string> arguments);
const std::vector<std::string>& typed_arguments();

/// `command` is the subcommand's name; `files` are role and path of each input.
struct CertificateFileName {
  std::string role;
  std::string path;
};
report::CertificateInfo certificate_basis(const std::string& command,
                                          const std::vector<CertificateFileName>& files,
                                          const resolve::PlanOptions& options);

/// The certificate that `clearcut plan` or `verify` gives for these arguments now. Writes nothing.
std::string plan_certificate(const std::vector<std::string>& arguments);
std::string verify_certificate(const std::vector<std::string>& arguments);

}  // namespace clearcut::cli
