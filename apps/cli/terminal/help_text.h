// Text of --help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace clearcut::cli {

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
