// Which types and functions a C++ file defines for the whole program: what the one-definition rule is about.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace clearcut::test_support {

/// "clearcut::verify::Wall", "clearcut::plan::Moves =", "clearcut::plan::cut(const Region & a)": classes, structs, unions,
/// enumerations, aliases and functions that are defined in named namespaces of the text, in order. Left out is what belongs to one
/// file alone (in namespaces without name, static functions), what stands inside classes and functions, and what macros make.
/// Parameters are compared as they are spelled. Cost O(length).
std::vector<std::string> shared_definitions(std::string_view text);

}  // namespace clearcut::test_support
