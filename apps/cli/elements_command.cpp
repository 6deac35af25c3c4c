#include <memory>

#include "base/error.h"
#include "base/file.h"
#include "base/version.h"
#include "commands.h"
#include "output.h"
#include "pipeline/elements.h"
#include "read/elements/read_elements.h"
#include "report/certificate.h"
#include "report/grid_picture.h"
#include "report/table.h"

namespace clearcut::cli {
namespace {

struct ElementsCommand {
  std::string input;
  std::string output;
  std::string certificate;
  std::string svg;
  std::string points;
  bool print_points = false;
  bool table = false;
  bool quiet = false;
  PlanOptions options;
};

CertificateInfo certificate_info(const ElementsCommand& command, const std::string& program) {
  CertificateInfo info;
  info.version = kVersion;
  info.seed = command.options.seed;
  info.input_hash = content_hash(read_file(command.input));
  info.program_hash = content_hash(program);
  info.machine = command.options.machine.name;
  return info;
}

std::vector<OutputFile> output_files(const ElementsCommand& command, const ElementJob& job,
                                     const ElementsResult& result) {
  const auto& plan = result.plan;
  std::vector<OutputFile> files{{command.output, plan.program}};
  if (!command.certificate.empty())
    files.push_back({command.certificate,
                     certificate_json(plan.part, plan.findings, certificate_info(command, plan.program))});
  if (!command.svg.empty()) files.push_back({command.svg, grid_picture(job, result.points, plan.toolpath)});
  if (!command.points.empty()) files.push_back({command.points, points_csv(job, result.points)});
  return files;
}

int run(const ElementsCommand& command) {
  if (command.table) {
    print_line(plain(grid_reduction_table()));
    return kClean;
  }
  if (command.input.empty() || command.output.empty())
    throw InputError("elements", "needs a job and a program to write: clearcut elements JOB.toml -o OUT.ngc");
  const ElementJob job = read_elements(command.input);
  const ElementsResult result = plan_elements(job, command.options);
  write_files(output_files(command, job, result));
  if (!command.quiet) {
    print(result.plan.part.diagnostics, true);
    if (command.print_points) print_line(plain(points_table(job, result.points)));
    if (command.output != "-") {
      print_line(plain(element_table(result)));
      print_line(table(result.plan.part, result.plan.findings));
    }
  }
  return result.plan.findings.all.clean ? kClean : kFault;
}

}  // namespace

void add_elements_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("elements", "Plan a job of design elements on a grid of squares");
  auto state = std::make_shared<ElementsCommand>();
  command->add_option("JOB", state->input, "Job of lines, arcs, rectangles, holes and slots (TOML)");
  command->add_option("-o,--output", state->output, "Program to write (- for standard output)");
  command->add_option("--certificate", state->certificate, "Certificate to write (JSON)");
  command->add_option("--svg", state->svg, "Picture of squares, reduced squares and tool impact to write");
  command->add_option("--points", state->points, "Table of all points to write (CSV)");
  command->add_flag("--print-points", state->print_points, "Print the table of all points");
  command->add_option("--post", state->options.post.dialect, "Controller (linuxcnc, grbl, fanuc, ...)");
  command->add_option("--seed", state->options.seed, "Seed of the search");
  command->add_flag("--table", state->table, "Print the published table of reductions beside our figures");
  command->add_flag("--quiet", state->quiet, "Print nothing but errors");
  command->callback([state, &exit_code] { exit_code = run(*state); });
}

}  // namespace clearcut::cli
