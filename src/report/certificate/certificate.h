// The certificate: the results of verification, as JSON. docs/report.md lists every field.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/machine.h"
#include "model/options/resolved_plan.h"
#include "model/part.h"
#include "model/results/certificate_basis.h"
#include "model/results/copies_made.h"
#include "model/results/findings.h"
#include "model/results/length_bound.h"
#include "model/results/margin.h"
#include "model/results/strategy_selection.h"
#include "report/result.h"

namespace clearcut::report {

/// Basis of the findings: sufficient to repeat them.
struct CertificateInfo {
  std::string version;                 ///< version of the software
  std::uint64_t seed = 0;              ///< seed of all random numbers
  std::string command;                 ///< "plan", "verify", "elements"
  std::vector<std::string> arguments;  ///< arguments of the command, as typed
  std::vector<CertificateFile> inputs;
  std::string program_name;
  std::string program;  ///< the checked text
  std::string dialect;  ///< name of the control in whose dialect the program was read
  bool dialect_stated = true;
  Machine machine;
  Tolerances tolerances;
  std::optional<double> engagement_limit_deg;
  std::optional<std::string> material;
  /// Selections of the workingsteps; empty if a program of unknown origin was checked.
  std::vector<StrategySelection> selections;
  std::vector<ContourLevels> contours = {};     ///< with the coefficients of published methods
  std::optional<PublishedTime> published = {};  ///< CPO-rho eq. 9; absent: not asked
  std::optional<CertificateProof> proof = {};
  std::optional<Margin> margin = {};      ///< absent: not asked
  std::optional<CopiesMade> copies = {};  ///< absent: one part
  /// What the lower bounds of the workingsteps are added up from.
  std::vector<StepLengthBound> length_bounds = {};
  /// Values of the plan; empty if a program of unknown origin was checked.
  std::vector<ResolvedValue> values = {};
};

/// Shape   one JSON object: its basis, the figures of the whole, `features` (each with its figures and `layers`),
///         `faults`, `values` of a plan; keys always in the same order, two blanks of indentation, a line break at
///         the end.
/// Units   in the names of the fields; numbers rounded to 1e-6. A non-finite figure is null, and `clean` is then
///         false.
/// Text    bytes outside of UTF-8 are replaced. docs/certificate.schema.json is the JSON Schema. `seal` is the
///         SHA-256 of the object without `seal`, printed on one line without blanks.
std::string certificate_json(const Part& part, const Findings& findings, const CertificateInfo& info);

}  // namespace clearcut::report
