// Checks a witness with clearcut-check, a separate program sharing no code with the search for the witness.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace clearcut::pipeline {

/// The path of clearcut-check; empty if not found beside this program.
std::string checker_program();

/// The checker's line naming the proved claims; nothing if the checker does not accept the witness. `options` are its
/// own.
std::optional<std::string> claims_by_checker(const std::string& program_file, const std::string& part_file,
                                             const std::string& witness_file,
                                             const std::vector<std::string>& options);

}  // namespace clearcut::pipeline
