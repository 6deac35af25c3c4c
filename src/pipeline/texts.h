// Results as text for people and programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/results/certificate_basis.h"
#include "pipeline/check.h"
#include "pipeline/run.h"
#include "report/certificate/certificate.h"
#include "report/sheet/setup_sheet.h"

namespace clearcut::pipeline {

std::string write_certificate(const PlanResult& result, const PlanOptions& options,
                              const CertificateBasis& basis);
std::string write_certificate(const CheckResult& result, const PlanOptions& options,
                              const CertificateBasis& basis, const std::string& program);

/// The certificate as JSON: findings and their basis. `input` is the text of the part's file: its hash names it
/// in the certificate. docs/report.md lists every field.
std::string write_certificate(const PlanResult& result, const PlanOptions& options, const std::string& input);
/// The same for a checked program with the text `program`.
std::string write_certificate(const CheckResult& result, const PlanOptions& options, const std::string& input,
                              const std::string& program);

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
std::string write_animation(const PlanResult& result, const PlanOptions& options);
std::string write_animation(const CheckResult& result, const PlanOptions& options);

/// One HTML page that animates the machining and needs no other file.
std::string write_page(const PlanResult& result, const PlanOptions& options);
/// The same for a checked program with the text `program`.
std::string write_page(const CheckResult& result, const PlanOptions& options, const std::string& program);

/// Content of the page for the machine: zero, stock, tools, operations, notes. `program_name`: name of the written or
/// read program.
SetupSheet setup_sheet_of(const PlanResult& result, const PlanOptions& options,
                          const std::string& program_name);
SetupSheet setup_sheet_of(const CheckResult& result, const PlanOptions& options,
                          const std::string& program_name);
/// The same as HTML.
std::string write_setup_sheet(const PlanResult& result, const PlanOptions& options,
                              const std::string& program_name);
std::string write_setup_sheet(const CheckResult& result, const PlanOptions& options,
                              const std::string& program_name);

/// The feed moves as plain numbers, x y to x y, in mm.
std::string write_segments(const PlanResult& result);

}  // namespace clearcut::pipeline
