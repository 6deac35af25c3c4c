// The certificate: what verification found, as JSON. docs/report.md lists every field.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/machine.h"
#include "model/options/resolved_plan.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "model/results/margin.h"
#include "model/results/strategy_selection.h"
#include "report/result.h"

namespace clearcut::report {

/// A file that the findings rest on.
struct CertificateFile {
  std::string role;  ///< "part", "job", "tools", "machine", "earlier program", "stock", "program"
  std::string name;  ///< as it was given
  std::string sha256;
};

/// What the independent checker accepted of a witness. Absent where none was asked for.
struct CertificateProof {
  std::vector<std::string> proved;      ///< names of features of which nothing is left: claim C1
  std::vector<std::string> not_proved;  ///< sentences: what nothing is proven of, and why
  std::vector<std::string> options;     ///< of the checker
  std::string witness_sha256;           ///< empty where no witness was found: then nothing is proved
};

/// What the findings rest on: enough to repeat them.
struct CertificateInfo {
  std::string version;                 ///< of the software
  std::uint64_t seed = 0;              ///< of everything random
  std::string command;                 ///< "plan", "verify", "elements"
  std::vector<std::string> arguments;  ///< of the command, as typed
  std::vector<CertificateFile> inputs;
  std::string program_name;
  std::string program;  ///< the text that was checked
  std::string dialect;  ///< of the control that it was read as
  bool dialect_stated = true;
  Machine machine;
  Tolerances tolerances;
  std::optional<double> engagement_limit_deg;
  std::optional<std::string> material;
  /// Of the workingsteps; empty when a program of unknown origin was checked.
  std::vector<StrategySelection> selections;
  std::vector<ContourLevels> contours = {};                 ///< with the coefficients of published methods
  std::optional<kinematics::PublishedTime> published = {};  ///< CPO-rho eq. 9; absent: not asked
  std::optional<CertificateProof> proof = {};
  std::optional<Margin> margin = {};  ///< absent: not asked
  /// Of the plan; empty when a program of unknown origin was checked.
  std::vector<ResolvedValue> values = {};
};

/// Shape   one JSON object: what it rests on, the figures of the whole, `features` (each with its figures and
///         `layers`), `faults`, `values` of a plan; keys always in the same order, two blanks of indentation, a line break at the
///         end.
/// Units   in the names of the fields; numbers rounded to 1e-6. A figure that is not finite is null, and then
///         `clean` is false.
/// Text    bytes that are not UTF-8 are replaced. docs/certificate.schema.json is the JSON Schema. `seal` is the SHA-256 of
///         the object without it, printed on one line without blanks.
std::string certificate_json(const Part& part, const Findings& findings, const CertificateInfo& info);

}  // namespace clearcut::report
