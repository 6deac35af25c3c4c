// A proof that others can check without this software: find_witness() gives what `clearcut-check PROGRAM PART WITNESS` needs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/witness.h"

namespace clearcut {

/// Answer of the independent checker for the texts of a program and of an outline and the bytes of a witness: the
/// proved claims, or the unproved conclusion. `uncut` in mm; `straight`: rapids are straight on every control; `partial`:
/// features and tools of which nothing is claimed are let pass.
WitnessAnswer check_witness(const std::string& program_text, const std::string& part_text,
                            const std::string& witness, double uncut = 0.01, bool straight = false,
                            bool partial = false);

/// The path of clearcut-check; empty if not found beside this program.
std::string checker_program();

/// The checker's line naming the proved claims; nothing if the checker does not accept the witness. `options` are its
/// own.
std::optional<std::string> claims_by_checker(const std::string& program_file, const std::string& part_file,
                                             const std::string& witness_file,
                                             const std::vector<std::string>& options);

/// `part_text` is an outline (.json). Messages name the files as given.
FoundWitness find_witness(const std::string& program_text, const std::string& program_name,
                          const std::string& part_text, const std::string& part_name,
                          const WitnessQuestion& question);

}  // namespace clearcut
