#include <clearcut/file.h>
#include <clearcut/options.h>
#include <clearcut/report.h>
#include <clearcut/text.h>
#include <clearcut/verify.h>
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "arguments/certificate_info.h"
#include "arguments/option_values.h"
#include "arguments/plan_arguments.h"
#include "commands/commands.h"
#include "commands/result_files.h"
#include "terminal/output.h"
#include "terminal/progress.h"

namespace clearcut::cli {
namespace {

struct VerifyCommand {
  PlanArguments arguments;
  std::string program;
  std::optional<std::string> stock;
  std::string json;
  std::string svg;
  std::string animation;
  std::string html;
  std::string sheet;
  std::string witness;
  bool prove = false;
  bool quiet = false;
};

/// The recognised control of the program, if not stated.
std::string dialect_line(const VerifyCommand& command, const CheckResult& result) {
  if (command.arguments.dialect()) return "";
  return "read as a program for " + std::string(name_of(result.dialect)) + " (--dialect names another)\n";
}

bool asks_proof(const VerifyCommand& command) {
  return command.prove || !command.witness.empty();
}

struct Checked {
  std::string program;
  CheckResult result;
  std::string certificate;
  WitnessFile witness;
};

/// Without a part: against a stock.
CheckResult checked_alone(const VerifyCommand& command, const std::string& program,
                          const PlanOptions& options) {
  if (!command.sheet.empty())
    throw InputError("--setup-sheet", "needs --part: a set-up sheet names what is made");
  const std::optional<double> top = command.arguments.top();
  std::optional<Stock> stock;
  if (command.stock) stock = parse_stock(*command.stock, top.value_or(0));
  return check_program_alone(stock, program, command.program, options, command.arguments.dialect(), top);
}

Checked checked(const VerifyCommand& command) {
  PlanOptions options = command.arguments.options();
  std::optional<ProgressLine> line;
  if (!command.quiet) options.progress = line.emplace(kStops).callback();
  if (asks_proof(command) && options.copies.any())
    throw InputError("--copies",
                     "have no witness: it is about the part as it was read; leave one of them out");
  Checked out;
  out.program = read_file(command.program);
  out.result = command.arguments.input().empty()
                   ? checked_alone(command, out.program, options)
                   : check_program(command.arguments.read(), out.program, command.program, options,
                                   command.arguments.dialect());
  if (asks_proof(command))
    out.witness = witness_of(
        {out.result.part, out.result.toolpath, out.program, command.program, command.arguments.input()});
  CertificateBasis basis = certificate_basis("verify", command.arguments.input_files(), command.program);
  basis.dialect_stated = command.arguments.dialect().has_value();
  if (asks_proof(command)) basis.proof = proof_of(out.witness);
  out.certificate = write_certificate(out.result, options, basis, out.program);
  return out;
}

/// A requested but failed proof is a fault.
int tell_proof(const VerifyCommand& command, const WitnessFile& witness, const Proven& proven, int code) {
  const bool found = !witness.found.bytes.empty();
  if (!command.witness.empty() && (!found || !command.quiet))
    print_line(witness_lines(witness, command.witness, proven));
  bool proved = found && witness.found.missing.empty();
  if (command.prove) print_line(checked_by_program(witness, proven, proved));
  return proved ? code : kFault;
}

int run(const VerifyCommand& command) {
  check_setup_sheet_name(command.sheet);
  if (asks_proof(command) && command.arguments.input().empty())
    throw InputError("--witness", "is about a program and a part; name the part with --part");
  const Checked found = checked(command);
  const CheckResult& result = found.result;
  std::vector<OutputFile> files;
  if (!command.json.empty()) files.push_back({command.json, found.certificate});
  if (!command.svg.empty()) files.push_back({command.svg, write_picture(result)});
  if (!command.animation.empty())
    files.push_back({command.animation, write_animation(result, command.arguments.options())});
  if (!command.html.empty())
    files.push_back({command.html, write_page(result, command.arguments.options(), found.program)});
  if (!command.sheet.empty())
    files.push_back(
        {command.sheet, setup_sheet_file(command.sheet, setup_sheet_of(result, command.arguments.options(),
                                                                       file_name(command.program)))});
  const Proven proven{result.part, result.toolpath, found.program, command.program,
                      command.arguments.input()};
  const WitnessFile& witness = found.witness;
  for (OutputFile& file : witness_files(witness, command.witness)) files.push_back(std::move(file));
  std::vector<std::string> inputs = paths_of(command.arguments.input_files());
  inputs.push_back(command.program);
  write_outputs(files, inputs);
  if (!command.quiet) print(result.part.diagnostics, true);
  if (command.json != "-")
    print_line(with_colours(command.quiet
                                ? verdict_and_reasons(result.findings)
                                : dialect_line(command, result) + write_table(result, table_width())));
  if (result.margin) print_line(margin_line(*result.margin));
  if (result.copies && command.json != "-") print_line(parts_line(*result.copies));
  return asks_proof(command) ? tell_proof(command, witness, proven, exit_code_of(result.findings))
                             : exit_code_of(result.findings);
}

/// The program, the part and the tools: common to verify and setup-sheet.
std::shared_ptr<VerifyCommand> declare_question(CLI::App& command) {
  auto state = std::make_shared<VerifyCommand>();
  command.add_option("PROGRAM", state->program, "Program of any CAM: G-code or Klartext")
      ->required()
      ->type_name("FILE");
  state->arguments.add_check_options(command);
  command.option_defaults()->group("Input");
  state->arguments.add_dialect_option(command);
  return state;
}

/// A part may be left out; options on the part are then refused, and the stock may be stated.
void let_part_be_absent(CLI::App& command, VerifyCommand& state) {
  CLI::Option* part = command.get_option("--part")->required(false);
  for (const Row& row : rows())
    if (row.checks & kCheckOfPart && !(row.checks & kCheckOfProgram))
      command.get_option("--" + row.name)->needs(part);
  command.option_defaults()->group("Input");
  command
      .add_option(
          "--stock", state.stock,
          "X,Y,Z of the block, without a part: sizes from X 0, Y 0 and down from --top, or each as LOW:HIGH "
          "(default: the box of what is cut below --top)")
      ->excludes(part);
}

std::shared_ptr<VerifyCommand> declare(CLI::App& command) {
  auto state = declare_question(command);
  let_part_be_absent(command, *state);
  command.option_defaults()->group("Output");
  command.add_option("--json", state->json, "Certificate to write (- for standard output)")
      ->type_name("FILE");
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
  command
      .add_option("--witness", state->witness,
                  "Witness to write: with it clearcut-check proves the program; of drawings and solids also "
                  "the outline, FILE.json")
      ->type_name("FILE");
  command.add_flag("--prove", state->prove,
                   "Find a witness and check it with the independent program clearcut-check");
  command.add_flag("--quiet", state->quiet, "Print only the verdict and its reasons, one on each line");
  return state;
}

}  // namespace

void add_verify_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("verify", "Check any program, against a part or without one");
  command->group("Checking");
  auto state = declare(*command);
  command->callback([state, &exit_code] { exit_code = run(*state); });
}

