// clearcut generate: hidden; used by the build for the man page and the shells' completions, and by the server for
// the options.
#include <memory>

#include "arguments/suggest.h"
#include "commands/commands.h"
#include "terminal/json_tables.h"
#include "terminal/man_page.h"
#include "terminal/option_page.h"
#include "terminal/output.h"

namespace clearcut::cli {

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
