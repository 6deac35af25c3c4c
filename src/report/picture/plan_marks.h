// Marks on a plan view, in page units: scale bar, worst places, faults, and numbers of which none covers another.
#pragma once

#include <string>
#include <vector>

#include "geometry/box.h"
#include "report/picture/plan_picture.h"
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

/// A bar of 1, 2 or 5 times a power of ten mm, lower left.
void draw_scale_bar(SvgWriter& svg, const PlanView& view);

/// The places of the thickest rest, the deepest gouge and the largest engagement, with their figures.
void draw_worst_places(SvgWriter& svg, const PlanView& view,
                       const std::vector<const FeatureFindings*>& findings);

/// The place that limits the margin of `feature` (the smallest of all features if null), with the margin.
void draw_margin(SvgWriter& svg, const PlanView& view, const Margin& margin, const Feature* feature);

/// A cross at each fault of `feature` (of all features if null) in the view.
void draw_faults(SvgWriter& svg, const PlanView& view, const Findings& findings, const Feature* feature);

}  // namespace clearcut::report
