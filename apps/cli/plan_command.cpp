#include <filesystem>
#include <memory>

#include "base/error.h"
#include "base/file.h"
#include "certificate_info.h"
#include "commands.h"
#include "output.h"
#include "pipeline/run.h"
#include "plan_arguments.h"
#include "report/certificate.h"
#include "report/contest_table.h"
#include "report/picture/svg.h"
#include "report/result.h"
#include "report/table.h"
#include "report/viewer/html.h"

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

report::CertificateInfo certificate_info(const PlanCommand& command, const resolve::PlanOptions& options,
                                         const pipeline::PlanResult& result) {
  report::CertificateInfo info = certificate_basis("plan", command.arguments.input_files(), options);
  info.program_name = command.output;
  info.program = result.program;
  info.contests = result.contests;
  return info;
}

std::vector<OutputFile> output_files(const PlanCommand& command, const resolve::PlanOptions& options,
                                     const pipeline::PlanResult& result) {
  std::vector<OutputFile> files{{command.output, result.program}};
  const auto add = [&](const std::string& path, auto&& content) {
    if (!path.empty()) files.push_back({path, content()});
  };
  add(command.certificate, [&] {
    return report::certificate_json(result.part, result.findings, certificate_info(command, options, result));
  });
  add(command.svg, [&] { return report::svg(result.part, result.toolpath, result.findings, {}); });
  add(command.html, [&] {
    return report::html(result.part, result.toolpath, result.findings, {options.machine, result.program});
  });
  add(command.result, [&] {
    return report::result_file(result.toolpath, {result.part.name, result.contours});
  });
  return files;
}

std::string in_folder_of(const std::string& job_file, const std::string& name) {
  return (std::filesystem::path(job_file).parent_path() / name).string();
}

/// Files that the command line leaves open are written where the job says.
void take_outputs_from(const read::JobFile& job, PlanCommand& command) {
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
  const resolve::PlanOptions options = command.arguments.options();
  const pipeline::PlanResult result = pipeline::plan_part(command.arguments.read(), options);
  write_files(output_files(command, options, result));
  if (!command.quiet) {
    print(result.part.diagnostics, true);
    if (command.output != "-") {
      if (options.strategy == "auto") print_line(report::plain(report::contest_table(result.contests)));
      print_line(report::table(result.part, result.findings));
    }
  }
  return exit_code_of(result.findings);
}

std::shared_ptr<PlanCommand> declare(CLI::App& command) {
  auto state = std::make_shared<PlanCommand>();
  state->arguments.add_part_options(command, "INPUT");
  state->arguments.add_tool_options(command);
  state->arguments.add_cutting_options(command);
  command.add_option("-o,--output", state->output, "Program to write (- for standard output)");
  command.add_option("--certificate", state->certificate, "Certificate to write (JSON)");
  command.add_option("--svg", state->svg, "Picture to write");
  command.add_option("--report", state->html, "Animated report to write (HTML)");
  command.add_option("--result", state->result, "Segments to write: x y to x y per line");
  command.add_flag("--quiet", state->quiet, "Print nothing but errors");
  return state;
}

}  // namespace

void add_plan_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("plan", "Plan a part, write its program and certify it");
  auto state = declare(*command);
  command->callback([state, &exit_code] { exit_code = run(*state); });
}

std::string plan_certificate(const std::vector<std::string>& arguments) {
  CLI::App app;
  const auto state = declare(app);
  app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  PlanCommand command = *state;
  if (const auto job = command.arguments.job()) take_outputs_from(*job, command);
  remember_arguments(arguments);
  const resolve::PlanOptions options = command.arguments.options();
  const pipeline::PlanResult result = pipeline::plan_part(command.arguments.read(), options);
  return report::certificate_json(result.part, result.findings, certificate_info(command, options, result));
}

}  // namespace clearcut::cli
