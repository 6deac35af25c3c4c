// Results as text for people and programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/check.h"
#include "pipeline/run.h"
#include "report/certificate/certificate.h"
#include "report/sheet/setup_sheet.h"

namespace clearcut::pipeline {

/// What a certificate rests on besides the options.
struct CertificateBasis {
  std::string command;                          ///< "plan", "verify", "elements"
  std::vector<std::string> arguments;           ///< of the command, as typed
  std::vector<report::CertificateFile> inputs;  ///< every file that was read
  std::string program_name;
  bool dialect_stated = true;  ///< of a program that was checked; else it was recognised
  std::optional<report::CertificateProof> proof = {};
};
std::string write_certificate(const PlanResult& result, const resolve::PlanOptions& options,
                              const CertificateBasis& basis);
std::string write_certificate(const CheckResult& result, const resolve::PlanOptions& options,
                              const CertificateBasis& basis, const std::string& program);

/// The certificate as JSON: what was found, and what that rests on. `input` is the text of the part's file: its hash names it
/// in the certificate. docs/report.md lists every field.
std::string write_certificate(const PlanResult& result, const resolve::PlanOptions& options,
                              const std::string& input);
/// The same of a program that was checked, whose text is `program`.
std::string write_certificate(const CheckResult& result, const resolve::PlanOptions& options,
                              const std::string& input, const std::string& program);

/// Every value of a plan and where it comes from, as PlanResult and ResolvedPlan hold them; lines of ASCII.
std::string write_values(const Part& part, const std::vector<ResolvedValue>& values, std::size_t width = 120);

/// Figures of every feature and of the whole, then the faults; lines of ASCII.
std::string write_table(const PlanResult& result, std::size_t width = 120);
std::string write_table(const CheckResult& result, std::size_t width = 120);

/// What became of the strategies that were considered; lines of ASCII.
std::string write_selection_table(const PlanResult& result, std::size_t width = 120);

/// One SVG document: the part, what was cut, what is left, faults. Paths in mm, arcs as arcs.
std::string write_picture(const PlanResult& result);
std::string write_picture(const CheckResult& result);

/// One HTML page that plays the machining and needs no other file.
std::string write_page(const PlanResult& result, const resolve::PlanOptions& options);
/// The same of a program that was checked, whose text is `program`.
std::string write_page(const CheckResult& result, const resolve::PlanOptions& options,
                       const std::string& program);

/// What the page for the machine states: zero, stock, tools, operations, notes. `program_name`: as it was written or read.
report::SetupSheet setup_sheet_of(const PlanResult& result, const resolve::PlanOptions& options,
                                  const std::string& program_name);
report::SetupSheet setup_sheet_of(const CheckResult& result, const resolve::PlanOptions& options,
                                  const std::string& program_name);
/// The same as HTML.
std::string write_setup_sheet(const PlanResult& result, const resolve::PlanOptions& options,
                              const std::string& program_name);
std::string write_setup_sheet(const CheckResult& result, const resolve::PlanOptions& options,
                              const std::string& program_name);

/// The feed moves as plain numbers, x y to x y, in mm.
std::string write_segments(const PlanResult& result);

}  // namespace clearcut::pipeline
