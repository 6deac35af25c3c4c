// clearcut generate: hidden; the build makes the man page and the shells' completions with it.
#include <memory>

#include "commands.h"
#include "man_page.h"
#include "output.h"
#include "suggest.h"

namespace clearcut::cli {

void add_generate_command(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("generate", "Print the man page or the completion of a shell");
  command->group("");
  auto what = std::make_shared<std::string>();
  command->add_option("WHAT", *what, "What to print")
      ->required()
      ->check(one_of({"man", "bash", "zsh", "fish"}));
  command->callback([&app, what, &exit_code] {
    const auto print_whole = *what == "man"    ? man_page
                             : *what == "bash" ? bash_completion
                             : *what == "zsh"  ? zsh_completion
                                               : fish_completion;
    print_line(print_whole(app));
    exit_code = kClean;
  });
}

}  // namespace clearcut::cli
