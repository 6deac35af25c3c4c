#include "model/tool.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/elementary.h"
#include "model/cutter_profile.h"

namespace clearcut::inline model {

namespace {

/// Degrees; of common drills.
constexpr double kUsualPoint = 118;

}  // namespace

const char* name_of(ToolKind kind) {
  return row_of(kind).name;
}

std::optional<ToolKind> tool_kind_named(const std::string& name) {
  for (const ToolKindRow& row : tool_kinds())
    if (name == row.name) return row.kind;
  return std::nullopt;
}

const Tool* tool_numbered(const std::vector<Tool>& tools, int number) {
  const auto found =
      std::find_if(tools.begin(), tools.end(), [&](const Tool& tool) { return tool.number == number; });
  return found == tools.end() ? nullptr : &*found;
}

bool is_conical(const Tool& tool) {
  return row_of(tool.kind).use == ToolUse::kEdges && tool.tip_angle.has_value();
}

double flank_slope(const Tool& tool) {
  return base::tan(tool.tip_angle.value_or(Radians{}).radians() / 2);
}

bool has_flanks(const Tool& tool) {
  return row_of(tool.kind).form == CutterForm::kFlanked && tool.tip_angle.has_value();
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
  return row_of(tool.kind).use == ToolUse::kHoles;
}

bool may_plunge(const Tool& tool) {
  return tool.center_cutting && row_of(tool.kind).use != ToolUse::kUndercuts;
}

bool clears_floors(const Tool& tool) {
  return row_of(tool.kind).use == ToolUse::kFloors;
}

bool mills_upright(const Tool& tool) {
  return clears_floors(tool) && row_of(tool.kind).form != CutterForm::kFlanked;
}

bool works_at_once(const Tool& tool) {
  const ToolUse use = row_of(tool.kind).use;
  return use == ToolUse::kThreads || use == ToolUse::kUndercuts;
}

bool is_driven_down(const Tool& tool) {
  return row_of(tool.kind).straight_down;
}

namespace {

constexpr ToolKindRow kRows[] = {
    {ToolKind::kEndMill, "endmill", ToolUse::kFloors, CutterForm::kRounded},
    {ToolKind::kFaceMill, "facemill", ToolUse::kFloors, CutterForm::kRounded},
    {ToolKind::kBullNoseEndMill, "bullnose", ToolUse::kFloors, CutterForm::kRounded},
    {ToolKind::kBallEndMill, "ball", ToolUse::kFloors, CutterForm::kRounded},
    {ToolKind::kDrill, "drill", ToolUse::kHoles, CutterForm::kPointed, true},
    {ToolKind::kReamer, "reamer", ToolUse::kHoles, CutterForm::kUpright, true},
    {ToolKind::kVBit, "vbit", ToolUse::kEdges, CutterForm::kFlanked},
    {ToolKind::kChamferMill, "chamfer", ToolUse::kEdges, CutterForm::kFlanked},
    {ToolKind::kSpotDrill, "spotdrill", ToolUse::kEdges, CutterForm::kFlanked, true},
    {ToolKind::kTap, "tap", ToolUse::kThreads, CutterForm::kUpright, true},
    {ToolKind::kThreadMill, "threadmill", ToolUse::kThreads, CutterForm::kUpright},
    {ToolKind::kBoringBar, "boringbar", ToolUse::kHoles, CutterForm::kUpright, true},
    {ToolKind::kCounterbore, "counterbore", ToolUse::kHoles, CutterForm::kUpright, true},
    {ToolKind::kTapered, "tapered", ToolUse::kFloors, CutterForm::kFlanked},
    {ToolKind::kTSlot, "tslot", ToolUse::kUndercuts, CutterForm::kUpright},
    {ToolKind::kOther, "other", ToolUse::kFloors, CutterForm::kRounded}};

}  // namespace

std::span<const ToolKindRow> tool_kinds() {
  return kRows;
}

const ToolKindRow& row_of(ToolKind kind) {
  const auto row = std::find_if(std::begin(kRows), std::end(kRows),
                                [&](const ToolKindRow& one) { return one.kind == kind; });
  return row == std::end(kRows) ? *std::prev(std::end(kRows)) : *row;
}

}  // namespace clearcut::inline model
