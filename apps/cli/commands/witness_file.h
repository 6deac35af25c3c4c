// Witnesses: what --witness writes, and what --prove has checked by a program of its own.
#pragma once

#include <clearcut/file.h>
#include <clearcut/plan.h>
#include <clearcut/report.h>
#include <clearcut/witness.h>

#include <string>
#include <vector>

namespace clearcut::cli {

/// A program and what it makes.
struct Proven {
  const Part& part;  ///< as it was planned or checked
  const Toolpath& toolpath;
  const std::string& program;
  std::string program_name;  ///< path
  std::string part_name;     ///< path
};

/// A witness, and the options of the checker that it is made for.
struct WitnessFile {
  FoundWitness found;
  std::vector<std::string> options;
  std::string outline;  ///< the part that it is about, where the one given is no outline file, or was
                        ///< repaired; else empty
};

/// Beside a witness: the outline that it is about, where that is not the part's own file.
std::string outline_name(const std::string& witness);
WitnessFile witness_of(const Proven& what);
/// The witness as `path`, and the outline where there is one; nothing where no witness was found.
/// What a certificate says of it.
CertificateProof proof_of(const WitnessFile& witness);
std::vector<OutputFile> witness_files(const WitnessFile& witness, const std::string& path);
/// What was found, or why nothing was, as lines.
std::string witness_lines(const WitnessFile& witness, const std::string& path, const Proven& what);
/// Runs clearcut-check on them: "proved by witness (checked in 0.04 s)", or that it did not accept. Sets `proved`.
std::string checked_by_program(const WitnessFile& witness, const Proven& what, bool& proved);

}  // namespace clearcut::cli
