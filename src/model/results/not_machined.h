// Features requested by name but not machined at all: a fault, regardless of all other results.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "model/results/findings.h"

namespace clearcut::inline model {

/// Reports that `name` (of a feature or workingstep ordered by the input) is not machined, and the reason.
void say_not_machined(Diagnostics& diagnostics, const std::string& where, const std::string& name,
                      const std::string& why);

/// The names of features not machined, in the order of the reports.
std::vector<std::string> names_not_machined(const Diagnostics& diagnostics);

/// A fault for each of them, before all others; then nothing is clean.
void add_not_machined(const Diagnostics& diagnostics, Findings& findings);

}  // namespace clearcut::inline model
