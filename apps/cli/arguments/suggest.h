// What somebody may have meant by a word the command does not know.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace clearcut::cli {

/// "'--stepdwn' is no option of plan; did you mean '--stepdown'?" for the first argument that nothing took.
std::string about_unexpected(const CLI::App& app, const std::vector<std::string>& arguments);

/// Takes one of these names, and says which was meant by another; they stand in help and completion.
CLI::Validator one_of(const std::vector<std::string>& names);
/// Takes anything; the names stand in completion alone.
CLI::Validator for_example(const std::vector<std::string>& names);

}  // namespace clearcut::cli
