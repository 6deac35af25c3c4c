// Programs of ours that another one runs.
#pragma once

#include <string>

namespace clearcut::inline base {

/// The path of the program `name`: beside this one, else the first of these places that has it. Empty where there is none.
std::string companion(const std::string& name, const std::string& place, const std::string& other_place = "");

}  // namespace clearcut::inline base
