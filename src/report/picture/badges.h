// Numbers on a picture, in page units: none covers another.
#pragma once

#include <string>
#include <vector>

#include "geometry/box.h"
#include "report/picture/svg_writer.h"

namespace clearcut::report {

/// A text on a white ground and the place that it names.
struct Badge {
  Vec2 place;
  std::string text;
};

/// Where the middle of a badge is drawn.
struct PlacedBadge {
  Vec2 middle;
  Badge badge;
};

/// What a badge covers when its middle lies there.
Box covered_by(const std::string& text, Vec2 middle);

/// The badges at their places, or as near to them as they find room within `bounds` beside those before them. Those that find none
/// are left out.
std::vector<PlacedBadge> placed_apart(const std::vector<Badge>& badges, const Box& bounds);

/// "1-3, 7" of ascending numbers.
std::string numbers_text(const std::vector<int>& ascending);

/// Draws them, with a line to the place where the badge stands beside it.
void draw_badges(SvgWriter& svg, const std::vector<PlacedBadge>& badges);

}  // namespace clearcut::report
