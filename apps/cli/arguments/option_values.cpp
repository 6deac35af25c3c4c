#include "arguments/option_values.h"

#include <clearcut/error.h>
#include <clearcut/options.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace clearcut::cli {

CLI::Validator is_seed() {
  return {[](const std::string& text) {
            value_of_text(*row_named("seed"), text, "--seed");
            return std::string();
          },
          ""};
}

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

namespace {

std::string type_of(const Row& row) {
  if (!row.type.empty()) return row.type;
  if (row.kind == ValueKind::kFile || row.kind == ValueKind::kFiles) return "FILE";
  return is_number(row.kind) || row.kind == ValueKind::kSeed ? "FLOAT" : "TEXT";
}

/// Typed values are checked during parsing, so that mistakes are reported before any file is read.
CLI::Validator understood(const Row& row) {
  return {[&row](std::string& text) {
            const std::string place = "--" + row.name;
            if (takes_several(row.kind))
              value_of_texts(row, {text}, place);
            else
              value_of_text(row, text, place);
            return std::string();
          },
          ""};
}

}  // namespace

void OptionValues::add_row(CLI::App& command, const Row& row) {
  command.option_defaults()->group(name_of(row.group));
  const std::string typed = "--" + row.name;
  if (row.kind == ValueKind::kFlag) {
    command.add_flag(typed, flags_[row.name], row.described());
    return;
  }
  auto& texts = texts_[row.name];
  CLI::Option* option = command.add_option(typed, texts, row.described())->type_name(type_of(row));
  if (!takes_several(row.kind)) option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::Throw);
  if (row.kind == ValueKind::kPoints) option->allow_extra_args(false);
  option->check(understood(row));
  if (!row.names.empty()) option->check(for_example(row.names));
}

void OptionValues::add(CLI::App& command, const std::function<bool(const Row&)>& wanted) {
  for (const Row& row : rows())
    if (wanted(row)) add_row(command, row);
}

void OptionValues::set(const std::string& name, const std::vector<std::string>& values,
                       const std::string& place) {
  const Row& row = *row_named(name);
  if (row.kind == ValueKind::kFlag) {
    flags_[name] = true;
  } else {
    if (takes_several(row.kind))
      value_of_texts(row, values, place);
    else
      value_of_text(row, values.back(), place);
    texts_[name] = values;
  }
}

bool OptionValues::has(const std::string& name) const {
  const auto texts = texts_.find(name);
  if (texts != texts_.end()) return !texts->second.empty();
  const auto flag = flags_.find(name);
  return flag != flags_.end() && flag->second;
}

std::set<std::string> OptionValues::names() const {
  std::set<std::string> names;
  for (const Row& row : rows())
    if (has(row.name)) names.insert(row.name);
  return names;
}

void OptionValues::put_into(Asked& asked) const {
  for (const Row& row : rows()) {
    if (!has(row.name)) continue;
    const std::string place = "--" + row.name;
    const auto texts = texts_.find(row.name);
    const Value value = texts == texts_.end()     ? Value(true)
                        : takes_several(row.kind) ? value_of_texts(row, texts->second, place)
                                                  : value_of_text(row, texts->second.back(), place);
    row.field.set(asked, value, row.names);
  }
}

Asked OptionValues::asked() const {
  Asked asked;
  put_into(asked);
  return asked;
}

}  // namespace clearcut::cli
