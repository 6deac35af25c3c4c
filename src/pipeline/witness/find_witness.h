// Finds a witness, needed by the independent checker (checker/clearcut_check.cpp) to accept a program, see
// docs/witness.md. This code is not trusted: the checker refuses a wrong witness, and is run here before a witness is
// returned. Checks a witness with clearcut-check, a separate program sharing no code with the search for the witness.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/witness.h"

namespace clearcut::pipeline {

// The search for a witness, and answers of the independent checker; include/clearcut/witness.h promises these functions and says more of
// them.
FoundWitness find_witness(const std::string& program_text, const std::string& program_name,
                          const std::string& part_text, const std::string& part_name,
                          const WitnessQuestion& question);

WitnessAnswer check_witness(const std::string& program_text, const std::string& part_text,
                            const std::string& witness, double uncut = 0.01, bool straight = false,
                            bool partial = false);

std::string checker_program();

std::optional<std::string> claims_by_checker(const std::string& program_file, const std::string& part_file,
                                             const std::string& witness_file,
                                             const std::vector<std::string>& options);

}  // namespace clearcut::pipeline
