// Plans and checks as text: certificate (JSON), table, picture (SVG), page that plays the machining (HTML), set-up sheet (HTML, PDF).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "clearcut/plan.h"
#include "clearcut/verify.h"
#include "model/results/certificate_basis.h"
#include "model/results/setup_sheet.h"

namespace clearcut {

/// Content of the page for the machine: zero, stock, tools, operations, notes. `program_name`: name of the written or
/// read program.
SetupSheet setup_sheet_of(const PlanResult& result, const PlanOptions& options,
                          const std::string& program_name);
SetupSheet setup_sheet_of(const CheckResult& result, const PlanOptions& options,
                          const std::string& program_name);

/// One SVG document that plays the machining from above, in two minutes at most.
std::string write_animation(const PlanResult& result, const PlanOptions& options);
std::string write_animation(const CheckResult& result, const PlanOptions& options);

/// The certificate as JSON: findings and their basis. docs/report.md lists every field.
std::string write_certificate(const PlanResult& result, const PlanOptions& options,
                              const CertificateBasis& basis);
std::string write_certificate(const CheckResult& result, const PlanOptions& options,
                              const CertificateBasis& basis, const std::string& program);

/// The same without a command; `input` is the text of the part's file, whose hash names it in the certificate.
std::string write_certificate(const PlanResult& result, const PlanOptions& options, const std::string& input);

/// The same for a checked program with the text `program`.
std::string write_certificate(const CheckResult& result, const PlanOptions& options, const std::string& input,
                              const std::string& program);

/// One HTML page that animates the machining and needs no other file.
std::string write_page(const PlanResult& result, const PlanOptions& options);

/// The same for a checked program with the text `program`.
std::string write_page(const CheckResult& result, const PlanOptions& options, const std::string& program);

/// One SVG document: the part, cuts, uncut material, faults. Paths in mm, arcs as arcs.
std::string write_picture(const PlanResult& result);
std::string write_picture(const CheckResult& result);

/// The feed moves as plain numbers, x y to x y, in mm.
std::string write_segments(const PlanResult& result);

/// Outcome of all considered strategies; lines of ASCII.
std::string write_selection_table(const PlanResult& result, std::size_t width = 120);

/// The same as HTML.
std::string write_setup_sheet(const PlanResult& result, const PlanOptions& options,
                              const std::string& program_name);
std::string write_setup_sheet(const CheckResult& result, const PlanOptions& options,
                              const std::string& program_name);

/// Figures of every feature and of the whole, then the faults; lines of ASCII.
std::string write_table(const PlanResult& result, std::size_t width = 120);
std::string write_table(const CheckResult& result, std::size_t width = 120);

/// Every value of a plan and its source, from PlanResult and ResolvedPlan; lines of ASCII.
std::string write_values(const Part& part, const std::vector<ResolvedValue>& values, std::size_t width = 120);

/// Sheets of one job as one page, printed with each on its own sheet.
std::string joined_setup_sheets(const std::vector<std::string>& sheets);

/// Throws InputError naming the file to be written if the program that draws pages (apps/sheet) is found neither
/// beside this program nor at its installed place.
void require_pdf(const std::string& file_name);

/// A well-formed HTML page for one printed sheet; every text is escaped.
std::string setup_sheet_html(const SetupSheet& sheet);

/// Sheets on pages of A4, each beginning on its own page; continued tables repeat their heads. Text can be searched
/// and copied. The same sheets give the same bytes if the same fonts are installed: no date.
/// Throws  as require_pdf(), and if no font is installed.
/// Cost    some 50 ms, for the program and its libraries.
std::string setup_sheets_pdf(const std::vector<SetupSheet>& sheets, const std::string& file_name);

/// "M0 0L40 0A5 5 0 0 1 45 5Z": an outline as the path of an SVG element, mm with y up.
std::string svg_path(const Loop& loop);

/// `program` without comments, block numbers of Klartext, white space at the ends of lines, and empty lines: two
/// programs with the same motion text move a machine alike.
std::string motion_text(std::string_view program);

}  // namespace clearcut
