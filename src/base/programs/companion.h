// Finds Clearcut's other programs, which one of its programs runs.
#pragma once

#include <string>

namespace clearcut::inline base {

/// The path of the program `name`: beside this one, else the first of these folders that contains the program. Empty
/// if none does.
std::string companion(const std::string& name, const std::string& place, const std::string& other_place = "");

}  // namespace clearcut::inline base
