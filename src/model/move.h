// One motion of the machine, and the coolant during it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/units.h"
#include "geometry/edge.h"

namespace clearcut::inline model {

enum class Coolant : unsigned char {
  kOff,
  kFlood,  ///< M8; through the tool likewise
  kMist,   ///< M7
  kBoth    ///< flood and mist at once
};

constexpr bool has_flood(Coolant coolant) {
  return coolant == Coolant::kFlood || coolant == Coolant::kBoth;
}
constexpr bool has_mist(Coolant coolant) {
  return coolant == Coolant::kMist || coolant == Coolant::kBoth;
}
constexpr Coolant coolant_of(bool flood, bool mist) {
  return flood ? (mist ? Coolant::kBoth : Coolant::kFlood) : (mist ? Coolant::kMist : Coolant::kOff);
}

/// "off", "flood", "mist", "both": as on the command line and in jobs.
const std::vector<std::string>& coolant_names();
const std::string& name_of(Coolant coolant);
std::optional<Coolant> coolant_named(const std::string& name);

enum class MoveKind : unsigned char { kRapid, kPlunge, kRamp, kLeadIn, kCut, kLeadOut, kLink, kRetract };
const char* name_of(MoveKind kind);
inline bool is_rapid(MoveKind kind) {
  return kind == MoveKind::kRapid;
}

/// A move along the edge `path` in plan, with z changing linearly from z_from to z_to. A vertical move has path.from
/// == path.to (the only case in which these may be equal) and turn kStraight. z is the height of the tool's tip. mm.
struct Move {
  Edge path;
  double z_from = 0;
  double z_to = 0;
  MoveKind kind = MoveKind::kCut;
  MmPerMin feed;  ///< 0 for rapids
  int line = 0;   ///< line of the move in the read program; 0 if planned

  bool is_vertical() const { return path.from == path.to; }
  /// Length in space, mm.
  double length() const;
};

/// How the passes of a feature depart from what was asked for, or what they leave by the rule that was asked for.
struct Remark {
  std::string title;  ///< a few words, in capitals: for the program's header
  std::string text;   ///< one sentence, without the feature's name

  bool operator==(const Remark&) const = default;
};

/// The cutter stands still.
struct Dwell {
  std::size_t after = 0;  ///< index into Section::moves
  double seconds = 0;
};

/// A Section is all work of one tool on one feature.
struct Section {
  std::string label;     ///< feature or operation name; "" when unknown
  int workingstep = -1;  ///< index into Part::workplan; -1 when unknown
  int tool_number = 0;   ///< T word
  double spindle_rpm = 0;
  bool spindle_clockwise = true;
  Coolant coolant = Coolant::kOff;
  std::vector<Move> moves;           ///< joined end to start; the first may begin anywhere
  std::vector<std::string> notes{};  ///< requests that could not be fulfilled; not part of the program
  std::vector<Remark> remarks{};     ///< on the passes; said in the program's header
  /// For cuts of an earlier set-up, seen in a later one: height (mm) below which none of their cleared volume
  /// remains. Such cuts count for features that begin no higher; infinite if nothing of the cut remains at any
  /// height. Absent for all other cuts; not part of the program.
  std::optional<double> carried_below{};
  /// With carried_below: this volume was not cut but is missing in a stock stated as a solid.
  bool is_of_stock = false;
  std::vector<Dwell> dwells{};  ///< besides those at the floors of holes; in the order of moves
  /// mm from the walls, ascending: distances of contours of offset outlines; not part of the program.
  std::vector<double> contours{};

  /// Whether the section's cuts count for a feature beginning at height `top`, mm: cuts of an earlier set-up count
  /// only if they reach up to `top`.
  bool counts_below(double top) const { return !carried_below || *carried_below >= top; }
};

/// All motion of the machine. A value, written by planning and read by all later stages.
struct Toolpath {
  std::vector<Section> sections;
};

/// Lengths of feed and rapid moves, mm.
double feed_length(const Section& section);
double rapid_length(const Section& section);

}  // namespace clearcut::inline model
