#include "arguments/suggest.h"

#include <clearcut/options.h>

#include <algorithm>

namespace clearcut::cli {
namespace {

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

/// Name of an option in other programs and shops.
struct Synonym {
  const char* word;
  const char* option;
};
constexpr Synonym kSynonyms[] = {
    {"--stock-to-leave", "--allowance"},
    {"--radial-stock-to-leave", "--allowance"},
    {"--wall-stock", "--allowance"},
    {"--axial-stock-to-leave", "--allowance-floor"},
    {"--floor-stock", "--allowance-floor"},
    {"--depth-per-pass", "--stepdown"},
    {"--depth-of-cut", "--stepdown"},
    {"--doc", "--stepdown"},
    {"--width-of-cut", "--stepover"},
    {"--woc", "--stepover"},
    {"--rpm", "--spindle"},
    {"--speed", "--spindle"},
    {"--plunge-rate", "--plunge-feed"},
    {"--safe-z", "--clearance"},
    {"--safe-height", "--clearance"},
    {"--clearance-height", "--clearance"},
    {"--retract-height", "--clearance"},
    {"--controller", "--post"},
    {"--postprocessor", "--post"},
    {"--dialect", "--post"},
    {"--zero", "--origin"},
    {"--wcs", "--work-offset"},
    {"--climb", "--direction"},
    {"--conventional", "--direction"},
    {"--ramp-angle", "--entry-angle"},
    {"--ramp", "--entry"},
    {"--helix", "--entry"},
    {"--cutter", "--tool"},
    {"--diameter", "--tool"},
    {"--tool-library", "--tools"},
    {"--onion-skin", "--skin"},
    {"--operation", "--op"},
};

/// The option with another usual name, "" if it is none of `names`.
std::string meant_by(const std::string& word, const std::vector<std::string>& names) {
  for (const Synonym& synonym : kSynonyms) {
    if (word == synonym.word && std::find(names.begin(), names.end(), synonym.option) != names.end())
      return synonym.option;
  }
  return "";
}

std::string advice(const std::string& word, const std::vector<std::string>& names, const std::string& help) {
  const std::string synonym = meant_by(word, names);
  const std::string meant = synonym.empty() ? nearest_name(word, names) : synonym;
  return meant.empty() ? "see " + help : "did you mean '" + meant + "'?";
}

}  // namespace

CLI::Validator for_example(const std::vector<std::string>& names) {
  return {[](std::string&) { return std::string(); }, "{" + CLI::detail::join(names, ",") + "}"};
}

CLI::Validator one_of(const std::vector<std::string>& names) {
  return {[names](std::string& text) {
            if (std::find(names.begin(), names.end(), text) != names.end()) return std::string();
            const std::string meant = nearest_name(text, names);
            return "'" + text + "' is unknown; " + (meant.empty() ? "" : "did you mean '" + meant + "'? ") +
                   "use one of " + CLI::detail::join(names, ", ");
          },
          "{" + CLI::detail::join(names, ",") + "}"};
}

std::string about_unexpected(const CLI::App& app, const std::vector<std::string>& arguments) {
  const auto parsed = app.get_subcommands();
  if (parsed.empty()) {
    const auto first = std::find_if(arguments.begin(), arguments.end(), [](const std::string& one) {
      return !one.empty() && one.front() != '-';
    });
    if (!arguments.empty() && arguments.front().starts_with("-") &&
        !nearest_name(arguments.front(), option_names(app)).empty())
      return "'" + arguments.front() + "' is no option; " +
             advice(arguments.front(), option_names(app), "clearcut --help");
    if (first != arguments.end() && *first == "help")
      return "'help' is no command; say clearcut --help, or clearcut COMMAND --help";
    if (first == arguments.end() && !arguments.empty())
      return "'" + arguments.front() +
             "' comes before a command; name one: clearcut plan, see clearcut --help";
    if (first == arguments.end())
      return "a command is missing; for example clearcut plan, see clearcut --help";
    return "'" + *first + "' is no command; " + advice(*first, command_names(app), "clearcut --help");
  }
  const CLI::App& command = *parsed.front();
  const std::string help = "clearcut " + command.get_name() + " --help";
  const auto extras = command.remaining();
  const std::string word = extras.empty() ? "" : extras.front().substr(0, extras.front().find('='));
  if (word.starts_with("-"))
    return "'" + word + "' is no option of " + command.get_name() + "; " +
           advice(word, option_names(command), help);
  return "'" + word + "' is one argument too many for " + command.get_name() +
         "; a name with blanks needs quotes, see " + help;
}

}  // namespace clearcut::cli
