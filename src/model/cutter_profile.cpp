#include "model/cutter_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"
#include "model/tool.h"

namespace clearcut::inline model {
namespace {

CutterProfile upright_form(const Tool& tool) {
  return CutterProfile::cylinder(tool.radius());
}

/// Flat mills, bull-noses and balls.
CutterProfile rounded_form(const Tool& tool) {
  const double round = tool.kind == ToolKind::kBallEndMill ? tool.radius() : tool.corner_radius;
  return {std::max(0.0, tool.radius() - round), round, 0, tool.radius()};
}

/// Cones with a point or a flat tip, and tapered end mills.
CutterProfile flanked_form(const Tool& tool) {
  if (!has_flanks(tool)) return upright_form(tool);
  return {tip_radius(tool), 0, flank_slope(tool), widest_radius(tool)};
}

CutterProfile pointed_form(const Tool& tool) {
  return {0, 0, tool.radius() / point_length(tool), tool.radius()};
}

CutterProfile form_of(const Tool& tool) {
  switch (row_of(tool.kind).form) {
    case CutterForm::kRounded:
      return rounded_form(tool);
    case CutterForm::kPointed:
      return pointed_form(tool);
    case CutterForm::kFlanked:
      return flanked_form(tool);
    case CutterForm::kUpright:
      break;
  }
  return upright_form(tool);
}

}  // namespace

double CutterProfile::radius_at(double height) const {
  if (height < 0) return -1;
  if (round > 0) {
    const double below = std::max(0.0, round - height);  // the middle of the rounding
    return std::min(widest, flat + std::sqrt(round * round - below * below));
  }
  return slope > 0 ? std::min(widest, flat + height * slope) : widest;
}

double CutterProfile::height_at(double distance) const {
  if (distance > widest || widest <= 0) return std::numeric_limits<double>::infinity();
  if (distance <= flat) return 0;
  if (round > 0) {
    const double out = std::min(round, distance - flat);
    return round - std::sqrt(round * round - out * out);
  }
  return slope > 0 ? (distance - flat) / slope : 0;
}

CutterProfile CutterProfile::narrowed(double by) const {
  return {flat - by, round, slope, std::max(0.0, widest - by)};
}

CutterProfile outer_profile(const Tool& tool) {
  return form_of(tool);
}

CutterProfile inner_profile(const Tool& tool) {
  // Threads and undercuts leave material within the form of their tools and above it; a cone without an angle is not known.
  const bool is_known = row_of(tool.kind).use != ToolUse::kEdges || tool.tip_angle.has_value();
  return is_known && !works_at_once(tool) ? outer_profile(tool) : CutterProfile{};
}

double radius_cleared(const Tool& tool, double above) {
  const CutterProfile profile = inner_profile(tool);
  const bool leaves_ridges = profile.round > 0 && profile.flat <= 0 && above < profile.full_height();
  return leaves_ridges ? 0 : std::max(0.0, profile.radius_at(std::max(0.0, above)));
}

double flat_end(const Tool& tool) {
  return outer_profile(tool).flat;
}

}  // namespace clearcut::inline model
