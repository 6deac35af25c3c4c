// Options that are no doubles.
#pragma once

#include <CLI/CLI.hpp>

namespace clearcut::cli {

/// A seed is any whole number of 64 bits; what does not fit is refused, not cut.
CLI::Validator is_seed();

}  // namespace clearcut::cli
