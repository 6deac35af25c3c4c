#include "arguments/certificate_info.h"

#include <clearcut/certificate.h>
#include <clearcut/file.h>

namespace clearcut::cli {
namespace {

std::vector<std::string>& arguments_kept() {
  static std::vector<std::string> arguments;
  return arguments;
}

}  // namespace

void remember_arguments(std::vector<std::string> arguments) {
  arguments_kept() = std::move(arguments);
}

const std::vector<std::string>& remembered_arguments() {
  return arguments_kept();
}

CertificateBasis certificate_basis(const std::string& command, const std::vector<CertificateFileName>& files,
                                   const std::string& program_name) {
  CertificateBasis basis;
  basis.command = command;
  basis.arguments = arguments_kept();
  for (const CertificateFileName& one : files)
    basis.inputs.push_back({one.role, one.path, sha256_hex(read_file(one.path))});
  basis.program_name = program_name;
  return basis;
}

}  // namespace clearcut::cli
