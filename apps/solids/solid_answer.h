// Data of a STEP file from the CAD kernel.
#pragma once

#include <string>
#include <string_view>

#include "read/step_solid/solid_model.h"

namespace clearcut {

/// The solid as bytes_of after an 'S', or after an 'E' in one line why there is none. The kernel crashes on some
/// damaged files and takes minutes for others: to be run in a process of its own.
std::string solid_answer(std::string_view text, const std::string& file_name,
                         const read::SolidChoice& choice);

}  // namespace clearcut
