// The question of which a witness is the proof, and answers to it; see docs/witness.md.
#pragma once

#include <string>
#include <vector>

namespace clearcut::inline model {

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

struct WitnessAnswer {
  bool accepted = false;
  std::string text;  ///< the proved claims, or the unproved conclusion
};

}  // namespace clearcut::inline model
