// machines: the machines known to --machine by name.
#include <clearcut/part.h>
#include <clearcut/text.h>
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "arguments/option_values.h"
#include "commands/commands.h"
#include "terminal/json_tables.h"
#include "terminal/man_page.h"
#include "terminal/output.h"

namespace clearcut::cli {
namespace {

/// One value if the axes are equal, else those of X, Y and Z.
std::string of_axes(const AxisValues& values) {
  if (values[0] <= 0) return "not published";
  if (values[0] == values[1] && values[0] == values[2]) return trimmed(values[0], 0);
  return fmt::format("{} / {} / {}", trimmed(values[0], 0), trimmed(values[1], 0), trimmed(values[2], 0));
}

std::string spindle_of(const LibraryMachine& one) {
  return one.max_rpm > 0 ? trimmed(one.max_rpm, 0) : "";
}

void print_machines(bool as_markdown) {
  TextTable table;
  table.columns = {{"name", Align::kLeft},
                   {"machine", Align::kLeft},
                   {"planner", Align::kLeft},
                   {"speed mm/min"},
                   {"mm/s2"},
                   {"spindle rpm"},
                   {"stated by", Align::kLeft}};
  for (const LibraryMachine& one : machine_library())
    table.add({std::string(one.name), std::string(one.title), std::string(name_of(one.planner)),
               of_axes(one.speed), of_axes(one.acceleration), spindle_of(one), std::string(one.source)});
  table.notes = {
      "Where the acceleration is not published, 500 mm/s2 is taken; --acceleration states another.",
      "The settings of the machine itself are better: --machine takes Grbl's $$, LinuxCNC's .ini and "
      "Marlin's M503."};
  print_table(table, as_markdown);
}

nlohmann::ordered_json json_of(const LibraryMachine& one) {
  nlohmann::ordered_json json;
  json["name"] = one.name;
  json["title"] = one.title;
  json["planner"] = name_of(one.planner);
  json["speed_mm_per_min"] = one.speed;
  json["acceleration_mm_per_s2"] =
      one.acceleration[0] > 0 ? nlohmann::ordered_json(one.acceleration) : nlohmann::ordered_json(nullptr);
  json["junction_deviation_mm"] = one.junction_deviation;
  json["max_spindle_rpm"] =
      one.max_rpm > 0 ? nlohmann::ordered_json(one.max_rpm) : nlohmann::ordered_json(nullptr);
  json["source"] = one.source;
  return json;
}

}  // namespace

void add_machines_command(CLI::App& app, int& exit_code) {
  struct Answer {
    bool as_json = false, as_markdown = false;
  };
  auto answer = std::make_shared<Answer>();
  CLI::App* command = app.add_subcommand("machines", "List the machines that --machine knows by name");
  command->group("Choosing");
  command->option_defaults()->group("Output");
  auto* page = command->add_flag("--markdown", answer->as_markdown, "Print a Markdown table");
  command->add_flag("--json", answer->as_json, "Print JSON")->excludes(page);
  command->callback([answer, &exit_code] {
    if (answer->as_json) {
      nlohmann::ordered_json list = nlohmann::ordered_json::array();
      for (const LibraryMachine& one : machine_library()) list.push_back(json_of(one));
      print_line(list.dump(2));
    } else {
      print_machines(answer->as_markdown);
    }
    exit_code = kClean;
  });
}

// clearcut generate: hidden; used by the build for the man page and the shells' completions, and by the server for
// the options.

void add_generate_command(CLI::App& app, int& exit_code, void (*add_whole)(CLI::App&, int&)) {
  auto* command =
      app.add_subcommand("generate", "Print the man page, the completion of a shell, or all options as JSON");
  command->group("");
  auto what = std::make_shared<std::string>();
  command->add_option("WHAT", *what, "What to print")
      ->required()
      ->check(one_of({"man", "bash", "zsh", "fish", "options", "table"}));
  command->callback([what, add_whole, description = app.get_description(), &exit_code] {
    exit_code = kClean;
    if (*what == "table") return print_line(options_page());
    const auto print_whole = *what == "man"    ? man_page
                             : *what == "bash" ? bash_completion
                             : *what == "zsh"  ? zsh_completion
                             : *what == "fish" ? fish_completion
                                               : options_json;
    CLI::App whole(description, "clearcut");
    int unused = kClean;
    add_whole(whole, unused);
    print_line(print_whole(whole));
  });
}

}  // namespace clearcut::cli
