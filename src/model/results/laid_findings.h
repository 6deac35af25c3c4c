// What the check of a program finds that lays a line of constant width over an area: a bead of an extruder, the spot of a laser.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/vec2.h"

namespace clearcut::inline model {

/// The word of a program with which the line is laid.
enum class LayingWord : unsigned char {
  kExtruded,  ///< E: mm of filament fed along the move
  kPower      ///< S: power of the laser
};

/// Computed from the program's text. Lengths in mm, areas in mm2.
struct LaidFindings {
  LayingWord word = LayingWord::kExtruded;
  double width = 0;       ///< of the line
  std::size_t lines = 0;  ///< laid without a break
  double laid_mm = 0;
  double travel_mm = 0;
  double time_s = 0;              ///< at the stated feeds, without acceleration
  double amount = 0;              ///< mm of filament in all; for a laser the greatest power
  double region_mm2 = 0;          ///< area to be covered
  double unreachable_mm2 = 0;     ///< of it, where the line is too wide: corners, necks
  double uncut_mm2 = 0;           ///< upper bound of what is left bare within reach
  double uncut_thickness_mm = 0;  ///< upper bound of its width
  std::optional<Vec2> uncut_at;
  double over_mm2 = 0;    ///< laid over what is covered already; every further time counts
  double over_share = 0;  ///< over_mm2 as a share of the covered area
  double most_over = 0;   ///< the greatest share that was stated
  double outside_mm = 0;  ///< greatest distance of the line's edge beyond the region
  std::optional<Vec2> outside_at;
  std::vector<std::string> faults;  ///< sentences

  bool is_clean() const { return faults.empty(); }
};

struct InfillResult {
  std::string strategy, stepover;
  std::string program;
  LaidFindings findings;  ///< of the program's text as read back
};

}  // namespace clearcut::inline model
