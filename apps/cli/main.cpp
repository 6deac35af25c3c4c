// clearcut: the command. Parses, calls the pipeline, prints.
#include <clearcut/error.h>
#include <clearcut/version.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "arguments/certificate_info.h"
#include "arguments/option_values.h"
#include "commands/commands.h"
#include "memory/memory_limit.h"
#include "terminal/option_table.h"
#include "terminal/output.h"

namespace {

using namespace clearcut::cli;

/// The error in the arguments, in one line.
std::string about(const CLI::ParseError& error, const CLI::App& app,
                  const std::vector<std::string>& arguments) {
  const auto commands = app.get_subcommands();
  if (commands.empty() || dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
    return about_unexpected(app, arguments);
  const std::string text = error.what();
  if (text.find("use one of") != std::string::npos) return text;
  return text + " (see clearcut " + commands.front()->get_name() + " --help)";
}

/// Whether `--help all` was typed.
bool asks_for_all(int argc, char** argv) {
  for (int i = 1; i + 1 < argc; ++i)
    if (std::string_view(argv[i]) == "--help" && std::string_view(argv[i + 1]) == "all") return true;
  return false;
}

int parse_and_run(int argc, char** argv) {
  int exit_code = kClean;
  if (argc > 2) remember_arguments({argv + 2, argv + argc});
  CLI::App app("Plans 2.5-D pocket-milling toolpaths and proves them.", "clearcut");
  app.formatter(std::make_shared<HelpText>(asks_for_all(argc, argv)));
  app.footer("clearcut COMMAND --help says all about a command; man clearcut says it of every one.");
  app.set_version_flag("--version", std::string("clearcut ") + clearcut::kVersion, "Print the version");
  app.require_subcommand(1);
  add_commands(app, exit_code, argc > 1 ? argv[1] : "");
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

/// Printed output may have been lost: a full disk, a closed pipe.
int checked_output(int exit_code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return exit_code;
  complain("the output could not be written; make room, or name another file");
  return kUnusable;
}

/// Commands that work on one file of somebody's. Others make many plans at once and know what they need.
constexpr std::array<std::string_view, 9> kOfOneFile{"plan", "info",  "tools", "verify", "convert",
                                                     "init", "check", "feeds", "resume"};

void limit_memory(std::string_view command) {
  if (std::find(kOfOneFile.begin(), kOfOneFile.end(), command) == kOfOneFile.end()) return;
  clearcut::memory::limit_to(clearcut::memory::limit_asked_for());
}

/// Advice if the memory does not suffice.
std::string beyond_memory(std::string_view command) {
  const std::string help = command == "plan" || command == "tools"
                               ? "use a wider cutter, a larger --stepdown or --stepover, --strategy zigzag, "
                                 "or fewer layers of the drawing "
                                 "at once (--layer)"
                               : "take fewer outlines at once, or simpler ones";
  return "more than its limit of memory would be needed; " + help + "; CLEARCUT_MEMORY=4 allows 4 GB";
}

}  // namespace

int main(int argc, char** argv) {
  clearcut::cli::say_when_interrupted();
  const std::string_view command = argc > 1 ? argv[1] : "";
  try {
    limit_memory(command);
    return checked_output(parse_and_run(argc, argv));
  } catch (const clearcut::InputError& error) {
    complain(error.what());
    return kUnusable;
  } catch (const clearcut::memory::LimitReached&) {
    complain(beyond_memory(command));
    return kUnusable;
  } catch (const std::invalid_argument& error) {
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
