// Every command and option in plain data, as the parser knows them: help, man page and completion are made from it.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace clearcut::cli {

struct OptionText {
  std::vector<std::string> names;  ///< "-o", "--output"; "INPUT" for one that is told by its place
  std::string value;               ///< what stands for the value in help: MM, FILE; "" for flags
  std::string help;                ///< with the default in brackets
  std::string group;
  std::vector<std::string> values;  ///< that can be completed
  bool positional = false;
  bool required = false;
  bool file = false;
  bool many = false;  ///< takes several values
};

struct CommandText {
  std::string name;
  std::string help;
  std::vector<OptionText> options;  ///< as declared; options told by place first
  std::vector<std::string> groups;  ///< of options told by name, as declared; that of --help last
};

CommandText text_of(const CLI::App& command);
/// Of all commands that are not hidden.
std::vector<CommandText> commands_of(const CLI::App& app);

/// "-o,--output FILE".
std::string synopsis(const OptionText& option);

}  // namespace clearcut::cli
