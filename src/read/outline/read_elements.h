// Job files of design elements.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/design_element.h"

namespace clearcut::read {

/// TOML: name, resolution (mm), middle_row = "keep" or "strict", [stock] with x, y, z = [low, high],
/// [[tool]] and [[element]]; docs/grid.md lists every key. Only the form is checked here; whether the
/// elements can be made is checked by the planner, all faults at once. Throws InputError "file:line: ...".
/// Cost O(length).
ElementJob read_elements(const std::filesystem::path& file);
ElementJob read_elements_text(std::string_view text, const std::string& file_name);

}  // namespace clearcut::read
