// Finds a witness, needed by the independent checker (checker/clearcut_check.cpp) to accept a program, see
// docs/witness.md. This code is not trusted: the checker refuses a wrong witness, and is run here before a witness is
// returned. Checks a witness with clearcut-check, a separate program sharing no code with the search for the witness.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace clearcut::pipeline {

/// A flat cutter, or a drill as the cylinder above its point. mm.
struct WitnessTool {
  int number = 0;
  double diameter = 0;
  double point = 0;  ///< from the tip up to the full diameter
};
/// A feature of the part's file, and the stock left by its work. mm.
struct WitnessFeature {
  std::string name;
  double diameter = 0;  ///< diameter of its narrowest cutter
  double wall_stock = 0, floor_stock = 0;
  double floor = 0;          ///< planned floor: if the file states another one, it is another part
  std::string why_not = {};  ///< why no claim can be made; empty if one can
};

/// The claims to be proven, mm. All other claims are the checker's defaults.
struct WitnessQuestion {
  std::vector<WitnessTool> tools;
  int first_tool = 0;  ///< in before the program calls any
  /// In the order of the file, if equally many; else matched by their names.
  std::vector<WitnessFeature> features;
  bool straight = false;   ///< rapids are straight, also on controls that move their axes one by one
  bool engagement = true;  ///< whether the engagement of level feeds is to be proven, too
  double uncut = 0.01;     ///< permitted excess of the floor beyond the cutters' reach in the program
};

struct FoundWitness {
  std::string bytes;                 ///< empty if none was found
  std::string why_not;               ///< a sentence, with the place; empty if a witness was found
  std::vector<std::string> missing;  ///< features without proof, and the reasons
  std::vector<std::string> proved;   ///< features proved to be cut
  std::string claims;                ///< in the checker's words
  int tiles = 0;
};

/// `part_text` is an outline (.json). Messages name the files as given.
FoundWitness find_witness(const std::string& program_text, const std::string& program_name,
                          const std::string& part_text, const std::string& part_name,
                          const WitnessQuestion& question);

struct WitnessAnswer {
  bool accepted = false;
  std::string text;  ///< the proved claims, or the unproved conclusion
};
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

}  // namespace clearcut::pipeline
