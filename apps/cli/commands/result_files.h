// Files beside the program: set-up sheets, whose kind is given by the ending of their names, and witnesses, output of
// --witness and checked by a separate program for --prove. What the terminal says of them, and of several parts on a sheet.
#pragma once

#include <clearcut/file.h>
#include <clearcut/plan.h>
#include <clearcut/report.h>
#include <clearcut/witness.h>

#include <string>
#include <vector>

namespace clearcut::cli {

/// Throws InputError before planning if the name requires a PDF that this build cannot write.
void check_setup_sheet_name(const std::string& path);

/// PDF for names in .pdf, else HTML.
std::string setup_sheet_file(const std::string& path, const SetupSheet& sheet);
/// Those of a job of several set-ups, each on a sheet of its own.
std::string setup_sheets_file(const std::string& path, const std::vector<SetupSheet>& sheets);

/// A program and its part.
struct Proven {
  const Part& part;  ///< as planned or checked
  const Toolpath& toolpath;
  const std::string& program;
  std::string program_name;  ///< path
  std::string part_name;     ///< path
};

/// A witness, and the checker's options for it.
struct WitnessFile {
  FoundWitness found;
  std::vector<std::string> options;
  /// The part of the witness, if the given one is no outline file, or was repaired; else empty.
  std::string outline;
};

/// Name of the file beside a witness for its outline, if other than the part's own file.
std::string outline_name(const std::string& witness);
WitnessFile witness_of(const Proven& what);
/// The certificate's text on a witness.
CertificateProof proof_of(const WitnessFile& witness);
/// The witness as the file `path`, and its outline if there is one; empty if no witness was found.
std::vector<OutputFile> witness_files(const WitnessFile& witness, const std::string& path);
/// The result, or the reason for its absence, as lines.
std::string witness_lines(const WitnessFile& witness, const std::string& path, const Proven& what);
/// Runs clearcut-check on them: "proved by witness (checked in 0.04 s)", or the refusal. Sets `proved`.
std::string checked_by_program(const WitnessFile& witness, const Proven& what, bool& proved);

/// Of several parts how many there are and how many are clean.
std::string parts_line(const CopiesMade& made);

}  // namespace clearcut::cli
