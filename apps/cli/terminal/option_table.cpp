#include "terminal/option_table.h"

#include <clearcut/text.h>

#include <algorithm>

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

}  // namespace clearcut::cli
