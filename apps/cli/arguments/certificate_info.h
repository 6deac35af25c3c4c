// Basis stated in the certificates of all commands.
#pragma once

#include <clearcut/report.h>

#include <string>
#include <vector>

namespace clearcut::cli {

/// Stores the arguments of the running subcommand, as typed.
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

/// The current certificate of `clearcut plan` or `verify` for these arguments. Writes no file. `program`: selects, of
/// several set-ups, the one with the program of this name.
std::string plan_certificate(const std::vector<std::string>& arguments, const std::string& program);
std::string verify_certificate(const std::vector<std::string>& arguments);

}  // namespace clearcut::cli
