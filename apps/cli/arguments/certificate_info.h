// What the certificates of all commands say they rest on.
#pragma once

#include <clearcut/report.h>

#include <string>
#include <vector>

namespace clearcut::cli {

/// The arguments of the subcommand that runs, as typed.
void remember_arguments(std::vector<std::string> arguments);
const std::vector<std::string>& remembered_arguments();

/// An input by its role and path.
struct CertificateFileName {
  std::string role;
  std::string path;
};
/// `command` is the subcommand's name.
CertificateBasis certificate_basis(const std::string& command, const std::vector<CertificateFileName>& files,
                                   const std::string& program_name);

/// The certificate that `clearcut plan` or `verify` gives for these arguments now. Writes nothing. `program`: of several
/// set-ups the one with the program of this name.
std::string plan_certificate(const std::vector<std::string>& arguments, const std::string& program);
std::string verify_certificate(const std::vector<std::string>& arguments);

}  // namespace clearcut::cli
