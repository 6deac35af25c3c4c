// clearcut.1 and the completion of three shells, from the option table.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace clearcut::cli {

std::string man_page(const CLI::App& app);
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string fish_completion(const CLI::App& app);

}  // namespace clearcut::cli
