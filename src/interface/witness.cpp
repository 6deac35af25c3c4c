// Functions of include/clearcut/witness.h, by calls of the stages.
#include <clearcut/witness.h>

#include <utility>

#include "pipeline/witness/find_witness.h"

namespace clearcut {

WitnessAnswer check_witness(const std::string& program_text, const std::string& part_text,
                            const std::string& witness, double uncut, bool straight, bool partial) {
  return pipeline::check_witness(program_text, part_text, witness, uncut, straight, partial);
}

std::string checker_program() {
  return pipeline::checker_program();
}

std::optional<std::string> claims_by_checker(const std::string& program_file, const std::string& part_file,
                                             const std::string& witness_file,
                                             const std::vector<std::string>& options) {
  return pipeline::claims_by_checker(program_file, part_file, witness_file, options);
}

FoundWitness find_witness(const std::string& program_text, const std::string& program_name,
                          const std::string& part_text, const std::string& part_name,
                          const WitnessQuestion& question) {
  return pipeline::find_witness(program_text, program_name, part_text, part_name, question);
}

}  // namespace clearcut
