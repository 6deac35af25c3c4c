// Options of other types than double.
#pragma once

#include <CLI/CLI.hpp>

namespace clearcut::cli {

/// A seed is any whole number of 64 bits; greater numbers are refused, not truncated.
CLI::Validator is_seed();

}  // namespace clearcut::cli
