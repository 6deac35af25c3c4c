#include "model/tool.h"

namespace clearcut::inline model {

namespace {

struct ToolName {
  ToolKind kind;
  const char* name;
};
constexpr ToolName kNames[] = {{ToolKind::kEndMill, "endmill"},  {ToolKind::kFaceMill, "facemill"},
                               {ToolKind::kBallEndMill, "ball"}, {ToolKind::kBullNoseEndMill, "bullnose"},
                               {ToolKind::kDrill, "drill"},      {ToolKind::kReamer, "reamer"},
                               {ToolKind::kOther, "other"}};

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

}  // namespace clearcut::inline model
