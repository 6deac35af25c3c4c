// Stands in for src/read/step_solid/apart.cpp: a page runs no other program.
#include "read/step_solid/apart.h"

namespace clearcut::read {

std::optional<std::string> done_apart(const std::vector<std::string>& /*command*/, std::string_view /*input*/,
                                      int /*seconds*/) {
  return std::nullopt;
}

}  // namespace clearcut::read
