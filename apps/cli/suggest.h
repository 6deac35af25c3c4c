// What somebody may have meant by a word the command does not know.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace clearcut::cli {

/// "'--stepdwn' is no option of plan; did you mean '--stepdown'?" for the first argument that nothing took.
std::string about_unexpected(const CLI::App& app, const std::vector<std::string>& arguments);

}  // namespace clearcut::cli
