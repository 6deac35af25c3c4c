// Finds what the independent checker (checker/clearcut_check.cpp) needs to accept a program: a witness, see docs/witness.md.
// Nothing here is trusted: a wrong witness is refused by the checker, which this runs before it returns one.
#pragma once

#include <string>

namespace clearcut::pipeline {

/// What is to be proven, mm. The rest of the claims is the checker's own default.
struct WitnessQuestion {
  double diameter = 0;     ///< of the one flat cutter
  double wall_stock = 0;   ///< left on walls
  double floor_stock = 0;  ///< left on the floor
  double uncut = 0.01;     ///< how far beyond the cutter's reach in the program the floor may lie
  double top = 0;  ///< of the pocket, as it was planned: where the file says otherwise, it is another part
  double floor = 0;
};

struct FoundWitness {
  std::string bytes;    ///< empty where none was found
  std::string why_not;  ///< a sentence, with the place; empty where one was found
  std::string claims;   ///< as the checker words them
  int tiles = 0;
};

/// `part_text` is an outline (.json) with one closed pocket. Messages name the files as given.
FoundWitness find_witness(const std::string& program_text, const std::string& program_name,
                          const std::string& part_text, const std::string& part_name,
                          const WitnessQuestion& question);

}  // namespace clearcut::pipeline
