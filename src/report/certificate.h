// The certificate: what verification found, as JSON. docs/report.md lists every field.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/contest.h"
#include "model/findings.h"
#include "model/part.h"
#include "model/resolved_plan.h"

namespace clearcut::report {

/// What the findings rest on: enough to repeat them.
struct CertificateInfo {
  std::string version;            ///< of the software
  std::uint64_t seed = 0;         ///< of everything random
  std::string input_hash;         ///< of the bytes of the part's file
  std::string program_hash;       ///< of the bytes of the program that was judged
  std::string tool;               ///< tools as asked for, "" when they come with the part
  std::string machine;            ///< name of the machine whose limits and times were used
  std::vector<Contest> contests;  ///< of the workingsteps; empty when a program of unknown origin was judged
  std::vector<ResolvedValue> values = {};  ///< of the plan; empty when a program of unknown origin was judged
};

/// Shape   one JSON object: what it rests on, the figures of the whole, `features` (each with its figures and
///         `layers`), `faults`, `values` of a plan; keys always in the same order, two blanks of indentation, a line break at the
///         end.
/// Units   in the names of the fields; numbers rounded to 1e-6. A figure that is not finite is null, and then
///         `clean` is false.
/// Text    bytes that are not UTF-8 are replaced.
std::string certificate_json(const Part& part, const Findings& findings, const CertificateInfo& info);

}  // namespace clearcut::report
