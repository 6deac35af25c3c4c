#include <clearcut/elements.h>
#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/report.h>

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "arguments/certificate_info.h"
#include "arguments/option_values.h"
#include "arguments/plan_arguments.h"
#include "commands/commands.h"
#include "commands/research.h"
#include "research_commands.h"
#include "terminal/output.h"
#include "terminal/progress.h"

namespace clearcut::cli {
namespace {

/// Options with one element each, and their placeholders.
constexpr std::array<std::pair<const char*, const char*>, 5> kElementOptions{
    {{"line",
      "Groove: X1,Y1,X2,Y2, then any of :T2 :depth=MM :stepdown=MM :feed=MM/MIN :id=NAME, as after all of "
      "these"},
     {"arc", "Curved groove: X1,Y1,X2,Y2,RADIUS,cw|ccw[:...]"},
     {"pocket", "Rectangle: X,Y,LENGTH,WIDTH[:corner=upper-right][:...]"},
     {"hole", "Hole: X,Y,DIAMETER[:...]"},
     {"slot", "Slot between the centres of its round ends: X1,Y1,X2,Y2,WIDTH[:...]"}}};

struct ElementsCommand {
  std::string input;
  std::map<std::string, std::vector<std::string>> typed;  ///< typed elements by kind
  std::vector<ElementOption> elements;                    ///< the same in the order they were typed
  ElementDefaults defaults;
  std::vector<std::string> tools;
  bool strict = false;
  std::string output;
  std::string certificate;
  std::string svg;
  std::string html;
  std::string points;
  bool print_points = false;
  bool all_squares = false;
  OptionValues solver;
  bool table = false;
  void (*print_reductions)() = nullptr;
  bool quiet = false;
  PlanOptions options;
};

ElementJob job_of(const ElementsCommand& command) {
  if (!command.input.empty() && !command.elements.empty())
    throw InputError("elements", "takes a job file or elements as options, not both");
  if (!command.input.empty()) return read_elements(command.input);
  ElementDefaults defaults = command.defaults;
  for (const auto& tool : command.tools) defaults.tools.push_back(parse_tool(tool));
  if (command.strict) defaults.middle_row = MiddleRow::kStrict;
  return elements_of_options(command.elements, defaults);
}

CertificateBasis basis_of(const ElementsCommand& command) {
  std::vector<CertificateFileName> files;
  if (!command.input.empty()) files.push_back({"job", command.input});
  return certificate_basis("elements", files, command.output);
}

std::vector<OutputFile> output_files(const ElementsCommand& command, const ElementJob& job,
                                     const ElementsResult& result) {
  const auto& plan = result.plan;
  std::vector<OutputFile> files{{command.output, plan.program}};
  if (!command.certificate.empty())
    files.push_back({command.certificate, write_certificate(plan, command.options, basis_of(command))});
  if (!command.svg.empty()) files.push_back({command.svg, grid_picture(job, result.points, plan.toolpath)});
  if (!command.html.empty())
    files.push_back({command.html, grid_page(job, result.points, plan.toolpath, result.searches)});
  if (!command.points.empty()) files.push_back({command.points, points_csv(job, result.points)});
  return files;
}

/// Plans with a line of progress.
ElementsResult planned(const ElementsCommand& command, const ElementJob& job) {
  PlanOptions options = command.options;
  std::optional<ProgressLine> line;
  if (!command.quiet) {
    line.emplace(kCancel);
    options.progress = line->callback();
  }
  return plan_elements(job, options);
}

int run(const ElementsCommand& command) {
  if (command.table) {
    command.print_reductions();
    return kClean;
  }
  if ((command.input.empty() && command.elements.empty()) || command.output.empty())
    throw InputError("elements",
                     "needs a job or elements and a program to write: clearcut elements JOB.toml -o OUT.ngc");
  const ElementJob job = job_of(command);
  const ElementsResult result = planned(command, job);
  write_outputs(output_files(command, job, result), {command.input});
  if (!command.quiet) {
    print(result.plan.part.diagnostics, true);
    if (command.print_points) print_table(points_table(job, result.points));
    if (command.output != "-") {
      print_table(element_table(result));
      if (command.all_squares) print_table(square_table(search_squares(job, result.points, command.options)));
      print_line(with_colours(write_table(result.plan, table_width())));
    }
  }
  return exit_code_of(result.plan.findings);
}

/// Elements are numbered in the order they were typed, regardless of their kinds.
std::vector<ElementOption> in_typed_order(const CLI::App& command, const ElementsCommand& state) {
  std::map<std::string, std::size_t> taken;
  std::vector<ElementOption> elements;
  for (const CLI::Option* option : command.parse_order()) {
    const std::string kind = option->get_single_name();
    const auto typed = state.typed.find(kind);
    if (typed != state.typed.end()) elements.push_back({kind, typed->second.at(taken[kind]++)});
  }
  return elements;
}

void add_element_options(CLI::App& command, ElementsCommand& state) {
  const std::string group = "Elements";
  for (const auto& [kind, help] : kElementOptions) {
    command.add_option(std::string("--") + kind, state.typed[kind], help)
        ->allow_extra_args(false)
        ->group(group);
  }
  auto& defaults = state.defaults;
  command.add_option("--tool", state.tools, "KIND:DIAMETER[:T2]..., for elements given as options")
      ->allow_extra_args(false)
      ->group(group);
  command.add_option("--depth", defaults.depth, "Depth of elements without a depth of their own, mm")
      ->group(group);
  command.add_option("--stepdown", defaults.stepdown, "Depth of one layer, mm")
      ->check(CLI::PositiveNumber)
      ->group(group);
  command.add_option("--stock", defaults.stock, "X0,X1,Y0,Y1,Z0,Z1; default: around the elements")
      ->group(group);
  command.add_option("--resolution", defaults.resolution, "Side of a square, mm (1)")
      ->check(CLI::PositiveNumber)
      ->group(group);
  command.add_flag("--strict", state.strict, "Drop a middle row that both edges reach")->group(group);
}

}  // namespace

void add_elements_command(CLI::App& app, int& exit_code, void (*print_reductions)()) {
  auto* command = add_research_command(app, kElements);
  auto state = std::make_shared<ElementsCommand>();
  command->option_defaults()->group("Input");
  command->add_option("JOB", state->input, "Job of lines, arcs, rectangles, holes and slots (TOML)")
      ->type_name("FILE");
  add_element_options(*command, *state);
  command->option_defaults()->group("Output");
  command->add_option("-o,--output", state->output, "Program to write (- for standard output)")
      ->type_name("FILE");
  command->add_option("--certificate", state->certificate, "Certificate to write (JSON)")->type_name("FILE");
  command->add_option("--svg", state->svg, "Picture of squares, reduced squares and tool impact to write")
      ->type_name("FILE");
  command
      ->add_option("--html", state->html,
                   "Page to write: elements, tools, squares, animated visit, convergence, all points")
      ->type_name("FILE");
  command->add_option("--points", state->points, "Table of all points to write (CSV)")->type_name("FILE");
  command->add_flag("--print-points", state->print_points, "Print the table of all points");
  command->add_flag(
      "--all-squares", state->all_squares,
      "Let the published algorithm order all squares of each element, too, and print its times with and "
      "without reduction");
  command->option_defaults()->group("Controller");
  command
      ->add_option("--post", state->options.post.dialect,
                   "Controller: " + controllers_text() + "; default linuxcnc")
      ->check(one_of(controller_names()));
  command->option_defaults()->group("Search");
  command->add_option("--seed", state->options.seed, "Seed of the search (default 1)")->check(is_seed());
  state->solver.add(
      *command, [](const Row& row) { return row.name == "solver" || row.group == Group::kPublishedSolver; });
  command->option_defaults()->group("Output");
  state->print_reductions = print_reductions;
  if (print_reductions != nullptr)
    command->add_flag("--table", state->table,
                      "Print the published table of reductions beside Clearcut's figures");
  command->add_flag("--quiet", state->quiet, "Print nothing but errors");
  command->callback([state, command, &exit_code] {
    state->options.published.solver = state->solver.asked().plan.published.solver;
    if (state->options.published.solver) check_solver(*state->options.published.solver);
    state->elements = in_typed_order(*command, *state);
    exit_code = run(*state);
  });
}

}  // namespace clearcut::cli
