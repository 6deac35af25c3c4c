// What was asked for by name and is not machined at all: a fault, whatever the rest is like.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "model/results/findings.h"

namespace clearcut::inline model {

/// Says that `name` (of a feature or workingstep that the input orders) is not machined, and why.
void say_not_machined(Diagnostics& diagnostics, const std::string& where, const std::string& name,
                      const std::string& why);

/// The names of what is not machined, in the order it was said.
std::vector<std::string> names_not_machined(const Diagnostics& diagnostics);

/// A fault for each of them, before all others; then nothing is clean.
void add_not_machined(const Diagnostics& diagnostics, Findings& findings);

}  // namespace clearcut::inline model
