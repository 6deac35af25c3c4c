#include "pipeline/texts.h"

#include "base/file.h"
#include "base/version.h"
#include "kinematics/kinematics.h"
#include "kinematics/planner.h"
#include "pipeline/compare.h"
#include "pipeline/result_figures.h"
#include "read/gcode/program/dialect.h"
#include "report/certificate/certificate.h"
#include "report/picture/animation.h"
#include "report/picture/svg.h"
#include "report/result.h"
#include "report/sheet/setup_sheet.h"
#include "report/sheet/sheet_writers.h"
#include "report/table.h"
#include "report/viewer/html.h"
#include "report/words/text_table.h"
#include "verify/length_bounds.h"

namespace clearcut::pipeline {
namespace {

template <typename Result>
std::string picture_of(const Result& result) {
  report::SvgOptions options;
  if (result.earlier) options.earlier = &*result.earlier;
  if (result.margin) options.margin = &*result.margin;
  return report::svg(result.part, result.toolpath, result.findings, options);
}

template <typename Result>
std::string animation_of(const Result& result, const PlanOptions& options) {
  return report::animated_svg(result.part, result.toolpath, result.findings,
                              times_of_moves(result.part, result.toolpath, result.control, options));
}

template <typename Result>
std::string page_of(const Result& result, const PlanOptions& options, const std::string& program) {
  report::HtmlOptions page{options.machine, program};
  if (result.earlier) page.earlier = &*result.earlier;
  page.material = options.shop.material.value_or("");
  page.move_times_s = times_of_moves(result.part, result.toolpath, result.control, options);
  return report::html(result.part, result.toolpath, result.findings, page);
}

/// `control`: control table of the read program, and its dialect.
report::CertificateInfo certificate_info(const PlanOptions& options, const CertificateBasis& basis,
                                         const ControlTable& control) {
  report::CertificateInfo info;
  info.version = kVersion;
  info.seed = options.seed;
  info.command = basis.command;
  info.arguments = basis.arguments;
  info.inputs = basis.inputs;
  info.proof = basis.proof;
  info.program_name = basis.program_name;
  info.dialect = options.post.dialect;
  info.machine = options.machine;
  info.machine.planner = kinematics::planner_in_force(options.machine, control.planner);
  info.tolerances = options.tol;
  info.engagement_limit_deg = options.engagement_deg;
  info.material = options.shop.material;
  return info;
}

report::SetupSheetInfo sheet_info(const PlanOptions& options, const std::string& program_name,
                                  const std::string& dialect) {
  report::SetupSheetInfo info;
  info.program_name = program_name;
  info.dialect = dialect;
  info.inch = options.post.inch;
  info.work_offset = post::work_offset_words(dialect, options.post.work_offset);
  return info;
}

CertificateBasis basis_of_input(const Part& part, const std::string& command, const std::string& input) {
  CertificateBasis basis;
  basis.command = command;
  basis.inputs.push_back({"part", part.source_file, sha256_hex(input)});
  return basis;
}

}  // namespace

std::string write_certificate(const PlanResult& result, const PlanOptions& options,
                              const CertificateBasis& basis) {
  report::CertificateInfo info = certificate_info(options, basis, result.control);
  info.margin = result.margin;
  info.copies = result.copies;
  info.length_bounds = verify::length_bounds_of(result.part, result.findings);
  info.program = result.program;
  info.selections = result.selections;
  info.values = result.values;
  info.contours = result.contours;
  info.published = kinematics::published_time(result.toolpath);
  return report::certificate_json(result.part, result.findings, info);
}

std::string write_certificate(const CheckResult& result, const PlanOptions& options,
                              const CertificateBasis& basis, const std::string& program) {
  report::CertificateInfo info = certificate_info(options, basis, result.control);
  info.margin = result.margin;
  info.copies = result.copies;
  info.length_bounds = verify::length_bounds_of(result.part, result.findings);
  info.program = program;
  info.dialect = read::gcode::name_of(result.dialect);
  info.dialect_stated = basis.dialect_stated;
  return report::certificate_json(result.part, result.findings, info);
}

std::string write_certificate(const PlanResult& result, const PlanOptions& options,
                              const std::string& input) {
  return write_certificate(result, options, basis_of_input(result.part, "plan", input));
}

std::string write_certificate(const CheckResult& result, const PlanOptions& options, const std::string& input,
                              const std::string& program) {
  return write_certificate(result, options, basis_of_input(result.part, "verify", input), program);
}

std::string write_values(const Part& part, const std::vector<ResolvedValue>& values, std::size_t width) {
  return report::fitted(report::value_table(part, values), width);
}

std::string write_table(const PlanResult& result, std::size_t width) {
  return report::table(result.part, result.findings, width);
}

std::string write_table(const CheckResult& result, std::size_t width) {
  return report::table(result.part, result.findings, width);
}

std::string write_selection_table(const PlanResult& result, std::size_t width) {
  return report::fitted(report::selection_table(result.selections), width);
}

std::string write_animation(const PlanResult& result, const PlanOptions& options) {
  return animation_of(result, options);
}

std::string write_animation(const CheckResult& result, const PlanOptions& options) {
  return animation_of(result, options);
}

std::string write_picture(const PlanResult& result) {
  return picture_of(result);
}

std::string write_picture(const CheckResult& result) {
  return picture_of(result);
}

std::string write_page(const PlanResult& result, const PlanOptions& options) {
  return page_of(result, options, result.program);
}

std::string write_page(const CheckResult& result, const PlanOptions& options, const std::string& program) {
  return page_of(result, options, program);
}

SetupSheet setup_sheet_of(const PlanResult& result, const PlanOptions& options,
                          const std::string& program_name) {
  return report::compose_sheet(result.part, result.toolpath, result.findings,
                               sheet_info(options, program_name, options.post.dialect));
}

SetupSheet setup_sheet_of(const CheckResult& result, const PlanOptions& options,
                          const std::string& program_name) {
  return report::compose_sheet(
      result.part, result.toolpath, result.findings,
      sheet_info(options, program_name, std::string(read::gcode::name_of(result.dialect))));
}

std::string write_setup_sheet(const PlanResult& result, const PlanOptions& options,
                              const std::string& program_name) {
  return report::setup_sheet_html(setup_sheet_of(result, options, program_name));
}

std::string write_setup_sheet(const CheckResult& result, const PlanOptions& options,
                              const std::string& program_name) {
  return report::setup_sheet_html(setup_sheet_of(result, options, program_name));
}

std::string write_segments(const PlanResult& result) {
  return report::result_file(
      result.toolpath, {result.part.name, result.contours, kinematics::published_time(result.toolpath)});
}

}  // namespace clearcut::pipeline
