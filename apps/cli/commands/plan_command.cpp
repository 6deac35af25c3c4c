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
#include "commands/result_files.h"
#include "terminal/output.h"
#include "terminal/progress.h"

namespace clearcut::cli {
namespace {

struct PlanCommand {
  PlanArguments arguments;
  std::string output;
  std::string certificate;
  std::string svg;
  std::string animation;
  std::string html;
  std::string sheet;
  std::string result;
  std::string witness;
  bool quiet = false;
  bool explain = false;
  bool for_many = false;
};

CertificateBasis basis_of(const PlanCommand& command) {
  return certificate_basis("plan", command.arguments.input_files(), command.output);
}

std::vector<OutputFile> output_files(const PlanCommand& command, const PlanOptions& options,
                                     const PlanResult& result,
                                     const std::optional<CertificateProof>& proof = {}) {
  std::vector<OutputFile> files{{command.output, result.program}};
  const auto add = [&](const std::string& path, auto&& content) {
    if (!path.empty()) files.push_back({path, content()});
  };
  add(command.certificate, [&] {
    CertificateBasis basis = basis_of(command);
    basis.proof = proof;
    return write_certificate(result, options, basis);
  });
  add(command.svg, [&] { return write_picture(result); });
  add(command.animation, [&] { return write_animation(result, options); });
  add(command.html, [&] { return write_page(result, options); });
  add(command.sheet, [&] {
    return setup_sheet_file(command.sheet, setup_sheet_of(result, options, file_name(command.output)));
  });
  add(command.result, [&] { return write_segments(result); });
  return files;
}

/// Beside the job, and where that lies in a project file beside that.
std::string in_folder_of(const std::string& job_file, const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(job_file).parent_path();
  return ((is_project_name(folder.string()) ? folder.parent_path() : folder) / name).generic_string();
}

/// Output files not named on the command line are taken from the job.
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
  take(command.witness, job.output.witness);
}

/// Only the values, without planning.
int explain(const Part& part, const PlanOptions& options) {
  const ResolvedPlan plan = resolve_plan(part, options);
  print(plan.part.diagnostics, true);
  print_line(write_values(plan.part, plan.values, table_width()));
  return kClean;
}

std::vector<std::string> output_names(const PlanCommand& command) {
  std::vector<std::string> names;
  for (const auto* name : {&command.output, &command.certificate, &command.svg, &command.animation,
                           &command.html, &command.sheet, &command.result, &command.witness}) {
    if (!name->empty()) names.push_back(*name);
  }
  return names;
}

/// m; length of path above which planning may take noticeable time.
constexpr double kLongPath = 100;

/// Amount of cutting, if large.
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

/// Advice for making a slow plan faster.
std::string advice_of(const Part& part, const PlanOptions& options) {
  const std::string strategy = options.strategy.value_or("auto");
  const std::string faster = strategy == "zigzag" ? "" : "--strategy zigzag plans fastest, ";
  const std::string fewer =
      part.workplan.size() > 20
          ? fmt::format("; its {} workingsteps may be planned in parts (of drawings: --layer)",
                        part.workplan.size())
          : "";
  return fmt::format("this takes long: {}a wider cutter or a larger --stepdown makes less path{}", faster,
                     fewer);
}

/// Plans while a line says how far it is; warnings of reading do not vanish behind an error.
PlanResult planned(const PlanCommand& command, const Part& part, PlanOptions options) {
  try {
    std::optional<ProgressLine> line;
    if (!command.quiet) {
      line.emplace(hint_of(part, options), advice_of(part, options));
      options.progress = line->callback();
    }
    return plan_part(part, options);
  } catch (const InputError&) {
    print_warnings(part.diagnostics);
    throw;
  }
}

/// Prints the messages of a plan.
void tell(const PlanCommand& command, const PlanResult& result, const PlanOptions& options) {
  if (command.explain) print_line(write_values(result.part, result.values, table_width()));
  if (command.quiet) {
    if (command.output != "-") print_line(with_colours(verdict_and_reasons(result.findings)));
    if (command.output != "-" && result.margin) print_line(margin_line(*result.margin));
    return;
  }
  print(result.part.diagnostics, true);
  if (command.output == "-") return;
  for (const auto& name : names_not_machined(result.part.diagnostics)) print_line("NOT MACHINED: " + name);
  if (options.strategy.value_or("auto") == "auto") print_line(write_selection_table(result, table_width()));
  print_line(with_colours(write_table(result, table_width())));
  if (result.margin) print_line(margin_line(*result.margin));
}

/// One of several set-ups: its question and its plan.
struct PlannedSetup {
  PlanCommand command;
  PlanOptions options;
  PlanResult result;
  std::optional<NothingToMachine> left_out;  ///< why it has no program
};

/// "part.ngc" of the second set-up is "part-2.ngc".
void number_outputs(PlanCommand& command, int setup) {
  for (auto* path : {&command.output, &command.certificate, &command.svg, &command.animation, &command.html,
                     &command.result}) {
    if (path->empty()) continue;
    const std::filesystem::path file(*path);
    const std::string name = file.stem().string() + "-" + std::to_string(setup) + file.extension().string();
    *path = (file.parent_path() / name).generic_string();
  }
}

/// Reads and plans one set-up. In a STEP-NC program one of which nothing can be machined is left out.
void plan_setup(PlannedSetup& one) {
  PlanArguments& arguments = one.command.arguments;
  try {
    const Part part = arguments.read();
    one.options = arguments.options();
    if (one.options.copies.any())
      throw InputError(one.options.copies.name(),
                       "is for a part in one set-up; take one set-up with --setup");
    one.result = planned(one.command, part, one.options);
  } catch (const NothingToMachine& error) {
    if (arguments.job()) throw;
    one.left_out = error;
  }
}

/// The set-ups of a job one after the other, each on the stock left by earlier ones.
std::vector<PlannedSetup> all_setups(const PlanCommand& command, int count) {
  std::vector<PlannedSetup> setups;
  for (int number = 1; number <= count; ++number) {
    PlannedSetup one{command, {}, {}, {}};
    ChosenSetup& setup = one.command.arguments.setup();
    setup.number = number;
    for (const PlannedSetup& before : setups) {
      if (before.left_out) continue;
      setup.machined.push_back(
          {before.result.part, before.result.toolpath, before.command.arguments.setup().place});
    }
    if (number > 1 && setup.machined.empty()) setup.earlier_programs.assign(setups.size(), kNoProgram);
    number_outputs(one.command, number);
    plan_setup(one);
    setups.push_back(std::move(one));
  }
  const auto is_left_out = [](const PlannedSetup& one) { return one.left_out.has_value(); };
  if (std::all_of(setups.begin(), setups.end(), is_left_out)) throw *setups.front().left_out;
  return setups;
}

/// The set-ups that have programs.
std::vector<PlannedSetup> planned_setups(const PlanCommand& command, int count) {
  std::vector<PlannedSetup> setups = all_setups(command, count);
  std::erase_if(setups, [](const PlannedSetup& one) { return one.left_out.has_value(); });
  return setups;
}

int explain_setups(const PlanCommand& command, int count) {
  for (const PlannedSetup& one : planned_setups(command, count))
    print_line(write_values(one.result.part, one.result.values, table_width()));
  return kClean;
}

/// All input files of the set-ups.
std::vector<std::string> inputs_of_setups(const PlanCommand& command, int count) {
  std::vector<std::string> inputs = paths_of(command.arguments.input_files());
  for (int number = 1; number <= count; ++number) {
    PlanArguments one = command.arguments;
    one.setup().number = number;
    for (const std::string& path : paths_of(one.input_files())) inputs.push_back(path);
  }
  return inputs;
}

/// Output files of the set-ups, except the sheet.
std::vector<std::string> output_names_of_setups(PlanCommand command, int count) {
  command.sheet.clear();
  std::vector<std::string> names;
  for (int number = 1; number <= count; ++number) {
    PlanCommand one = command;
    number_outputs(one, number);
    for (const std::string& name : output_names(one)) names.push_back(name);
  }
  return names;
}

std::vector<OutputFile> files_of_setups(const std::vector<PlannedSetup>& setups, const std::string& sheet) {
  std::vector<OutputFile> files;
  std::vector<SetupSheet> sheets;
  for (const PlannedSetup& one : setups) {
    if (one.left_out) continue;
    PlanCommand others = one.command;
    others.sheet.clear();
    for (OutputFile& file : output_files(others, one.options, one.result)) files.push_back(std::move(file));
    if (!sheet.empty())
      sheets.push_back(setup_sheet_of(one.result, one.options, file_name(one.command.output)));
  }
  if (!sheet.empty()) files.push_back({sheet, setup_sheets_file(sheet, sheets)});
  return files;
}

std::string certificate_of_setup(PlanCommand command, int count, const std::string& program) {
  command.quiet = true;
  for (const PlannedSetup& one : planned_setups(command, count)) {
    const CertificateBasis basis = basis_of(one.command);
    if (basis.program_name == program) return write_certificate(one.result, one.options, basis);
  }
  throw InputError(program, "is no program of the job's set-ups now");
}

void refuse_for_setups(const PlanCommand& command, int count) {
  if (command.arguments.setup().number > 0)
    throw InputError("--setup", "the set-ups of a job are planned together; leave it out");
  if (!command.witness.empty())
    throw InputError("--witness", "is about one program; verify each program with --witness");
  if (command.output.empty() && !command.explain)
    throw InputError("--output", "is missing; name the program to write");
  if (command.output == "-")
    throw InputError("--output",
                     std::to_string(count) + " set-ups are as many programs; name a file for them");
}

/// A program for each set-up of which something can be machined, and one sheet with a page for each.
int run_setups(const PlanCommand& command, int count) {
  refuse_for_setups(command, count);
  if (command.output.empty()) return explain_setups(command, count);
  std::vector<std::string> names = output_names_of_setups(command, count);
  if (!command.sheet.empty()) names.push_back(command.sheet);
  const std::vector<std::string> inputs = inputs_of_setups(command, count);
  check_outputs(names, inputs);
  const std::vector<PlannedSetup> setups = all_setups(command, count);
  write_outputs(files_of_setups(setups, command.sheet), inputs);
  Verdict worst = Verdict::kClean;
  for (const PlannedSetup& one : setups) {
    if (one.left_out) {
      print_left_out(one.command.arguments.setup().number, *one.left_out, !one.command.quiet);
      if (!one.left_out->is_done()) worst = Verdict::kFaulty;
      continue;
    }
    print_line(one.result.part.name + ": " + one.command.output);
    tell(one.command, one.result, one.options);
    worst = std::max(worst, verdict_of(one.result.findings));
  }
  print_line(with_colours(std::to_string(count) + " set-ups, verdict: " + name_of(worst)));
  return worst == Verdict::kClean ? kClean : kFault;
}

void refuse_for_witness(const PlanCommand& command, const PlanOptions& options) {
  if (options.copies.any())
    throw InputError("--witness",
                     "is about the part as it was read, not about copies; leave one of them out");
  if (command.output == "-") throw InputError("--witness", "is about a program file; name it with --output");
}

Part read_with_progress(const PlanCommand& command) {
  std::optional<ProgressLine> line;
  if (!command.quiet) line.emplace("").expect("reading " + command.arguments.input());
  return command.arguments.read();
}

int run(PlanCommand command) {
  if (command.for_many) command.arguments.let_options_be_idle();
  if (const auto job = command.arguments.job()) take_outputs_from(*job, command);
  check_setup_sheet_name(command.sheet);
  if (const int setups = setup_count_of(command.arguments.input())) return run_setups(command, setups);
  const Part part = read_with_progress(command);
  const PlanOptions options = command.arguments.options();
  if (command.output.empty() && command.explain) return explain(part, options);
  if (command.output.empty()) throw InputError("--output", "is missing; name the program to write");
  const std::vector<std::string> inputs = paths_of(command.arguments.input_files());
  check_outputs(output_names(command), inputs);
  if (!command.witness.empty()) refuse_for_witness(command, options);
  const PlanResult result = planned(command, part, options);
  const Proven proven{result.part, result.toolpath, result.program, command.output,
                      command.arguments.input()};
  WitnessFile witness;
  std::optional<CertificateProof> proof;
  if (!command.witness.empty()) proof = proof_of(witness = witness_of(proven));
  std::vector<OutputFile> files = output_files(command, options, result, proof);
  const bool without =
      !command.witness.empty() && (witness.found.bytes.empty() || !witness.found.missing.empty());
  for (OutputFile& file : witness_files(witness, command.witness)) files.push_back(std::move(file));
  write_outputs(files, inputs);
  tell(command, result, options);
  if (result.copies && command.output != "-") print_line(parts_line(*result.copies));
  if (without || (!command.witness.empty() && !command.quiet))
    print_line(witness_lines(witness, command.witness, proven));
  return without || (result.copies && result.copies->misses()) ? kFault : exit_code_of(result.findings);
}

std::shared_ptr<PlanCommand> declare(CLI::App& command) {
  auto state = std::make_shared<PlanCommand>();
  state->arguments.add_plan_options(command);
  command.option_defaults()->group("Output");
  command.add_option("-o,--output", state->output, "Program to write (- for standard output)")
      ->type_name("FILE");
  command.add_option("--certificate", state->certificate, "Certificate to write (JSON)")->type_name("FILE");
  command.add_option("--svg", state->svg, "Picture to write")->type_name("FILE");
  command
      .add_option("--animation", state->animation,
                  "Picture to write in which the cutter moves, two minutes at most (SVG)")
      ->type_name("FILE");
  command.add_option("--report", state->html, "Animated report to write (HTML)")->type_name("FILE");
  command
      .add_option("--setup-sheet", state->sheet,
                  "Set-up sheet to write, for one printed page: HTML, or PDF for FILE.pdf")
      ->type_name("FILE");
  command.add_option("--result", state->result, "Segments to write: x y to x y per line")->type_name("FILE");
  command
      .add_option("--witness", state->witness,
                  "Witness to write: with it clearcut-check proves the program; of drawings and solids also "
                  "the outline, FILE.json")
      ->type_name("FILE");
  command.add_flag("--explain", state->explain, "Print every value of the plan with its origin");
  command
      .add_flag("--for-many", state->for_many,
                "The options are for many parts: an option without effect on this one is no error")
      ->group("");
  command.add_flag("--quiet", state->quiet, "Print only the verdict and its reasons, one on each line");
  return state;
}

}  // namespace

void add_plan_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("plan", "Plan a part, write its program and certify the program");
  command->group("Planning");
  auto state = declare(*command);
  command->callback([state, command, &exit_code] {
    state->arguments.take_sources(*command);
    exit_code = run(*state);
  });
}

std::string plan_certificate(const std::vector<std::string>& arguments, const std::string& program) {
  CLI::App app;
  const auto state = declare(app);
  app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  state->arguments.take_sources(app);
  PlanCommand command = *state;
  if (const auto job = command.arguments.job()) take_outputs_from(*job, command);
  remember_arguments(arguments);
  if (const int count = setup_count_of(command.arguments.input()))
    return certificate_of_setup(command, count, program);
  const Part part = command.arguments.read();
  const PlanOptions options = command.arguments.options();
  return write_certificate(plan_part(part, options), options, basis_of(command));
}

}  // namespace clearcut::cli
