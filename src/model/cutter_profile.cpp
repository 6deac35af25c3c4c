#include "model/cutter_profile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"

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

/// Body of one kind of tool.
struct ProfileRow {
  ToolKind kind;
  CutterProfile (*form)(const Tool&);
  bool takes_all;  ///< whether no material remains within the tool's form or above the form
};

constexpr ProfileRow kProfiles[] = {
    {ToolKind::kEndMill, rounded_form, true},     {ToolKind::kFaceMill, rounded_form, true},
    {ToolKind::kBallEndMill, rounded_form, true}, {ToolKind::kBullNoseEndMill, rounded_form, true},
    {ToolKind::kDrill, pointed_form, true},       {ToolKind::kReamer, upright_form, true},
    {ToolKind::kVBit, flanked_form, true},        {ToolKind::kChamferMill, flanked_form, true},
    {ToolKind::kSpotDrill, flanked_form, true},   {ToolKind::kTap, upright_form, false},
    {ToolKind::kThreadMill, upright_form, false}, {ToolKind::kBoringBar, upright_form, true},
    {ToolKind::kCounterbore, upright_form, true}, {ToolKind::kTapered, flanked_form, true},
    {ToolKind::kTSlot, upright_form, false},      {ToolKind::kOther, rounded_form, true}};

const ProfileRow& row_of(ToolKind kind) {
  for (const ProfileRow& row : kProfiles)
    if (row.kind == kind) return row;
  return kProfiles[0];
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
  return row_of(tool.kind).form(tool);
}

CutterProfile inner_profile(const Tool& tool) {
  const bool is_cone = tool.kind == ToolKind::kVBit || tool.kind == ToolKind::kChamferMill ||
                       tool.kind == ToolKind::kSpotDrill;
  const bool is_known = !is_cone || tool.tip_angle.has_value();
  return row_of(tool.kind).takes_all && is_known ? outer_profile(tool) : CutterProfile{};
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
