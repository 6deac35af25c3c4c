// Finds what the independent checker (checker/clearcut_check.cpp) needs to accept a program: a witness, see docs/witness.md.
// Nothing here is trusted: a wrong witness is refused by the checker, which this runs before it returns one.
#pragma once

#include <string>
#include <vector>

namespace clearcut::pipeline {

/// A flat cutter, or a drill as the cylinder above its point. mm.
struct WitnessTool {
  int number = 0;
  double diameter = 0;
  double point = 0;  ///< from the tip up to the full diameter
};
/// A feature of the part's file, and what its work leaves. mm.
struct WitnessFeature {
  std::string name;
  double diameter = 0;  ///< of the narrowest cutter that works on it
  double wall_stock = 0, floor_stock = 0;
  double floor = 0;          ///< as it was planned: where the file says otherwise, it is another part
  std::string why_not = {};  ///< why nothing can be claimed of it; empty where something can
};

/// What is to be proven, mm. The rest of the claims is the checker's own default.
struct WitnessQuestion {
  std::vector<WitnessTool> tools;
  int first_tool = 0;  ///< in before the program calls any
  std::vector<WitnessFeature>
      features;           ///< in the order of the file, as many as it has; else found by their names
  bool straight = false;  ///< rapids are straight, also where a control moves its axes one by one
  double uncut = 0.01;    ///< how far beyond the cutters' reach in the program the floor may lie
};

struct FoundWitness {
  std::string bytes;                 ///< empty where none was found
  std::string why_not;               ///< a sentence, with the place; empty where one was found
  std::vector<std::string> missing;  ///< features of which it proves nothing, and why
  std::vector<std::string> proved;   ///< features that it proves to be cut
  std::string claims;                ///< as the checker words them
  int tiles = 0;
};

/// `part_text` is an outline (.json). Messages name the files as given.
FoundWitness find_witness(const std::string& program_text, const std::string& program_name,
                          const std::string& part_text, const std::string& part_name,
                          const WitnessQuestion& question);

struct WitnessAnswer {
  bool accepted = false;
  std::string text;  ///< the claims that hold, or what does not follow
};
/// What the independent checker says of the texts of a program and of an outline and the bytes of a witness: the claims that hold, or
/// what does not follow. `uncut` in mm; `straight`: rapids are straight on every control.
WitnessAnswer check_witness(const std::string& program_text, const std::string& part_text,
                            const std::string& witness, double uncut = 0.01, bool straight = false);

}  // namespace clearcut::pipeline
