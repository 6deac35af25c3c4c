// A solid's faces as bytes, to pass from one process to another of the same program.
#pragma once

#include <string>

#include "read/step_solid/solid_model.h"

namespace clearcut::read {

std::string bytes_of(const SolidModel& solid);
/// The inverse. Only for bytes made by bytes_of.
SolidModel model_from_bytes(const std::string& bytes);

}  // namespace clearcut::read
