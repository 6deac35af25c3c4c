#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/part.h>
#include <clearcut/plan.h>

#include <filesystem>
#include <memory>

#include "arguments/plan_arguments.h"
#include "commands/commands.h"
#include "terminal/output.h"

namespace clearcut::cli {
namespace {

/// Neither format has words for what follows from a cutter's shape.
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

std::string converted(Part& part, const PlanArguments& arguments, const std::string& output) {
  const auto extension = std::filesystem::path(output).extension();
  refuse_shaped(part, output);
  if (extension == ".json") return write_outline_json(part);
  if (extension == ".p21" || extension == ".stpnc") {
    part = with_tools(std::move(part), arguments.options());
    return write_stepnc(part);
  }
  throw InputError(output, "the kind of file is unknown; name it .json (outline) or .p21 (STEP-NC)");
}

}  // namespace

void add_convert_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("convert", "Write a part as outline JSON or STEP-NC");
  command->group("Reading");
  auto state = std::make_shared<PlanArguments>();
  auto output = std::make_shared<std::string>();
  state->add_part_options(*command, "INPUT");
  state->add_tool_list_options(*command);
  command->option_defaults()->group("Output");
  command->add_option("-o,--output", *output, "File to write: .json or .p21")->required()->type_name("FILE");
  command->callback([state, output, &exit_code] {
    Part part = state->read();
    write_outputs({{*output, converted(part, *state, *output)}}, paths_of(state->input_files()));
    print(part.diagnostics, true);
    exit_code = kClean;
  });
}

namespace {

/// The job of what was typed; the files that it names are found from its folder.
std::string job_of(const PlanArguments& arguments, const std::string& output) {
  const auto folder = std::filesystem::absolute(output == "-" ? "." : output).parent_path();
  const auto beside = [&](const std::string& file) {
    const auto path = std::filesystem::absolute(file);
    const auto relative = output == "-" ? std::filesystem::path(file) : path.lexically_relative(folder);
    return relative.empty() ? path.string() : relative.string();
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
  state->add_part_options(*command, "INPUT");
  state->add_tool_options(*command);
  state->add_cutting_options(*command);
  command->option_defaults()->group("Output");
  command->add_option("-o,--output", *output, "Job to write (default: standard output)")->type_name("FILE");
  command->callback([state, output, &exit_code] {
    const std::string path = output->empty() ? "-" : *output;
    write_outputs({{path, job_of(*state, path)}}, paths_of(state->input_files()));
    exit_code = kClean;
  });
}

}  // namespace clearcut::cli
