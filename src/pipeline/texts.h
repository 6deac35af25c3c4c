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

// Certificates, tables, pictures, pages and sheets of plans and checked programs; include/clearcut/report.h promises these functions and
// says more of them.
std::string write_certificate(const PlanResult& result, const PlanOptions& options,
                              const CertificateBasis& basis);
std::string write_certificate(const CheckResult& result, const PlanOptions& options,
                              const CertificateBasis& basis, const std::string& program);

std::string write_certificate(const PlanResult& result, const PlanOptions& options, const std::string& input);
std::string write_certificate(const CheckResult& result, const PlanOptions& options, const std::string& input,
                              const std::string& program);

std::string write_values(const Part& part, const std::vector<ResolvedValue>& values, std::size_t width = 120);

std::string write_table(const PlanResult& result, std::size_t width = 120);
std::string write_table(const CheckResult& result, std::size_t width = 120);

std::string write_selection_table(const PlanResult& result, std::size_t width = 120);

std::string write_picture(const PlanResult& result);
std::string write_picture(const CheckResult& result);

std::string write_animation(const PlanResult& result, const PlanOptions& options);
std::string write_animation(const CheckResult& result, const PlanOptions& options);

std::string write_page(const PlanResult& result, const PlanOptions& options);
std::string write_page(const CheckResult& result, const PlanOptions& options, const std::string& program);

SetupSheet setup_sheet_of(const PlanResult& result, const PlanOptions& options,
                          const std::string& program_name);
SetupSheet setup_sheet_of(const CheckResult& result, const PlanOptions& options,
                          const std::string& program_name);
std::string write_setup_sheet(const PlanResult& result, const PlanOptions& options,
                              const std::string& program_name);
std::string write_setup_sheet(const CheckResult& result, const PlanOptions& options,
                              const std::string& program_name);

std::string write_segments(const PlanResult& result);

}  // namespace clearcut::pipeline
