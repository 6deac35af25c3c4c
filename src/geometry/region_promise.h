// Checks the guarantees of every region.
#pragma once

#include <string>

#include "geometry/region.h"

namespace clearcut::inline geometry {

/// "" if the loops, in either direction, make a valid region: closed, the outer one around an area, without
/// crossings, islands inside the outer loop and beside each other. An island may be a wall of no thickness: a line
/// and back. Else a text with the fault and its place. Loops that cross by less than 1 um touch. Cost O(n log n) for
/// edges that are short against the whole.
std::string broken_promise(const Loop& outer, const std::vector<Loop>& islands);

}  // namespace clearcut::inline geometry
