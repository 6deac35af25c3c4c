// Functions of include/clearcut/report.h, by calls of the stages.
#include <clearcut/report.h>

#include <utility>

#include "pipeline/texts.h"
#include "report/picture/svg_writer.h"
#include "report/result.h"
#include "report/sheet/sheet_writers.h"

namespace clearcut {

SetupSheet setup_sheet_of(const PlanResult& result, const PlanOptions& options,
                          const std::string& program_name) {
  return pipeline::setup_sheet_of(result, options, program_name);
}

SetupSheet setup_sheet_of(const CheckResult& result, const PlanOptions& options,
                          const std::string& program_name) {
  return pipeline::setup_sheet_of(result, options, program_name);
}

std::string write_animation(const PlanResult& result, const PlanOptions& options) {
  return pipeline::write_animation(result, options);
}

std::string write_animation(const CheckResult& result, const PlanOptions& options) {
  return pipeline::write_animation(result, options);
}

std::string write_certificate(const PlanResult& result, const PlanOptions& options,
                              const CertificateBasis& basis) {
  return pipeline::write_certificate(result, options, basis);
}

std::string write_certificate(const CheckResult& result, const PlanOptions& options,
                              const CertificateBasis& basis, const std::string& program) {
  return pipeline::write_certificate(result, options, basis, program);
}

std::string write_certificate(const PlanResult& result, const PlanOptions& options,
                              const std::string& input) {
  return pipeline::write_certificate(result, options, input);
}

std::string write_certificate(const CheckResult& result, const PlanOptions& options, const std::string& input,
                              const std::string& program) {
  return pipeline::write_certificate(result, options, input, program);
}

std::string write_page(const PlanResult& result, const PlanOptions& options) {
  return pipeline::write_page(result, options);
}

std::string write_page(const CheckResult& result, const PlanOptions& options, const std::string& program) {
  return pipeline::write_page(result, options, program);
}

std::string write_picture(const PlanResult& result) {
  return pipeline::write_picture(result);
}

std::string write_picture(const CheckResult& result) {
  return pipeline::write_picture(result);
}

std::string write_segments(const PlanResult& result) {
  return pipeline::write_segments(result);
}

std::string write_selection_table(const PlanResult& result, std::size_t width) {
  return pipeline::write_selection_table(result, width);
}

std::string write_setup_sheet(const PlanResult& result, const PlanOptions& options,
                              const std::string& program_name) {
  return pipeline::write_setup_sheet(result, options, program_name);
}

std::string write_setup_sheet(const CheckResult& result, const PlanOptions& options,
                              const std::string& program_name) {
  return pipeline::write_setup_sheet(result, options, program_name);
}

std::string write_table(const PlanResult& result, std::size_t width) {
  return pipeline::write_table(result, width);
}

std::string write_table(const CheckResult& result, std::size_t width) {
  return pipeline::write_table(result, width);
}

std::string write_values(const Part& part, const std::vector<ResolvedValue>& values, std::size_t width) {
  return pipeline::write_values(part, values, width);
}

std::string joined_setup_sheets(const std::vector<std::string>& sheets) {
  return report::joined_setup_sheets(sheets);
}

void require_pdf(const std::string& file_name) {
  report::require_pdf(file_name);
}

std::string setup_sheet_html(const SetupSheet& sheet) {
  return report::setup_sheet_html(sheet);
}

std::string setup_sheets_pdf(const std::vector<SetupSheet>& sheets, const std::string& file_name) {
  return report::setup_sheets_pdf(sheets, file_name);
}

std::string motion_text(std::string_view program) {
  return report::motion_text(program);
}

std::string svg_path(const Loop& loop) {
  return report::svg_path(loop);
}

}  // namespace clearcut
