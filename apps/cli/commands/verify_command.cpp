#include <clearcut/file.h>
#include <clearcut/report.h>
#include <clearcut/verify.h>

#include <memory>

#include "arguments/certificate_info.h"
#include "arguments/plan_arguments.h"
#include "arguments/suggest.h"
#include "commands/commands.h"
#include "terminal/output.h"
#include "terminal/terminal.h"

namespace clearcut::cli {
namespace {

struct VerifyCommand {
  PlanArguments arguments;
  std::string program;
  std::string json;
  std::string svg;
  std::optional<std::string> dialect;
  bool quiet = false;
};

std::optional<read::gcode::Dialect> dialect_of(const VerifyCommand& command) {
  if (!command.dialect) return std::nullopt;
  const auto dialect = read::gcode::dialect_named(*command.dialect);
  if (!dialect)
    throw InputError("--dialect",
                     "'" + *command.dialect +
                         "' is unknown; use one of linuxcnc, grbl, fanuc, haas, heidenhain, mach3, "
                         "mach4, marlin");
  return dialect;
}

/// As which control the program was read, where nobody has said.
std::string dialect_line(const VerifyCommand& command, const CheckResult& result) {
  if (command.dialect) return "";
  return "read as a program for " + std::string(name_of(result.dialect)) + " (--dialect names another)\n";
}

struct Judged {
  std::string program;
  CheckResult result;
  std::string certificate;
};

Judged judged(const VerifyCommand& command) {
  const PlanOptions options = command.arguments.options();
  Judged out;
  out.program = read_file(command.program);
  out.result =
      check_program(command.arguments.read(), out.program, command.program, options, dialect_of(command));
  CertificateBasis basis = certificate_basis("verify", command.arguments.input_files(), command.program);
  basis.dialect_stated = command.dialect.has_value();
  out.certificate = write_certificate(out.result, options, basis, out.program);
  return out;
}

int run(const VerifyCommand& command) {
  const Judged found = judged(command);
  const CheckResult& result = found.result;
  std::vector<OutputFile> files;
  if (!command.json.empty()) files.push_back({command.json, found.certificate});
  if (!command.svg.empty()) files.push_back({command.svg, write_picture(result)});
  std::vector<std::string> inputs = command.arguments.input_paths();
  inputs.push_back(command.program);
  write_outputs(files, inputs);
  if (!command.quiet) print(result.part.diagnostics, true);
  if (command.json != "-")
    print_line(with_colours(command.quiet
                                ? verdict_and_reasons(result.findings)
                                : dialect_line(command, result) + write_table(result, table_width())));
  return exit_code_of(result.findings);
}

std::shared_ptr<VerifyCommand> declare(CLI::App& command) {
  auto state = std::make_shared<VerifyCommand>();
  command.add_option("PROGRAM", state->program, "Program of any CAM: G-code or Klartext")
      ->required()
      ->type_name("FILE");
  state->arguments.add_part_options(command, "--part");
  state->arguments.add_tool_options(command);
  command.option_defaults()->group("Input");
  command
      .add_option("--dialect", state->dialect,
                  "Control that runs it: linuxcnc, grbl, fanuc, haas, heidenhain, mach3, mach4, marlin "
                  "(default: recognised)")
      ->check(one_of({"linuxcnc", "grbl", "fanuc", "haas", "heidenhain", "mach3", "mach4", "marlin"}));
  command.option_defaults()->group("Output");
  command.add_option("--json", state->json, "Certificate to write (- for standard output)")
      ->type_name("FILE");
  command.add_option("--svg", state->svg, "Picture to write")->type_name("FILE");
  command.add_flag("--quiet", state->quiet, "Print the verdict and its reasons alone, one on each line");
  return state;
}

}  // namespace

void add_verify_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("verify", "Judge any program against a part");
  command->group("Checking");
  auto state = declare(*command);
  command->callback([state, &exit_code] { exit_code = run(*state); });
}

std::string verify_certificate(const std::vector<std::string>& arguments) {
  CLI::App app;
  const auto state = declare(app);
  app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  remember_arguments(arguments);
  return judged(*state).certificate;
}

}  // namespace clearcut::cli
