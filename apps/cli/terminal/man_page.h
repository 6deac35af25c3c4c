// clearcut.1, the completion of three shells, and the table of all options of a plan as a page of the documentation:
// all from the option table.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace clearcut::cli {

std::string man_page(const CLI::App& app);
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string fish_completion(const CLI::App& app);

/// Markdown, one row an option, made from the options' table.
std::string options_page();

}  // namespace clearcut::cli
