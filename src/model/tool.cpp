#include "model/tool.h"

#include <algorithm>
#include <cmath>

#include "base/elementary.h"
#include "model/cutter_profile.h"

namespace clearcut::inline model {

namespace {

struct ToolName {
  ToolKind kind;
  const char* name;
};
constexpr ToolName kNames[] = {{ToolKind::kEndMill, "endmill"},
                               {ToolKind::kFaceMill, "facemill"},
                               {ToolKind::kBallEndMill, "ball"},
                               {ToolKind::kBullNoseEndMill, "bullnose"},
                               {ToolKind::kDrill, "drill"},
                               {ToolKind::kReamer, "reamer"},
                               {ToolKind::kVBit, "vbit"},
                               {ToolKind::kChamferMill, "chamfer"},
                               {ToolKind::kSpotDrill, "spotdrill"},
                               {ToolKind::kTap, "tap"},
                               {ToolKind::kThreadMill, "threadmill"},
                               {ToolKind::kBoringBar, "boringbar"},
                               {ToolKind::kCounterbore, "counterbore"},
                               {ToolKind::kTapered, "tapered"},
                               {ToolKind::kTSlot, "tslot"},
                               {ToolKind::kOther, "other"}};
/// Degrees; point angle of common drills.
constexpr double kUsualPoint = 118;

}  // namespace

const char* name_of(ToolKind kind) {
  for (const ToolName& entry : kNames)
    if (entry.kind == kind) return entry.name;
  return "other";
}

std::optional<ToolKind> tool_kind_named(const std::string& name) {
  for (const ToolName& entry : kNames)
    if (name == entry.name) return entry.kind;
  return std::nullopt;
}

const Tool* tool_numbered(const std::vector<Tool>& tools, int number) {
  const auto found =
      std::find_if(tools.begin(), tools.end(), [&](const Tool& tool) { return tool.number == number; });
  return found == tools.end() ? nullptr : &*found;
}

bool is_conical(const Tool& tool) {
  const bool kind = tool.kind == ToolKind::kVBit || tool.kind == ToolKind::kChamferMill ||
                    tool.kind == ToolKind::kSpotDrill;
  return kind && tool.tip_angle.has_value();
}

double flank_slope(const Tool& tool) {
  return base::tan(tool.tip_angle.value_or(Radians{}).radians() / 2);
}

bool has_flanks(const Tool& tool) {
  return is_conical(tool) || (tool.kind == ToolKind::kTapered && tool.tip_angle.has_value());
}

double flank_height(const Tool& tool) {
  if (tool.kind == ToolKind::kTapered) return tool.flute_length.value_or(0);
  return (tool.radius() - tool.tip_diameter / 2) / flank_slope(tool);
}

double tip_radius(const Tool& tool) {
  return tool.kind == ToolKind::kTapered ? tool.radius() : tool.tip_diameter / 2;
}

double widest_radius(const Tool& tool) {
  if (tool.kind != ToolKind::kTapered) return tool.radius();
  return tool.radius() + flank_height(tool) * flank_slope(tool);
}

double radius_at(const Tool& tool, double height) {
  if (tool.kind == ToolKind::kTSlot && height > tool.flute_length.value_or(HUGE_VAL))
    return tool.shank_diameter / 2;
  return outer_profile(tool).radius_at(std::max(0.0, height));
}

double point_length(const Tool& tool) {
  if (tool.kind != ToolKind::kDrill) return 0;
  return tool.radius() / base::tan(tool.tip_angle.value_or(Radians::of_degrees(kUsualPoint)).radians() / 2);
}

bool makes_holes(const Tool& tool) {
  return tool.kind == ToolKind::kDrill || tool.kind == ToolKind::kReamer ||
         tool.kind == ToolKind::kCounterbore || tool.kind == ToolKind::kBoringBar;
}

bool may_plunge(const Tool& tool) {
  return tool.center_cutting && tool.kind != ToolKind::kTSlot;
}

bool clears_floors(const Tool& tool) {
  return !makes_holes(tool) && tool.kind != ToolKind::kSpotDrill && tool.kind != ToolKind::kVBit &&
         tool.kind != ToolKind::kChamferMill && tool.kind != ToolKind::kTap &&
         tool.kind != ToolKind::kThreadMill && tool.kind != ToolKind::kTSlot;
}

bool mills_upright(const Tool& tool) {
  return clears_floors(tool) && tool.kind != ToolKind::kTapered;
}

}  // namespace clearcut::inline model
