// Suggestions for words unknown to the command.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace clearcut::cli {

/// "'--stepdwn' is no option of plan; did you mean '--stepdown'?" for the first unused argument.
std::string about_unexpected(const CLI::App& app, const std::vector<std::string>& arguments);

/// Accepts one of these names, and suggests one for other words; the names are shown in help and completion.
CLI::Validator one_of(const std::vector<std::string>& names);
/// Accepts any text; the names are used only in completion.
CLI::Validator for_example(const std::vector<std::string>& names);

}  // namespace clearcut::cli
