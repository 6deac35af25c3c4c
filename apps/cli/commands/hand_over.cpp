#include <clearcut/error.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "arguments/certificate_info.h"
#include "commands/research.h"

namespace clearcut::cli {

void run_studies(const std::string& command) {
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  const std::string program = (self.parent_path() / "clearcut-studies").string();
  std::vector<std::string> words{"clearcut", command};
  for (const std::string& word : remembered_arguments()) words.push_back(word);
  std::vector<char*> given;
  for (std::string& word : words) given.push_back(word.data());
  given.push_back(nullptr);
  ::execv(program.c_str(), given.data());
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
