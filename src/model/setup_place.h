// Orientation and position of the block in each of several set-ups.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "model/part.h"

namespace clearcut::inline model {

/// The coordinates of a set-up from those of the block: turn * p + shift, mm. The rows of `turn` are unit vectors at
/// right angles.
struct SetupPlace {
  using Row = std::array<double, 3>;
  std::array<Row, 3> turn{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Row shift{0, 0, 0};
};

/// With the side `up` of the block ("+Z", "-Z", "+X", "-X", "+Y", "-Y"; "" is +Z) looking up, then turned by degrees
/// about the vertical, counter-clockwise from above: as solids are turned. Nothing for other sides.
std::optional<SetupPlace> place_with_up(const std::string& up, double degrees);

/// From the coordinates of one set-up to those of another of the same block.
SetupPlace between(const SetupPlace& from, const SetupPlace& to);

/// Whether the rotation maps axes to axes, so that a box stays a box.
bool keeps_boxes(const SetupPlace& place);
/// Whether verticals stay vertical, upright or turned over.
bool keeps_verticals(const SetupPlace& place);
bool turns_over(const SetupPlace& place);

/// A block in other coordinates; `place` keeps boxes.
Stock moved(const Stock& stock, const SetupPlace& place);
/// A line or arc in plan view; `place` keeps verticals.
Edge moved(const Edge& edge, const SetupPlace& place);
double moved_z(double z, const SetupPlace& place);

}  // namespace clearcut::inline model
