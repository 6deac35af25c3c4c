#include "terminal/option_table.h"

#include <clearcut/options.h>
#include <clearcut/text.h>
#include <fmt/format.h>

#include <algorithm>

#include "terminal/output.h"

namespace clearcut::cli {
namespace {

const std::string kHelpGroup = "Help";

/// The names in braces added to the type by a validator: "TEXT:{climb,conventional}".
std::vector<std::string> values_of(const std::string& type) {
  const auto from = type.find('{'), to = type.find('}');
  if (from == std::string::npos || to == std::string::npos || to < from) return {};
  return split(type.substr(from + 1, to - from - 1), ',');
}

std::string value_of(const CLI::Option& option, const std::string& type) {
  if (option.get_items_expected_max() == 0) return "";
  const std::string word = type.substr(0, type.find_first_of(":{ "));
  if (!values_of(type).empty()) return "NAME";
  if (word == "FLOAT" || word == "INT" || word == "UINT" || word == "POSITIVE" || word == "NONNEGATIVE")
    return "NUMBER";
  return word.empty() || word == "TEXT" ? "TEXT" : word;
}

std::string help_of(const CLI::Option& option) {
  const std::string& help = option.get_description();
  const std::string& standard = option.get_default_str();
  const bool says = help.find("default") != std::string::npos;
  if (says || standard.empty() || standard == "[]" || standard == "{}" ||
      option.get_items_expected_max() == 0)
    return help;
  return help + " (default " + standard + ")";
}

OptionText text_of_option(const CLI::Option& option) {
  OptionText text;
  for (const auto& name : option.get_snames()) text.names.push_back("-" + name);
  for (const auto& name : option.get_lnames()) text.names.push_back("--" + name);
  text.positional = text.names.empty();
  if (text.positional) text.names.push_back(option.get_name());
  const std::string type = option.get_type_name();
  text.values = values_of(type);
  text.value = value_of(option, type);
  text.file = type.starts_with("FILE");
  text.help = help_of(option);
  text.required = option.get_required();
  text.many = option.get_items_expected_max() > 1;
  const bool about_itself = option.check_lname("help") || option.check_lname("version");
  text.group = about_itself ? kHelpGroup : option.get_group();
  return text;
}

}  // namespace

CommandText text_of(const CLI::App& command) {
  CommandText text;
  text.name = command.get_name();
  text.help = command.get_description();
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_group().empty()) text.options.push_back(text_of_option(*option));
  }
  std::stable_sort(text.options.begin(), text.options.end(), [](const auto& a, const auto& b) {
    return a.positional != b.positional ? a.positional : (a.group != kHelpGroup && b.group == kHelpGroup);
  });
  for (const OptionText& option : text.options) {
    if (option.positional) continue;
    if (std::find(text.groups.begin(), text.groups.end(), option.group) == text.groups.end())
      text.groups.push_back(option.group);
  }
  return text;
}

std::vector<CommandText> commands_of(const CLI::App& app) {
  std::vector<CommandText> all;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!command->get_group().empty()) all.push_back(text_of(*command));
  }
  return all;
}

std::string synopsis(const OptionText& option) {
  std::string text;
  for (const auto& name : option.names) text += (text.empty() ? "" : ", ") + name;
  if (option.positional || option.value.empty()) return text;
  return text + " " + option.value;
}

namespace {

constexpr std::size_t kIndent = 2;
constexpr std::size_t kHelpColumn = 28;
constexpr std::size_t kWidest = 110;  // longer lines are hard to read

/// "  --tool TEXT           description", the right column wrapped; on lines of its own below a long left one.
std::string help_entry(const std::string& left, const std::string& help, std::size_t width) {
  std::string text = std::string(kIndent, ' ') + left;
  if (text.size() + 2 > kHelpColumn) {
    text += "\n" + std::string(kHelpColumn, ' ');
  } else {
    text.resize(kHelpColumn, ' ');
  }
  const auto lines = wrapped(help, width - kHelpColumn);
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += (i > 0 ? std::string(kHelpColumn, ' ') : "") + lines[i] + "\n";
  return text;
}

std::string usage(const CommandText& command) {
  std::string text = "Usage: clearcut " + command.name;
  for (const OptionText& option : command.options) {
    const std::string word =
        option.positional ? option.names.front() : option.names.back() + " " + option.value;
    if (option.positional) text += " " + (option.required ? word : "[" + word + "]");
    if (!option.positional && option.required) text += " " + word;
  }
  return text + " [OPTIONS]\n";
}

std::string help_of_option(const OptionText& option) {
  std::string text = option.help;
  // Names not listed in the sentence itself.
  const bool lists = std::any_of(option.values.begin(), option.values.end(), [&](const std::string& one) {
    return one.size() > 2 && option.help.find(one) != std::string::npos;
  });
  if (option.values.empty() || lists) return text;
  text += ": ";
  for (const auto& value : option.values) text += (&value == &option.values.front() ? "" : ", ") + value;
  return text;
}

/// Whether an option is one of a first program, or none of the table's.
bool is_for_beginners(const OptionText& option) {
  const Row* row = row_named(option.names.back().substr(option.positional ? 0 : 2));
  return !row || row->level == Level::kFirst;
}

/// Removes the less used options from a command with many; returns their number.
std::size_t hide_rare(CommandText& command) {
  constexpr std::size_t kMany = 60;
  if (command.options.size() < kMany) return 0;
  return std::erase_if(command.options, [](const OptionText& option) { return !is_for_beginners(option); });
}

std::string options_of(const CommandText& command, std::size_t width) {
  std::string text;
  for (const OptionText& option : command.options) {
    if (option.positional)
      text += (text.empty() ? "\n" : "") + help_entry(option.names.front(), help_of_option(option), width);
  }
  for (const auto& group : command.groups) {
    const bool any =
        std::any_of(command.options.begin(), command.options.end(),
                    [&](const OptionText& option) { return !option.positional && option.group == group; });
    if (!any) continue;
    text += "\n" + group + ":\n";
    for (const OptionText& option : command.options) {
      if (!option.positional && option.group == group)
        text += help_entry(synopsis(option), help_of_option(option), width);
    }
  }
  return text;
}

std::string commands_text(const CLI::App& app, std::size_t width) {
  std::string text, group;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_group().empty()) continue;
    if (command->get_group() != group) text += "\n" + command->get_group() + ":\n";
    group = command->get_group();
    text += help_entry(command->get_name(), command->get_description(), width);
  }
  return text;
}

}  // namespace

std::string HelpText::make_help(const CLI::App* app, std::string /*name*/,
                                CLI::AppFormatMode /*mode*/) const {
  const std::size_t width = std::min(text_width(), kWidest);
  CommandText command = text_of(*app);
  const std::size_t hidden = shows_all_ ? 0 : hide_rare(command);
  std::string text;
  for (const auto& line : wrapped(app->get_description(), width)) text += line + "\n";
  if (app->get_parent() != nullptr) {
    text += "\n" + usage(command) + options_of(command, width);
    if (hidden > 0)
      text += fmt::format("\nclearcut {} --help all lists {} more options, those of research last.\n",
                          command.name, hidden);
    return text;
  }
  text += "\nUsage: clearcut COMMAND [OPTIONS]\n" + commands_text(*app, width) + options_of(command, width);
  text += "\n";
  for (const auto& line : wrapped(app->get_footer(), width)) text += line + "\n";
  return text;
}

}  // namespace clearcut::cli
