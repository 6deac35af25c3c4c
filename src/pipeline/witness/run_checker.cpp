#include "base/apart.h"
#include "base/programs.h"
#include "pipeline/witness/find_witness.h"

namespace clearcut::pipeline {
namespace {

constexpr int kCheckerSeconds = 600;  // of processor time; usually less than a second

}  // namespace

std::string checker_program() {
  return companion("clearcut-check");
}

std::optional<std::string> claims_by_checker(const std::string& program_file, const std::string& part_file,
                                             const std::string& witness_file,
                                             const std::vector<std::string>& options) {
  std::vector<std::string> command{checker_program(), program_file, part_file, witness_file};
  command.insert(command.end(), options.begin(), options.end());
  return done_apart(command, "", kCheckerSeconds);
}

}  // namespace clearcut::pipeline
