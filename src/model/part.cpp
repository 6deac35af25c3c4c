#include "model/part.h"

#include <algorithm>

namespace clearcut::inline model {

namespace {

constexpr double kSafeHeight = 10;   // mm above the part if the file gives no security plane
constexpr double kOverKeepOuts = 2;  // mm above the highest clamp, likewise

}  // namespace

const char* name_of(FeatureKind kind) {
  switch (kind) {
    case FeatureKind::kClosedPocket:
      return "closed_pocket";
    case FeatureKind::kOpenPocket:
      return "open_pocket";
    case FeatureKind::kPlanarFace:
      return "planar_face";
    case FeatureKind::kSlot:
      return "slot";
    case FeatureKind::kStep:
      return "step";
    case FeatureKind::kRoundHole:
      return "round_hole";
    case FeatureKind::kOutsideProfile:
      return "outside_profile";
    case FeatureKind::kInsideProfile:
      return "inside_profile";
    case FeatureKind::kEngraving:
      return "engraving";
    case FeatureKind::kVCarving:
      return "v_carving";
    case FeatureKind::kChamfer:
      return "chamfer";
    case FeatureKind::kExternalThread:
      return "external_thread";
    case FeatureKind::kIsolation:
      return "isolation";
    case FeatureKind::kTSlot:
      return "t_slot";
  }
  return "feature";
}

double Part::top_z() const {
  if (stock) return stock->z_top;
  double top = features.empty() ? 0 : features.front().top_z;
  for (const Feature& feature : features) top = std::max(top, feature.top_z);
  return top;
}

double Part::safe_z() const {
  if (clearance_z) return *clearance_z;
  double safe = top_z() + kSafeHeight;
  for (const KeepOut& block : keep_outs) safe = std::max(safe, block.top_z + kOverKeepOuts);
  return safe;
}

const Tool& tool_of(const Part& part, const Workingstep& step) {
  return part.tools.at(static_cast<std::size_t>(step.operation.tool));
}

const Feature& feature_of(const Part& part, const Workingstep& step) {
  return part.features.at(static_cast<std::size_t>(step.feature));
}

const StatedPath* path_of(const Workingstep& step) {
  return step.stated_path && step.stated_path->is_used ? &*step.stated_path : nullptr;
}

bool is_carved(const Feature& feature, const Tool& tool) {
  if (feature.carving || feature.chamfer) return is_conical(tool);
  return feature.kind == FeatureKind::kEngraving && (is_conical(tool) || tool.kind == ToolKind::kBallEndMill);
}

bool is_formed(const Feature& feature) {
  if (!feature.hole) return false;
  const HoleKind kind = feature.hole->kind;
  return kind == HoleKind::kSpotted || kind == HoleKind::kCountersunk || kind == HoleKind::kTapped ||
         kind == HoleKind::kThreadMilled;
}

bool closed_all_round(const Feature& feature) {
  return feature.kind == FeatureKind::kClosedPocket || feature.kind == FeatureKind::kRoundHole ||
         feature.kind == FeatureKind::kVCarving;
}

}  // namespace clearcut::inline model
