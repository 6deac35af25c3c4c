#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/plan.h>
#include <clearcut/report.h>
#include <clearcut/text.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "arguments/certificate_info.h"
#include "arguments/plan_arguments.h"
#include "commands/commands.h"
#include "terminal/output.h"
#include "terminal/progress.h"
#include "terminal/terminal.h"

namespace clearcut::cli {
namespace {

struct PlanCommand {
  PlanArguments arguments;
  std::string output;
  std::string certificate;
  std::string svg;
  std::string html;
  std::string sheet;
  std::string result;
  bool quiet = false;
  bool explain = false;
};

CertificateBasis basis_of(const PlanCommand& command) {
  return certificate_basis("plan", command.arguments.input_files(), command.output);
}

const std::string kCancel = "Ctrl-C stops; nothing is written before the end.";

std::vector<OutputFile> output_files(const PlanCommand& command, const PlanOptions& options,
                                     const PlanResult& result) {
  std::vector<OutputFile> files{{command.output, result.program}};
  const auto add = [&](const std::string& path, auto&& content) {
    if (!path.empty()) files.push_back({path, content()});
  };
  add(command.certificate, [&] { return write_certificate(result, options, basis_of(command)); });
  add(command.svg, [&] { return write_picture(result); });
  add(command.html, [&] { return write_page(result, options); });
  add(command.sheet, [&] { return write_setup_sheet(result, options, file_name(command.output)); });
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
  take(command.sheet, job.output.setup_sheet);
  take(command.result, job.output.result);
}

/// The values alone, without planning.
int explain(const Part& part, const PlanOptions& options) {
  const ResolvedPlan plan = resolve_plan(part, options);
  print(plan.part.diagnostics, true);
  print_line(write_values(plan.part, plan.values, table_width()));
  return kClean;
}

std::vector<std::string> output_names(const PlanCommand& command) {
  std::vector<std::string> names;
  for (const auto* name : {&command.output, &command.certificate, &command.svg, &command.html, &command.sheet,
                           &command.result}) {
    if (!name->empty()) names.push_back(*name);
  }
  return names;
}

/// m of path above which planning may be felt.
constexpr double kLongPath = 100;

/// How much there is to cut, where that is much.
std::string hint_of(const Part& part, const PlanOptions& options) {
  const auto& tools = options.tools.empty() ? part.tools : options.tools;
  if (tools.empty()) return kCancel;
  double widest = 0, path = 0;
  for (const Tool& tool : tools) widest = std::max(widest, tool.diameter);
  const double down = options.stepdown.value_or(widest / 2);
  for (const Feature& feature : part.features)
    path += area(feature.target) * (feature.top_z - feature.floor_z) / (down * widest / 2) / 1000;
  if (path < kLongPath) return kCancel;
  return fmt::format(
      "about {:.0f} m of path with a cutter of {} mm; a wider cutter or a larger --stepdown makes it less. "
      "{}",
      path, trimmed(widest, 4), kCancel);
}

/// Plans while a line says how far it is; warnings of reading do not vanish behind an error.
PlanResult planned(const PlanCommand& command, const Part& part, PlanOptions options) {
  try {
    std::optional<ProgressLine> line;
    if (!command.quiet) {
      line.emplace(hint_of(part, options));
      options.progress = line->callback();
    }
    return plan_part(part, options);
  } catch (const InputError&) {
    print_warnings(part.diagnostics);
    throw;
  }
}

int run(PlanCommand command) {
  if (const auto job = command.arguments.job()) take_outputs_from(*job, command);
  const Part part = command.arguments.read();
  const PlanOptions options = command.arguments.options();
  if (command.output.empty() && command.explain) return explain(part, options);
  if (command.output.empty()) throw InputError("--output", "is missing; name the program to write");
  const std::vector<std::string> inputs = command.arguments.input_paths();
  check_outputs(output_names(command), inputs);
  const PlanResult result = planned(command, part, options);
  write_outputs(output_files(command, options, result), inputs);
  if (command.explain) print_line(write_values(result.part, result.values, table_width()));
  if (command.quiet) {
    if (command.output != "-") print_line(with_colours(verdict_and_reasons(result.findings)));
  } else {
    print(result.part.diagnostics, true);
    if (command.output != "-") {
      for (const auto& name : names_not_machined(result.part.diagnostics))
        print_line("NOT MACHINED: " + name);
      if (options.strategy.value_or("auto") == "auto")
        print_line(write_selection_table(result, table_width()));
      print_line(with_colours(write_table(result, table_width())));
    }
  }
  return exit_code_of(result.findings);
}

std::shared_ptr<PlanCommand> declare(CLI::App& command) {
  auto state = std::make_shared<PlanCommand>();
  state->arguments.add_part_options(command, "INPUT");
  state->arguments.add_tool_options(command);
  state->arguments.add_cutting_options(command);
  command.option_defaults()->group("Output");
  command.add_option("-o,--output", state->output, "Program to write (- for standard output)")
      ->type_name("FILE");
  command.add_option("--certificate", state->certificate, "Certificate to write (JSON)")->type_name("FILE");
  command.add_option("--svg", state->svg, "Picture to write")->type_name("FILE");
  command.add_option("--report", state->html, "Animated report to write (HTML)")->type_name("FILE");
  command.add_option("--setup-sheet", state->sheet, "Set-up sheet to write (HTML, prints on one page)")
      ->type_name("FILE");
  command.add_option("--result", state->result, "Segments to write: x y to x y per line")->type_name("FILE");
  command.add_flag("--explain", state->explain, "Print every value of the plan and where it comes from");
  command.add_flag("--quiet", state->quiet, "Print the verdict and its reasons alone, one on each line");
  return state;
}

}  // namespace

void add_plan_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("plan", "Plan a part, write its program and certify it");
  command->group("Planning");
  auto state = declare(*command);
  command->callback([state, command, &exit_code] {
    state->arguments.take_sources(*command);
    exit_code = run(*state);
  });
}

std::string plan_certificate(const std::vector<std::string>& arguments) {
  CLI::App app;
  const auto state = declare(app);
  app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  state->arguments.take_sources(app);
  PlanCommand command = *state;
  if (const auto job = command.arguments.job()) take_outputs_from(*job, command);
  remember_arguments(arguments);
  const Part part = command.arguments.read();
  const PlanOptions options = command.arguments.options();
  return write_certificate(plan_part(part, options), options, basis_of(command));
}

}  // namespace clearcut::cli
