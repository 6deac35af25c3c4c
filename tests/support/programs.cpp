#include "support/programs.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace clearcut::test_support {

std::vector<Move> feed_moves(const Section& section) {
  std::vector<Move> moves;
  for (const Move& move : section.moves) {
    if (!is_rapid(move.kind)) moves.push_back(move);
  }
  return moves;
}

namespace {

double distance_to(const Move& move, Vec2 p, double z) {
  if (move.is_vertical()) {
    const double nearest_z =
        std::clamp(z, std::min(move.z_from, move.z_to), std::max(move.z_from, move.z_to));
    return std::hypot(distance(move.path.to, p), z - nearest_z);
  }
  const Nearest near = nearest(move.path, p);
  return std::hypot(near.distance, z - std::lerp(move.z_from, move.z_to, near.t));
}

}  // namespace

double largest_distance(const std::vector<Move>& from, const std::vector<Move>& to) {
  double largest = 0;
  for (const Move& move : from) {
    for (const double t : {0.0, 0.3, 0.5, 0.8, 1.0}) {
      const Vec2 p = move.is_vertical() ? move.path.to : move.path.at(t);
      double least = HUGE_VAL;
      for (const Move& other : to)
        least = std::min(least, distance_to(other, p, std::lerp(move.z_from, move.z_to, t)));
      largest = std::max(largest, least);
    }
  }
  return largest;
}

std::string first_difference(const std::string& a, const std::string& b) {
  std::istringstream left(a), right(b);
  std::string x, y;
  for (int line = 1;; ++line) {
    const bool more = static_cast<bool>(std::getline(left, x)),
               others = static_cast<bool>(std::getline(right, y));
    if (!more && !others) return a == b ? "" : "line ends differ";
    if (more != others || x != y)
      return "line " + std::to_string(line) + ": '" + x + "' instead of '" + y + "'";
  }
}

Program read_posted(const std::string& text, const std::string& dialect, const Toolpath& planned) {
  read::gcode::ReadControllerOptions options;
  options.dialect = read::gcode::dialect_named(dialect);
  for (const Section& section : planned.sections) {
    const bool same = !options.hand_tools.empty() && options.hand_tools.back() == section.tool_number;
    if (!same) options.hand_tools.push_back(section.tool_number);
  }
  return read::gcode::read_gcode(text, "posted", options);
}

}  // namespace clearcut::test_support
