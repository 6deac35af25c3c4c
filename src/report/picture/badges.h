// Numbers on a picture, in page units: none covers another.
#pragma once

#include <string>
#include <vector>

#include "geometry/box.h"
#include "report/picture/svg_writer.h"

namespace clearcut::report {

/// A text on a white background and its labelled place.
struct Badge {
  Vec2 place;
  std::string text;
};

/// Position of the middle of a drawn badge.
struct PlacedBadge {
  Vec2 middle;
  Badge badge;
};

/// The box covered by a badge with its middle there.
Box covered_by(const std::string& text, Vec2 middle);

/// The badges at their places, or as near to them as there is room within `bounds` beside earlier badges. Badges
/// without room are left out.
std::vector<PlacedBadge> placed_apart(const std::vector<Badge>& badges, const Box& bounds);

/// "1-3, 7" of ascending numbers.
std::string numbers_text(const std::vector<int>& ascending);

/// Draws the badges, with a line to the place if the badge is beside it.
void draw_badges(SvgWriter& svg, const std::vector<PlacedBadge>& badges);

}  // namespace clearcut::report
