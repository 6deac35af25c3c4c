// Witnesses: what --witness writes, and what --prove has checked by a program of its own.
#pragma once

#include <clearcut/plan.h>
#include <clearcut/witness.h>

#include <string>

namespace clearcut::cli {

/// A program and what it makes.
struct Proven {
  const Part& part;  ///< as it was planned or checked
  const Toolpath& toolpath;
  const std::string& program;
  std::string program_name;  ///< path
  std::string part_name;     ///< path of the outline (.json)
};

/// A witness, and within how much of the cutter's reach the floor is proven to be cut, mm.
struct WitnessFile {
  FoundWitness found;
  double uncut = 0;
};

/// Throws InputError where the part is no outline file.
void require_outline(const std::string& part_name);
WitnessFile witness_of(const Proven& what);
/// What was found, or why nothing was, as lines.
std::string witness_lines(const WitnessFile& witness, const std::string& path, const Proven& what);
/// Runs clearcut-check on them: "proved by witness (checked in 0.04 s)", or that it did not accept. Sets `proved`.
std::string checked_by_program(const WitnessFile& witness, const Proven& what, bool& proved);

}  // namespace clearcut::cli
