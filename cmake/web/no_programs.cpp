// Stands in for src/base/apart.cpp: a page runs no other program.
#include "base/apart.h"

namespace clearcut::inline base {

std::optional<std::string> done_apart(const std::vector<std::string>& /*command*/, std::string_view /*input*/,
                                      int /*seconds*/) {
  return std::nullopt;
}

}  // namespace clearcut::inline base
