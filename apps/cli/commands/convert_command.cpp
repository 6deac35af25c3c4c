#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/part.h>
#include <clearcut/plan.h>
#include <clearcut/report.h>
#include <clearcut/setups.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "arguments/plan_arguments.h"
#include "commands/commands.h"
#include "terminal/output.h"

namespace clearcut::cli {
namespace {

/// Neither format has words for features made by a cutter's shape.
void refuse_shaped(const Part& part, const std::string& output) {
  for (const Feature& feature : part.features) {
    if (!feature.carving && !feature.chamfer && !feature.hole) continue;
    const char* what = feature.carving   ? "V-carvings"
                       : feature.chamfer ? "chamfers"
                                         : "threads and the other words of holes";
    throw InputError(output, feature.name + ": " + what +
                                 " cannot be written to this kind of file; leave them out with --op ignore:" +
                                 feature.source);
  }
}

/// What its entity and the moves that are written with a hole say of it. Threads of mills have no word in the standard.
bool is_said_by_moves(const HoleForm& hole) {
  return hole.kind != HoleKind::kThreadMilled;
}

void refuse_shaped_with_toolpaths(Part part, const std::string& output) {
  for (Feature& feature : part.features) {
    if (feature.hole && is_said_by_moves(*feature.hole)) feature.hole.reset();
    feature.chamfer.reset();
  }
  refuse_shaped(part, output);
}

bool is_stepnc(const std::string& output) {
  const auto extension = std::filesystem::path(output).extension();
  return extension == ".p21" || extension == ".stpnc";
}

std::string converted(Part& part, const PlanArguments& arguments, const std::string& output) {
  refuse_shaped(part, output);
  if (std::filesystem::path(output).extension() == ".json") return write_outline_json(part);
  if (is_stepnc(output)) {
    part = with_tools(std::move(part), arguments.options());
    return write_stepnc(part);
  }
  throw InputError(output, "the kind of file is unknown; name it .json (outline) or .p21 (STEP-NC)");
}

struct ConvertCommand {
  PlanArguments arguments;
  std::string output;
  bool with_toolpaths = false;
};

int convert(const ConvertCommand& command) {
  if (const std::string idle = command.arguments.typed_for_planning(); !idle.empty())
    throw InputError("--" + idle, "has no effect: nothing is planned without --with-toolpaths; leave it out");
  Part part = command.arguments.read();
  write_outputs({{command.output, converted(part, command.arguments, command.output)}},
                paths_of(command.arguments.input_files()));
  print(part.diagnostics, true);
  return kClean;
}

/// The set-ups to be written, and what is said of them.
struct ConvertedSetups {
  std::vector<WrittenSetup> written;
  std::vector<Findings> findings;  ///< of each written one
  std::vector<std::string> inputs;
  std::vector<std::pair<int, NothingToMachine>> left_out;  ///< by their numbers
};

/// The set-ups, each on the stock left by earlier ones. Of a STEP-NC program those in which nothing can be machined
/// are left out.
ConvertedSetups converted_setups(const ConvertCommand& command, int count) {
  ConvertedSetups out;
  std::vector<MachinedSetup> machined;
  for (int number = 1; number <= count; ++number) {
    PlanArguments arguments = command.arguments;
    ChosenSetup& setup = arguments.setup();
    setup.number = number;
    setup.machined = machined;
    if (number > 1 && machined.empty()) setup.earlier_programs.assign(out.left_out.size(), kNoProgram);
    try {
      const Part part = arguments.read();
      for (const std::string& path : paths_of(arguments.input_files())) out.inputs.push_back(path);
      PlanResult result = plan_part(part, arguments.options());
      machined.push_back({result.part, result.toolpath, setup.place});
      refuse_shaped_with_toolpaths(result.part, command.output);
      print(result.part.diagnostics, true);
      out.written.push_back({std::move(result.part), std::move(result.planned), setup.place});
      out.findings.push_back(std::move(result.findings));
    } catch (const NothingToMachine& why) {
      if (arguments.job()) throw;
      out.left_out.emplace_back(number, why);
    }
  }
  if (out.written.empty()) throw out.left_out.front().second;
  return out;
}

int convert_setups(const ConvertCommand& command, int count) {
  const ConvertedSetups setups = converted_setups(command, count);
  write_outputs({{command.output, write_stepnc(setups.written)}}, setups.inputs);
  int exit_code = kClean;
  for (const auto& [number, why] : setups.left_out) {
    print_left_out(number, why, true);
    if (!why.is_done()) exit_code = kFault;
  }
  for (std::size_t i = 0; i < setups.written.size(); ++i) {
    print_line(setups.written[i].part.name + ": " + with_colours(verdict_and_reasons(setups.findings[i])));
    exit_code = std::max(exit_code, static_cast<int>(exit_code_of(setups.findings[i])));
  }
  return exit_code;
}

/// The planned part, with the moves of its program.
int convert_with_toolpaths(const ConvertCommand& command) {
  if (!is_stepnc(command.output))
    throw InputError(command.output,
                     "holds no toolpaths; name it .p21 (STEP-NC), or leave --with-toolpaths out");
  if (command.arguments.setup().number == 0)
    if (const int setups = setup_count_of(command.arguments.input()); setups > 1)
      return convert_setups(command, setups);
  const Part part = command.arguments.read();
  const PlanResult result = plan_part(part, command.arguments.options());
  refuse_shaped_with_toolpaths(result.part, command.output);
  write_outputs({{command.output, write_stepnc(result.part, result.planned)}},
                paths_of(command.arguments.input_files()));
  print(result.part.diagnostics, true);
  print_line(with_colours(verdict_and_reasons(result.findings)));
  return exit_code_of(result.findings);
}

}  // namespace

void add_convert_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("convert", "Write a part as outline JSON or STEP-NC");
  command->group("Reading");
  auto state = std::make_shared<ConvertCommand>();
  state->arguments.add_plan_options(*command);
  command->option_defaults()->group("Output");
  command->add_option("-o,--output", state->output, "File to write: .json or .p21")
      ->required()
      ->type_name("FILE");
  command->add_flag("--with-toolpaths", state->with_toolpaths,
                    "Plan the part and write its moves into the STEP-NC file as toolpaths");
  command->callback([state, command, &exit_code] {
    state->arguments.take_sources(*command);
    exit_code = state->with_toolpaths ? convert_with_toolpaths(*state) : convert(*state);
  });
}

