#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/infill.h>
#include <clearcut/part.h>
#include <clearcut/version.h>
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arguments/certificate_info.h"
#include "arguments/option_values.h"
#include "arguments/plan_arguments.h"
#include "commands/commands.h"
#include "terminal/output.h"

namespace clearcut::cli {
namespace {

struct InfillCommand {
  PlanArguments arguments;
  double width = 0, most_over_percent = 10, z = 0, feed = 1200, travel = 6000;
  std::optional<double> extrude, power;
  std::string strategy = "auto";
  std::optional<std::string> stepover;
  std::string output, certificate, check;
};

InfillOptions options_of(const InfillCommand& command) {
  if (command.extrude.has_value() == command.power.has_value())
    throw InputError("infill",
                     "state either --extrude, mm of filament for every mm of line, or --power of a laser");
  InfillOptions options;
  options.width = command.width;
  options.word = command.extrude ? LayingWord::kExtruded : LayingWord::kPower;
  options.rate = command.extrude ? *command.extrude : *command.power;
  options.strategy = command.strategy;
  options.stepover = command.stepover;
  options.most_over = command.most_over_percent / 100;
  options.z = command.z;
  options.feed = MmPerMin::of(command.feed);
  options.travel = MmPerMin::of(command.travel);
  return options;
}

int fill(const InfillCommand& command) {
  if (command.check.empty() == command.output.empty())
    throw InputError("infill", "state either -o, the program to write, or --check, one to be checked");
  const InfillOptions options = options_of(command);
  const Part part = command.arguments.read();
  print(part.diagnostics, true);
  auto files = command.arguments.input_files();
  InfillResult result;
  if (command.check.empty()) {
    result = plan_infill(part, options);
  } else {
    files.push_back({"program", command.check});
    result.program = read_file(command.check);
    result.findings = check_infill(part, result.program, command.check, options);
  }
  std::vector<OutputFile> outputs;
  if (!command.output.empty()) outputs.push_back({command.output, result.program});
  if (!command.certificate.empty()) {
    const std::string& name = command.output.empty() ? command.check : command.output;
    const CertificateBasis basis = certificate_basis("infill", files, name);
    outputs.push_back(
        {command.certificate,
         laid_certificate(result.findings, {kVersion, basis.arguments, basis.inputs, name, result.program,
                                            result.strategy, result.stepover})});
  }
  write_outputs(outputs, paths_of(files));
  if (!result.strategy.empty())
    print_line("strategy: " + result.strategy +
               (result.stepover.empty() ? "" : ", stepover " + result.stepover));
  print_line(with_colours(laid_table(result.findings)));
  return result.findings.is_clean() ? kClean : kFault;
}

}  // namespace

void add_infill_command(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("infill", "Fill areas with a line of constant width, for an extruder or a laser");
  command->group("Planning");
  auto state = std::make_shared<InfillCommand>();
  state->arguments.add_area_options(*command);
  command->option_defaults()->group("Line");
  command->add_option("--width", state->width, "Width of the line, mm")->required()->type_name("MM");
  command->add_option("--extrude", state->extrude, "Filament for every mm of line, mm: G1 with E words")
      ->type_name("MM");
  command->add_option("--power", state->power, "Power of the laser: G1 with S words")->type_name("S");
  command
      ->add_option("--over", state->most_over_percent,
                   "Greatest share of the area laid over what is covered already, percent; more is a fault")
      ->capture_default_str()
      ->type_name("PERCENT");
  command->add_option("--z", state->z, "Height of the layer, mm")->capture_default_str()->type_name("MM");
  command->add_option("--feed", state->feed, "Feed of the line, mm/min")
      ->capture_default_str()
      ->type_name("MM/MIN");
  command->add_option("--travel", state->travel, "Feed from line to line, mm/min")
      ->capture_default_str()
      ->type_name("MM/MIN");
  command->option_defaults()->group("Strategy");
  command
      ->add_option("--strategy", state->strategy,
                   "auto (default: the one that lays least over itself), or its name")
      ->check(one_of(strategy_names()));
  command
      ->add_option("--stepover", state->stepover,
                   "From line to line, as a share of the width (default: the widest that leaves no gap)")
      ->type_name("TEXT");
  command->option_defaults()->group("Output");
  command->add_option("-o,--output", state->output, "Program to write")->type_name("FILE");
  command->add_option("--check", state->check, "Program to check instead of planning one")->type_name("FILE");
  command->add_option("--certificate", state->certificate, "Certificate to write (JSON)")->type_name("FILE");
  command->callback([state, &exit_code] { exit_code = fill(*state); });
}

}  // namespace clearcut::cli
