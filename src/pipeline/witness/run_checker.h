// Has a witness checked by clearcut-check, a program of its own that shares nothing with what found it.
#pragma once

#include <optional>
#include <string>

namespace clearcut::pipeline {

/// The path of clearcut-check; empty where it is not beside this program.
std::string checker_program();

/// The line in which the checker names the claims that it has proved; nothing where it does not accept the witness. `uncut`: the
/// thickness that may stay, mm.
std::optional<std::string> claims_by_checker(const std::string& program_file, const std::string& part_file,
                                             const std::string& witness_file, double uncut);

}  // namespace clearcut::pipeline