namespace {

/// The job for the typed options; its files are named relative to its folder.
std::string job_of(const PlanArguments& arguments, const std::string& output) {
  const auto folder = std::filesystem::absolute(output == "-" ? "." : output).parent_path();
  const auto beside = [&](const std::string& file) {
    const auto path = std::filesystem::absolute(file);
    const auto relative = output == "-" ? std::filesystem::path(file) : path.lexically_relative(folder);
    return (relative.empty() ? path : relative).generic_string();
  };
  StatedOptions stated = arguments.stated();
  for (auto* file : {&stated.asked.input.stock_from, &stated.asked.input.after,
                     &stated.asked.input.tool_library, &stated.asked.input.machine_file})
    if (*file) *file = beside(**file);
  return job_text(arguments.with_typed_tools(arguments.read()), beside(arguments.input()), stated);
}

}  // namespace

void add_init_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("init", "Write a commented job file for a part");
  command->group("Reading");
  auto state = std::make_shared<PlanArguments>();
  auto output = std::make_shared<std::string>();
  state->add_plan_options(*command);
  command->option_defaults()->group("Output");
  command->add_option("-o,--output", *output, "Job to write (default: standard output)")->type_name("FILE");
  command->callback([state, output, &exit_code] {
    const std::string path = output->empty() ? "-" : *output;
    write_outputs({{path, job_of(*state, path)}}, paths_of(state->input_files()));
    exit_code = kClean;
  });
}

}  // namespace clearcut::cli
