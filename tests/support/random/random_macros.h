// Random programs of LinuxCNC with parameters, expressions, subroutines and loops.
#pragma once

#include <cstdint>
#include <string>

namespace clearcut::test_support {

/// A program that LinuxCNC takes and that ends. Same seed, same text.
std::string random_macro_program(std::uint64_t seed);

}  // namespace clearcut::test_support
