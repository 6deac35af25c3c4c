// Has a witness checked by clearcut-check, a program of its own that shares nothing with what found it.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace clearcut::pipeline {

/// The path of clearcut-check; empty where it is not beside this program.
std::string checker_program();

/// The line in which the checker names the claims that it has proved; nothing where it does not accept the witness. `options` are its own.
std::optional<std::string> claims_by_checker(const std::string& program_file, const std::string& part_file,
                                             const std::string& witness_file,
                                             const std::vector<std::string>& options);

}  // namespace clearcut::pipeline
