// One motion of the machine.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/units.h"
#include "geometry/edge.h"
#include "model/coolant.h"

namespace clearcut::inline model {

enum class MoveKind : unsigned char { kRapid, kPlunge, kRamp, kLeadIn, kCut, kLeadOut, kLink, kRetract };
const char* name_of(MoveKind kind);
inline bool is_rapid(MoveKind kind) {
  return kind == MoveKind::kRapid;
}

/// In plan the edge `path`, while z goes linearly from z_from to z_to. A vertical move has path.from == path.to
/// (the one case where that is allowed) and turn kStraight. z is the height of the tool's tip. mm.
struct Move {
  Edge path;
  double z_from = 0;
  double z_to = 0;
  MoveKind kind = MoveKind::kCut;
  MmPerMin feed;  ///< 0 for rapids
  int line = 0;   ///< line of the program it was read from; 0 if planned

  bool is_vertical() const { return path.from == path.to; }
  /// Length in space, mm.
  double length() const;
};

/// The cutter stands still.
struct Dwell {
  std::size_t after = 0;  ///< index into Section::moves
  double seconds = 0;
};

/// Where two passes in one layer meet nothing else is promised. A Section is all work of one tool on one feature.
struct Section {
  std::string label;     ///< feature or operation name; "" when unknown
  int workingstep = -1;  ///< index into Part::workplan; -1 when unknown
  int tool_number = 0;   ///< T word
  double spindle_rpm = 0;
  bool spindle_clockwise = true;
  Coolant coolant = Coolant::kOff;
  std::vector<Move> moves;           ///< joined end to start, except that the first may begin anywhere
  std::vector<std::string> notes{};  ///< what was asked for and could not be done; not part of the program
  /// Cuts that an earlier set-up made, seen in a later one: mm, the height below which nothing of it is left. They count for features
  /// that begin no higher; infinite where nothing is left at any height. Absent for all other cuts; not part of the program.
  std::optional<double> carried_below{};
  bool is_of_stock =
      false;  ///< with carried_below: nobody cut it, a stock that is stated as a solid lacks it
  std::vector<Dwell> dwells{};  ///< besides those at the floors of holes; in the order of moves
  /// mm from the walls, ascending: where contours of offset outlines run; not part of the program.
  std::vector<double> contours{};

  /// Whether its cuts count for a feature that begins at height `top`, mm: those of an earlier set-up only where they reach up to it.
  bool counts_below(double top) const { return !carried_below || *carried_below >= top; }
};

/// What the machine will do. A value; the waist between planning and everything that reads it.
struct Toolpath {
  std::vector<Section> sections;
};

/// Lengths of feed and rapid moves, mm.
double feed_length(const Section& section);
double rapid_length(const Section& section);

}  // namespace clearcut::inline model
