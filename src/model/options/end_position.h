// End position of the machine after all cuts.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "geometry/vec2.h"

namespace clearcut::inline model {

struct EndPosition {
  enum class Kind : unsigned char {
    kUsual,  ///< as the control is used: Z to its home on Fanuc and Haas, the safe height on others
    kHome,   ///< Z to its home, then X and Y
    kPlace,  ///< `place` at the safe height, then as usual
    kStay    ///< the safe height over the last cut
  };
  Kind kind = Kind::kUsual;
  Vec2 place{};  ///< kPlace: mm, from the program's zero
  friend bool operator==(const EndPosition&, const EndPosition&) = default;
};

/// "home", "none", or "X,Y" in mm; nothing for other texts.
std::optional<EndPosition> end_position_named(std::string_view text);
/// "home", "none", "10,20"; "" for the usual one.
std::string name_of(const EndPosition& end);

}  // namespace clearcut::inline model
