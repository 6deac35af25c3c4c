#pragma once

#include <cstdlib>

namespace clearcut::test_support {

/// The first of the seeds of a random campaign: CLEARCUT_FIRST_SEED, else 1.
inline int first_seed() {
  const char* set = std::getenv("CLEARCUT_FIRST_SEED");
  return set ? std::atoi(set) : 1;
}

}  // namespace clearcut::test_support
