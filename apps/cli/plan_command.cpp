#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/plan.h>
#include <clearcut/report.h>

#include <filesystem>
#include <memory>

#include "commands.h"
#include "output.h"
#include "plan_arguments.h"

namespace clearcut::cli {
namespace {

struct PlanCommand {
  PlanArguments arguments;
  std::string output;
  std::string certificate;
  std::string svg;
  std::string html;
  std::string result;
  bool quiet = false;
};

std::vector<OutputFile> output_files(const PlanCommand& command, const PlanOptions& options,
                                     const PlanResult& result) {
  std::vector<OutputFile> files{{command.output, result.program}};
  const auto add = [&](const std::string& path, auto&& content) {
    if (!path.empty()) files.push_back({path, content()});
  };
  add(command.certificate,
      [&] { return write_certificate(result, options, read_file(command.arguments.input())); });
  add(command.svg, [&] { return write_picture(result); });
  add(command.html, [&] { return write_page(result, options); });
  add(command.result, [&] { return write_segments(result); });
  return files;
}

std::string in_folder_of(const std::string& job_file, const std::string& name) {
  return (std::filesystem::path(job_file).parent_path() / name).string();
}

/// Files that the command line leaves open are written where the job says.
void take_outputs_from(const JobFile& job, PlanCommand& command) {
  const auto take = [&](std::string& path, const std::optional<std::string>& from_job) {
    if (path.empty() && from_job) path = in_folder_of(job.file, *from_job);
  };
  take(command.output, job.output.program);
  take(command.certificate, job.output.certificate);
  take(command.svg, job.output.svg);
  take(command.html, job.output.report);
  take(command.result, job.output.result);
}

int run(PlanCommand command) {
  if (const auto job = command.arguments.job()) take_outputs_from(*job, command);
  if (command.output.empty()) throw InputError("--output", "is missing; name the program to write");
  const PlanOptions options = command.arguments.options();
  const PlanResult result = plan_part(command.arguments.read(), options);
  write_outputs(output_files(command, options, result));
  if (!command.quiet) {
    print(result.part.diagnostics, true);
    if (command.output != "-") {
      if (options.strategy == "auto") print_line(write_contest_table(result));
      print_line(write_table(result));
    }
  }
  return result.findings.all.clean ? kClean : kFault;
}

}  // namespace

void add_plan_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("plan", "Plan a part, write its program and certify it");
  auto state = std::make_shared<PlanCommand>();
  state->arguments.add_part_options(*command, "INPUT");
  state->arguments.add_tool_options(*command);
  state->arguments.add_cutting_options(*command);
  command->add_option("-o,--output", state->output, "Program to write (- for standard output)");
  command->add_option("--certificate", state->certificate, "Certificate to write (JSON)");
  command->add_option("--svg", state->svg, "Picture to write");
  command->add_option("--report", state->html, "Animated report to write (HTML)");
  command->add_option("--result", state->result, "Segments to write: x y to x y per line");
  command->add_flag("--quiet", state->quiet, "Print nothing but errors");
  command->callback([state, &exit_code] { exit_code = run(*state); });
}

}  // namespace clearcut::cli
