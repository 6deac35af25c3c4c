// What --help prints.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace clearcut::cli {

/// Prints from the option table, in groups, as wide as the terminal.
class HelpText : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace clearcut::cli
