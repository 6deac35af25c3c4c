// Options that take quantities with units.
#pragma once

#include <CLI/CLI.hpp>

namespace clearcut::cli {

/// Turns "0.25in" and "6mm" into millimetres, "40in/min" into mm/min, "40%" into a fraction; refuses other text.
CLI::Validator as_length();
CLI::Validator as_feed();
CLI::Validator as_stepover();
/// A seed is any whole number of 64 bits; what does not fit is refused, not cut.
CLI::Validator is_seed();

}  // namespace clearcut::cli
