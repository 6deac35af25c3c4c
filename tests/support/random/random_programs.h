// Random programs for a word-address control, and whether two readers make the same motion of them.
#pragma once

#include <cstdint>
#include <string>

#include "model/move.h"

namespace clearcut::test_support {

/// About `blocks` blocks of lines, arcs in all planes, drilling cycles, offsets, reference points, lengths, dwells, M words
/// and comments, as LinuxCNC takes them; each with its line number as its N word. Same seed, same text.
std::string random_program(std::uint64_t seed, int blocks);

/// What LinuxCNC's interpreter and the toolpath do differently, line by line: "" where each block makes the same
/// motion within `tolerance` mm, as the same kind of move. `canon` is the interpreter's output.
std::string difference_of_motion(const std::string& canon, const Toolpath& toolpath, double tolerance);

}  // namespace clearcut::test_support
