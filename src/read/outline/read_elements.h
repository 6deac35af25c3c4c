// Design elements as a user types them on the command line, and job files of design elements.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/design_element.h"
#include "options/element_options.h"

namespace clearcut::read {

/// The job in the options' order. Only the form is checked here, as for job files. Throws InputError naming the
/// option.
ElementJob elements_of_options(const std::vector<ElementOption>& options, const ElementDefaults& defaults);

/// TOML: name, resolution (mm), middle_row = "keep" or "strict", [stock] with x, y, z = [low, high],
/// [[tool]] and [[element]]; docs/grid.md lists every key. Only the form is checked here; whether the
/// elements can be made is checked by the planner, all faults at once. Throws InputError "file:line: ...".
/// Cost O(length).
ElementJob read_elements(const std::filesystem::path& file);
ElementJob read_elements_text(std::string_view text, const std::string& file_name);

}  // namespace clearcut::read
