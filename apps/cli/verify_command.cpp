#include <clearcut/file.h>
#include <clearcut/report.h>
#include <clearcut/verify.h>

#include <memory>

#include "commands.h"
#include "output.h"
#include "plan_arguments.h"

namespace clearcut::cli {
namespace {

struct VerifyCommand {
  PlanArguments arguments;
  std::string program;
  std::string json;
  std::string svg;
  bool quiet = false;
};

int run(const VerifyCommand& command) {
  const PlanOptions options = command.arguments.options();
  const std::string program = read_file(command.program);
  const CheckResult result = check_program(command.arguments.read(), program, command.program, options);
  std::vector<OutputFile> files;
  if (!command.json.empty()) {
    files.push_back(
        {command.json, write_certificate(result, options, read_file(command.arguments.input()), program)});
  }
  if (!command.svg.empty()) files.push_back({command.svg, write_picture(result)});
  write_outputs(files);
  if (!command.quiet) {
    print(result.part.diagnostics, true);
    if (command.json != "-") print_line(write_table(result));
  }
  return result.findings.all.clean ? kClean : kFault;
}

}  // namespace

void add_verify_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("verify", "Judge any program against a part");
  auto state = std::make_shared<VerifyCommand>();
  command->add_option("PROGRAM", state->program, "Program of any CAM: G-code or Klartext")->required();
  state->arguments.add_part_options(*command, "--part");
  state->arguments.add_tool_options(*command);
  command->add_option("--json", state->json, "Certificate to write (- for standard output)");
  command->add_option("--svg", state->svg, "Picture to write");
  command->add_flag("--quiet", state->quiet, "Print nothing but errors");
  command->callback([state, &exit_code] { exit_code = run(*state); });
}

}  // namespace clearcut::cli
