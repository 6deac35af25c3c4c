#include <clearcut/error.h>
#include <clearcut/programs.h>

#include <string>
#include <vector>

#include "arguments/certificate_info.h"
#include "commands/research.h"
#include "process/own_process.h"

namespace clearcut::cli {

void run_studies(const std::string& command) {
  std::vector<std::string> words{"clearcut", command};
  for (const std::string& word : remembered_arguments()) words.push_back(word);
  process::replace_by(companion("clearcut-studies"), words);
  throw InputError(command,
                   "is done by the program clearcut-studies, which does not lie beside this one; "
                   "install both, or build the target commands");
}

namespace {

/// The options are the other program's, `--help` among them.
void hand_over(CLI::App& command) {
  command.prefix_command();
  command.set_help_flag();
  command.callback([name = command.get_name()] { run_studies(name); });
}

}  // namespace

void hand_over_research_commands(CLI::App& app) {
  for (const ResearchCommand& one : {kElements, kTour, kReproduce, kStudy})
    hand_over(*add_research_command(app, one));
  // clearcut-studies knows the options of all commands.
  hand_over(*app.add_subcommand("generate", "Print the man page, the completion of a shell, or all options")
                 ->group(""));
}

}  // namespace clearcut::cli
