// Comparing programs: as texts, and as the motion they stand for.
#pragma once

#include <string>
#include <vector>

#include "model/move.h"
#include "read/gcode/gcode.h"

namespace clearcut::test_support {

/// The moves that are no rapids.
std::vector<Move> feed_moves(const Section& section);

/// mm; how far sampled points of `from` lie from the nearest move of `to`. Cost O(moves^2).
double largest_distance(const std::vector<Move>& from, const std::vector<Move>& to);

/// Where two texts begin to differ, as "line N: 'a' instead of 'b'"; "" if nowhere.
std::string first_difference(const std::string& a, const std::string& b);

/// Reads a program back as the control it was posted for; the tools of `planned` are put in by hand where it has no words
/// for them.
Program read_posted(const std::string& text, const std::string& dialect, const Toolpath& planned);

}  // namespace clearcut::test_support
