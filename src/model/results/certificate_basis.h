// What a certificate says of its own origin: command, files, proof.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace clearcut::inline model {

/// A file on which the findings are based.
struct CertificateFile {
  std::string role;  ///< "part", "job", "tools", "machine", "earlier program", "stock", "program"
  std::string name;  ///< name as given by the user
  std::string sha256;
};

/// Result of the independent checker for a witness. Absent if no witness was requested.
struct CertificateProof {
  std::vector<std::string> proved;      ///< names of features proved to have no material left: claim C1
  std::vector<std::string> not_proved;  ///< sentences naming the unproved features, with the reasons
  std::vector<std::string> options;     ///< options of the checker
  std::string witness_sha256;           ///< empty if no witness was found: then nothing is proved
};

/// Basis of a certificate in addition to the options.
struct CertificateBasis {
  std::string command;                  ///< "plan", "verify", "elements"
  std::vector<std::string> arguments;   ///< arguments of the command, as typed
  std::vector<CertificateFile> inputs;  ///< all files read
  std::string program_name;
  bool dialect_stated = true;  ///< for a checked program: its dialect was stated, not recognised
  std::optional<CertificateProof> proof = {};
};

struct LaidCertificateInfo {
  std::string version;
  std::vector<std::string> arguments;  ///< as typed
  std::vector<CertificateFile> inputs;
  std::string program_name, program;  ///< its path, and the checked text
  std::string strategy, stepover;     ///< "" if they are not known
};

}  // namespace clearcut::inline model
