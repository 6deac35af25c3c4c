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

/// Basis of a certificate in addition to the options.
struct CertificateBasis {
  std::string command;                          ///< "plan", "verify", "elements"
  std::vector<std::string> arguments;           ///< arguments of the command, as typed
  std::vector<report::CertificateFile> inputs;  ///< all files read
  std::string program_name;
  bool dialect_stated = true;  ///< for a checked program: its dialect was stated, not recognised
  std::optional<report::CertificateProof> proof = {};
};
std::string write_certificate(const PlanResult& result, const resolve::PlanOptions& options,
                              const CertificateBasis& basis);
std::string write_certificate(const CheckResult& result, const resolve::PlanOptions& options,
                              const CertificateBasis& basis, const std::string& program);

/// The certificate as JSON: findings and their basis. `input` is the text of the part's file: its hash names it
/// in the certificate. docs/report.md lists every field.
std::string write_certificate(const PlanResult& result, const resolve::PlanOptions& options,
                              const std::string& input);
/// The same for a checked program with the text `program`.
std::string write_certificate(const CheckResult& result, const resolve::PlanOptions& options,
                              const std::string& input, const std::string& program);

/// Every value of a plan and its source, from PlanResult and ResolvedPlan; lines of ASCII.
std::string write_values(const Part& part, const std::vector<ResolvedValue>& values, std::size_t width = 120);

/// Figures of every feature and of the whole, then the faults; lines of ASCII.
std::string write_table(const PlanResult& result, std::size_t width = 120);
std::string write_table(const CheckResult& result, std::size_t width = 120);

/// Outcome of all considered strategies; lines of ASCII.
std::string write_selection_table(const PlanResult& result, std::size_t width = 120);

/// One SVG document: the part, cuts, uncut material, faults. Paths in mm, arcs as arcs.
std::string write_picture(const PlanResult& result);
std::string write_picture(const CheckResult& result);

/// One SVG document that plays the machining from above, in two minutes at most.
std::string write_animation(const PlanResult& result, const resolve::PlanOptions& options);
std::string write_animation(const CheckResult& result, const resolve::PlanOptions& options);

/// One HTML page that animates the machining and needs no other file.
std::string write_page(const PlanResult& result, const resolve::PlanOptions& options);
/// The same for a checked program with the text `program`.
std::string write_page(const CheckResult& result, const resolve::PlanOptions& options,
                       const std::string& program);

/// Content of the page for the machine: zero, stock, tools, operations, notes. `program_name`: name of the written or
/// read program.
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