namespace {

/// Rule of the feeds, and the changes: "feeds go by the chip at 90 degrees and 1000 mm/min (T1)", then words and
/// times.
std::string feeds_lines(const ProgramFeeds& feeds, const PlanOptions& options) {
  std::string tools;
  for (const auto& [number, feed] : feeds.reference_feeds)
    tools +=
        fmt::format("{}{} mm/min (T{})", tools.empty() ? "" : ", ", trimmed(feed.mm_per_min(), 3), number);
  const double before = feeds.before.findings.all.time_s, after = feeds.after.findings.all.time_s;
  const auto& most = feeds.after.findings.all.reference_load;
  return fmt::format(
      "feeds go by the {} at {} degrees and {}\ntime {:.1f} s, {:.1f} s before ({:+.1f} %); {} F words, {} "
      "before\ngreatest load {} % of the reference's\n",
      *options.shop.feed_by == FeedBy::kChip ? "chip" : "removal rate",
      trimmed(options.shop.reference_engagement_deg.value_or(90), 3), tools, after, before,
      before > 0 ? 100 * (after / before - 1) : 0.0, feeds.words_after, feeds.words_before,
      most ? fmt::format("{:.1f}", 100 * most->share) : "0");
}

/// Comments are no F words: Clearcut's header in the comments certifies another program.
void tell_of_header(const std::string& program) {
  if (program.find("CERTIFICATE: ") != std::string::npos &&
      program.find("MOTION SHA-256: ") != std::string::npos)
    print_line("note: the header certifies the program as it was before; what holds now is said below\n");
}

/// What the program is checked against; `part` keeps the part that the question points to.
ProgramQuestion question_of(const VerifyCommand& command, std::optional<Part>& part) {
  ProgramQuestion question;
  question.dialect = command.arguments.dialect();
  question.top = command.arguments.top();
  if (command.stock) question.stock = parse_stock(*command.stock, question.top.value_or(0));
  if (!command.arguments.input().empty()) question.part = &part.emplace(command.arguments.read());
  return question;
}

int run_feeds(const VerifyCommand& command, const std::string& output) {
  PlanOptions options = command.arguments.options();
  std::optional<ProgressLine> line;
  if (!command.quiet) options.progress = line.emplace(kStops).callback();
  const std::string program = read_file(command.program);
  std::optional<Part> part;
  const ProgramQuestion question = question_of(command, part);
  const ProgramFeeds feeds = feeds_of_program(question, program, command.program, options);
  std::vector<std::string> inputs = paths_of(command.arguments.input_files());
  inputs.push_back(command.program);
  write_outputs({{output, feeds.program}}, inputs);
  const CheckResult& result = feeds.after;
  if (!command.quiet) print(result.part.diagnostics, true);
  if (output != "-") {
    if (!command.quiet) tell_of_header(feeds.program);
    print_line(with_colours(command.quiet ? verdict_and_reasons(result.findings)
                                          : dialect_line(command, result) + feeds_lines(feeds, options) +
                                                write_table(result, table_width())));
  }
  return exit_code_of(result.findings);
}

}  // namespace

