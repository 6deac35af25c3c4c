// Every command and option in plain data, from the parser: the basis of help, man page and completion; and the text
// of --help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace clearcut::cli {

struct OptionText {
  std::vector<std::string> names;  ///< "-o", "--output"; "INPUT" for a positional one
  std::string value;               ///< placeholder of the value in help: MM, FILE; "" for flags
  std::string help;                ///< with the default in brackets
  std::string group;
  std::vector<std::string> values;  ///< values for completion
  bool positional = false;
  bool required = false;
  bool file = false;
  bool many = false;  ///< takes several values
};

struct CommandText {
  std::string name;
  std::string help;
  std::vector<OptionText> options;  ///< as declared; positional options first
  std::vector<std::string> groups;  ///< groups of named options, as declared; that of --help last
};

CommandText text_of(const CLI::App& command);
/// All commands except hidden ones.
std::vector<CommandText> commands_of(const CLI::App& app);

/// "-o,--output FILE".
std::string synopsis(const OptionText& option);

/// Prints from the option table, in groups, as wide as the terminal.
class HelpText : public CLI::Formatter {
 public:
  /// `shows_all`: also seldom used options and those of research, as for `--help all`.
  explicit HelpText(bool shows_all = true) : shows_all_(shows_all) {}
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;

 private:
  bool shows_all_;
};

}  // namespace clearcut::cli
