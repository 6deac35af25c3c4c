#include "certificate_info.h"

#include "base/digest.h"
#include "base/file.h"
#include "base/version.h"

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

const std::vector<std::string>& typed_arguments() {
  return arguments_kept();
}

report::CertificateInfo certificate_basis(const std::string& command,
                                          const std::vector<CertificateFileName>& files,
                                          const resolve::PlanOptions& options) {
  report::CertificateInfo info;
  info.version = kVersion;
  info.seed = options.seed;
  info.command = command;
  info.arguments = typed_arguments();
  for (const CertificateFileName& one : files)
    info.inputs.push_back({one.role, one.path, sha256_hex(read_file(one.path))});
  info.dialect = options.post.dialect;
  info.machine = options.machine;
  info.tolerances = options.tol;
  info.engagement_limit_deg = options.engagement_deg;
  info.material = options.shop.material;
  return info;
}

}  // namespace clearcut::cli
