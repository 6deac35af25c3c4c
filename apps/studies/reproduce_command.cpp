// reproduce: the published tables beside our figures.
#include <clearcut/error.h>
#include <clearcut/file.h>
#include <clearcut/studies.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "arguments/option_values.h"
#include "commands/commands.h"
#include "commands/research.h"
#include "research_commands.h"
#include "study_files.h"
#include "terminal/output.h"
#include "terminal/progress.h"

namespace clearcut::cli {
namespace {

/// Options of reproduce.
struct ReproduceCommand {
  std::vector<std::string> names;
  bool list = false;
  bool all = false;
  bool quiet = false;
  bool resume = false;
  bool as_markdown = false;
  std::string json;
  std::string html;
};

TextTable list_of_tables() {
  TextTable table;
  table.columns = {{"name", Align::kLeft}, {"in the texts", Align::kLeft}, {"seconds of a core"}};
  for (const auto& one : studies::reproducible_tables())
    table.add({one.name + (one.is_long ? " *" : ""), one.place, fmt::format("{:g}", one.cost_s)});
  table.notes.emplace_back("*: runs by name or with --all");
  return table;
}

std::vector<const studies::ReproducibleTable*> chosen_tables(const ReproduceCommand& command) {
  std::vector<const studies::ReproducibleTable*> tables;
  for (const auto& name : command.names) tables.push_back(&studies::reproducible_table(name));
  if (!tables.empty()) return tables;
  for (const auto& table : studies::reproducible_tables())
    if (command.all || !table.is_long) tables.push_back(&table);
  return tables;
}

bool keeps(const ReproduceCommand& command) {
  return !command.json.empty() && command.json != "-";
}

/// Beside the file of tables: the finished runs of the current table.
std::string runs_file(const ReproduceCommand& command) {
  return command.json + ".runs";
}

/// Made now, or kept from an earlier run.
studies::NamedReproduction reproduction(const studies::ReproducibleTable& table,
                                        const std::vector<studies::NamedReproduction>& kept,
                                        const ReproduceCommand& command) {
  for (const auto& one : kept)
    if (one.name == table.name) return one;
  const std::string path = runs_file(command);
  studies::TableWatch watch;
  if (keeps(command)) watch.append = [path](const std::string& line) { append_to_file(path, line); };
  if (command.resume && std::filesystem::exists(path)) watch.kept = read_file(path);
  std::optional<ProgressLine> line;
  if (!command.quiet) {
    line.emplace(kStops).expect("reproduce " + table.name, table.cost_s);
    watch.say = [&line](const std::string& text) { line->say(text); };
    watch.count = [&line](std::size_t done, std::size_t of) { line->count(done, of, "runs"); };
  }
  return {table.name, table.place, table.make(watch)};
}

/// Tables of an earlier run with the same output file; none if the file does not exist yet.
std::vector<studies::NamedReproduction> kept_tables(const ReproduceCommand& command) {
  if (!command.resume) return {};
  if (command.json.empty() || command.json == "-")
    throw InputError("--resume", "takes up the tables of a file; add --json FILE");
  if (!std::filesystem::exists(command.json)) return {};
  return studies::read_reproduction_json(read_file(command.json), command.json);
}

bool is_among(const std::vector<const studies::ReproducibleTable*>& tables, const std::string& name) {
  return std::any_of(tables.begin(), tables.end(), [&](const auto* table) { return table->name == name; });
}

void print_reproduction(const studies::Reproduction& reproduction, bool as_markdown) {
  auto text = reproduction.table;
  if (!reproduction.compared.empty()) text.notes.push_back(reproduction.summary());
  print_table(text, as_markdown);
  std::fflush(stdout);
}

/// The JSON file is written after every table, so that an interrupted run can be continued.
void reproduce_tables(const ReproduceCommand& command) {
  if (command.list) return print_table(list_of_tables());
  const auto kept = kept_tables(command);
  if (keeps(command) && !command.resume) std::filesystem::remove(runs_file(command));
  const auto tables = chosen_tables(command);
  std::vector<studies::NamedReproduction> made;
  for (const auto& one : kept)
    if (!is_among(tables, one.name)) made.push_back(one);
  for (const auto* table : tables) {
    made.push_back(reproduction(*table, kept, command));
    if (command.json != "-" && command.html != "-")
      print_reproduction(made.back().reproduction, command.as_markdown);
    if (keeps(command)) write_outputs({{command.json, studies::reproduction_json(made)}}, {});
  }
  if (keeps(command)) std::filesystem::remove(runs_file(command));
  if (command.json == "-") write_outputs({{command.json, studies::reproduction_json(made)}}, {});
  if (!command.html.empty()) write_outputs({{command.html, studies::reproduction_page(made)}}, {});
  if (command.quiet || !command.names.empty() || command.all) return;
  for (const auto& table : studies::reproducible_tables())
    if (table.is_long) fmt::print(stderr, "not run, it is long: clearcut reproduce {}\n", table.name);
}

}  // namespace

void print_grid_reductions() {
  print_table(studies::grid_reduction_table());
}

void add_reproduce_command(CLI::App& app, int& exit_code) {
  auto* command = add_research_command(app, kReproduce);
  auto state = std::make_shared<ReproduceCommand>();
  std::vector<std::string> names;
  for (const auto& table : studies::reproducible_tables()) names.push_back(table.name);
  command->option_defaults()->group("Input");
  command->add_option("TABLE", state->names, "Tables by name, see --list; default all but the long ones")
      ->check(one_of(names));
  command->add_flag("--list", state->list, "List the tables with the time of each, and run none");
  command->add_flag("--all", state->all, "Run the long tables, too");
  command->option_defaults()->group("Output");
  command->add_option("--json", state->json, "Tables to write, with the check of every printed cell (JSON)")
      ->type_name("FILE");
  command->add_option("--html", state->html, "The same tables as one page to write")->type_name("FILE");
  command->add_flag(
      "--resume", state->resume,
      "Keep the tables that the file of --json has already, and the finished runs of the table that was "
      "broken off; make the others");
  command->add_flag("--markdown", state->as_markdown,
                    "Print Markdown tables, as the pages of docs/ have them");
  command->add_flag("--quiet", state->quiet, "Print no progress");
  command->callback([state, &exit_code] {
    reproduce_tables(*state);
    exit_code = kClean;
  });
}

}  // namespace clearcut::cli
