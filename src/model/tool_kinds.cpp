#include "model/tool_kinds.h"

#include <algorithm>
#include <iterator>

namespace clearcut::inline model {
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