void add_feeds_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("feeds", "Adapt the feeds of any program to the load of its mills");
  command->group("Planning");
  auto state = declare_question(*command);
  let_part_be_absent(*command, *state);
  auto output = std::make_shared<std::string>();
  command->option_defaults()->group("Output");
  command
      ->add_option("-o,--output", *output,
                   "Program to write, with other F words only (- for standard output)")
      ->required()
      ->type_name("FILE");
  command->add_flag("--quiet", state->quiet, "Print only the verdict and its reasons, one on each line");
  command->callback([state, output, &exit_code] { exit_code = run_feeds(*state, *output); });
}

namespace {

struct ResumeCommand {
  std::optional<int> line;
  std::string place;
  std::string output;
};

/// "X,Y,Z", mm or with units.
std::array<double, 3> stopped_at(const std::string& text) {
  const std::vector<std::string> words = split(text, ',');
  std::array<double, 3> place{};
  bool is_place = words.size() == 3;
  for (std::size_t axis = 0; is_place && axis < 3; ++axis) {
    const std::optional<double> length = length_in_mm(words[axis]);
    is_place = length.has_value();
    place[axis] = length.value_or(0);
  }
  if (!is_place)
    throw InputError("--place " + text,
                     "needs where the tip of the tool stood, X,Y,Z, for example 20,35.5,-2");
  return place;
}

Stop stop_of(const ResumeCommand& resume) {
  Stop stop;
  stop.line = resume.line;
  if (!resume.place.empty()) stop.place = stopped_at(resume.place);
  if (stop.line.has_value() == stop.place.has_value())
    throw InputError("resume",
                     "say where the program stopped: --line N, the first line to run again, or "
                     "--place X,Y,Z, where the tip of the tool stood");
  return stop;
}

/// Where the program goes on, and what was found out about the stop.
std::string resume_lines(const ResumedProgram& resumed, bool by_place) {
  std::string text =
      fmt::format("goes on with line {} by T{}, from X {} Y {} Z {}; it is line {} now\n", resumed.line,
                  resumed.tool, trimmed(resumed.begin.point.x, 3), trimmed(resumed.begin.point.y, 3),
                  trimmed(resumed.begin.z, 3), resumed.line + resumed.new_lines);
  if (by_place)
    text += fmt::format("the place lies {} mm beside the path{}\n", trimmed(resumed.beside_mm, 3),
                        resumed.passes > 1
                            ? fmt::format(", which passes it {} times: the first is taken", resumed.passes)
                            : "");
  if (!resumed.before.findings.faults.empty())
    text += "note: the program that was stopped is FAULTY itself (clearcut verify says where)\n";
  return text;
}

int run_resume(const VerifyCommand& command, const ResumeCommand& resume) {
  const Stop stop = stop_of(resume);
  PlanOptions options = command.arguments.options();
  std::optional<ProgressLine> line;
  if (!command.quiet) options.progress = line.emplace(kStops).callback();
  const std::string program = read_file(command.program);
  std::optional<Part> part;
  const ResumedProgram resumed =
      resume_program(question_of(command, part), stop, program, command.program, options);
  std::vector<std::string> inputs = paths_of(command.arguments.input_files());
  inputs.push_back(command.program);
  write_outputs({{resume.output, resumed.program}}, inputs);
  const CheckResult& result = resumed.after;
  if (!command.quiet) print(result.part.diagnostics, true);
  if (resume.output != "-")
    print_line(with_colours(command.quiet ? verdict_and_reasons(result.findings)
                                          : dialect_line(command, result) +
                                                resume_lines(resumed, stop.place.has_value()) +
                                                write_table(result, table_width())));
  return exit_code_of(result.findings);
}

}  // namespace

