// clearcut: the command. Parses, calls the pipeline, prints.
#include <clearcut/error.h>
#include <clearcut/version.h>

#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "arguments/certificate_info.h"
#include "arguments/suggest.h"
#include "commands/commands.h"
#include "terminal/help_text.h"
#include "terminal/terminal.h"

namespace {

using namespace clearcut::cli;

/// One line, whatever the message held.
void complain(std::string message) {
  for (auto& c : message) {
    if (c == '\n') c = ' ';
  }
  std::fprintf(stderr, "clearcut: %s\n", message.c_str());
}

/// What was wrong with the arguments, in one line.
std::string about(const CLI::ParseError& error, const CLI::App& app,
                  const std::vector<std::string>& arguments) {
  const auto commands = app.get_subcommands();
  if (commands.empty() || dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    return about_unexpected(app, arguments);
  const std::string text = error.what();
  if (text.find("use one of") != std::string::npos) return text;
  return text + " (see clearcut " + commands.front()->get_name() + " --help)";
}

int parse_and_run(int argc, char** argv) {
  int exit_code = kClean;
  if (argc > 2) remember_arguments({argv + 2, argv + argc});
  CLI::App app("Plans 2.5-D pocket-milling toolpaths and proves them.", "clearcut");
  app.formatter(std::make_shared<HelpText>());
  app.footer("clearcut COMMAND --help says all about a command; man clearcut says it of every one.");
  app.set_version_flag("--version", std::string("clearcut ") + clearcut::kVersion, "Print the version");
  app.require_subcommand(1);
  add_commands(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    complain(about(error, app, {argv + 1, argv + argc}));
    return kUnusable;
  }
  return exit_code;
}

/// What was printed may not have arrived: a full disk, a closed pipe.
int checked_output(int exit_code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return exit_code;
  complain("the output could not be written; make room, or name another file");
  return kUnusable;
}

}  // namespace

int main(int argc, char** argv) {
  clearcut::cli::say_when_interrupted();
  try {
    return checked_output(parse_and_run(argc, argv));
  } catch (const clearcut::InputError& error) {
    complain(error.what());
    return kUnusable;
  } catch (const std::bad_alloc&) {
    complain("out of memory; the input is too large for this machine");
    return kUnusable;
  } catch (const std::exception& error) {
    complain(std::string("internal fault: ") + error.what());
    return kInternal;
  }
}