void add_resume_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("resume", "Go on with any program after a stop, safely");
  command->group("Planning");
  auto state = declare_question(*command);
  let_part_be_absent(*command, *state);
  auto resume = std::make_shared<ResumeCommand>();
  command->option_defaults()->group("Input");
  CLI::Option* line =
      command->add_option("--line", resume->line, "Line of PROGRAM that is the first to run again")
          ->type_name("N")
          ->check(CLI::PositiveNumber);
  command
      ->add_option(
          "--place", resume->place,
          "Where the tip of the tool stood, in the work's coordinates: the move that passes there runs "
          "again")
      ->type_name("X,Y,Z")
      ->excludes(line);
  command->option_defaults()->group("Output");
  command
      ->add_option(
          "-o,--output", resume->output,
          "Program to write: the rest, behind lines that bring the machine there (- for standard output)")
      ->required()
      ->type_name("FILE");
  command->add_flag("--quiet", state->quiet, "Print the verdict and its reasons alone, one on each line");
  command->callback([state, resume, &exit_code] { exit_code = run_resume(*state, *resume); });
}

void add_setup_sheet_command(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("setup-sheet", "Write a set-up sheet: zero, stock, tools, operations, times");
  command->group("Planning");
  auto state = declare_question(*command);
  command->option_defaults()->group("Output");
  command
      ->add_option("-o,--output", state->sheet,
                   "Set-up sheet to write, for one printed page: HTML, or PDF for FILE.pdf")
      ->required()
      ->type_name("FILE");
  command->add_flag("--quiet", state->quiet, "Print only the verdict and its reasons, one on each line");
  command->callback([state, &exit_code] { exit_code = run(*state); });
}

std::string verify_certificate(const std::vector<std::string>& arguments) {
  CLI::App app;
  const auto state = declare(app);
  app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  remember_arguments(arguments);
  return checked(*state).certificate;
}

}  // namespace clearcut::cli
