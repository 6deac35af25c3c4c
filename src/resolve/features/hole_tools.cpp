#include "resolve/features/hole_tools.h"

#include <algorithm>
#include <cmath>

#include "model/cutter_profile.h"

namespace clearcut::resolve {
namespace {

/// mm. Greatest difference of width between a tool and its hole.
constexpr double kSameWidth = 0.005;
/// mm. Greatest difference between equal pitches, allowing for rounding of inches.
constexpr double kSamePitch = 0.002;
/// mm; least difference in width between a thread mill and the hole around it.
constexpr double kBesideThreadMill = 0.2;
/// Least width of a bored hole as a multiple of the mill's width: the helix of a mill in a narrower hole has too many
/// turns.
constexpr double kLeastBore = 1.1;
/// mm. Permitted depth of a feature's floor below the material: the surface below the board bears this.
constexpr double kBelowStock = 0.5;
/// mm. Ends of tools that are lower by less end on the underside.
constexpr double kOnUnderside = 0.005;

bool is(const Tool& tool, ToolKind kind, double width) {
  return tool.kind == kind && std::abs(tool.diameter - width) < kSameWidth;
}

/// Index of the tool with the least `cost` for which `does` is true; -1 for none.
int best_tool(const std::vector<Tool>& tools, const std::function<bool(const Tool&)>& does,
              const std::function<double(const Tool&)>& cost) {
  int best = -1;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    if (!does(tools[i])) continue;
    if (best < 0 || cost(tools[i]) < cost(tools[static_cast<std::size_t>(best)])) best = static_cast<int>(i);
  }
  return best;
}

/// Whether the flat tip of a cone does not cut into solid material.
bool has_idle_tip(const Tool& tool) {
  constexpr double kCuttingTip = 1;  // mm
  return tool.tip_diameter > (tool.kind == ToolKind::kChamferMill ? 0 : kCuttingTip);
}

}  // namespace

Pilot pilot_before(const Thread& thread) {
  const double least = minor_diameter(thread), most = least + minor_tolerance(thread);
  return {least, std::clamp(thread.diameter - thread.pitch, least, most), most};
}

/// Reamers take 0.05 to 0.5 mm, 0.2 at best; boring bars 0.1 to 1 mm.
Pilot pilot_before(const HoleForm& hole, const Tool& tool) {
  const double d = hole.diameter;
  if (tool.kind == ToolKind::kReamer) return {d - 0.5, d - 0.2, d - 0.05};
  return {d - 1, d - 0.5, d - 0.1};
}

int tool_where(const std::vector<Tool>& tools, const std::function<bool(const Tool&)>& does) {
  return best_tool(tools, does, [](const Tool&) { return 0.0; });
}

int tool_of_kind(const std::vector<Tool>& tools, const HoleForm& hole) {
  const ToolKind kind = hole.kind == HoleKind::kReamed         ? ToolKind::kReamer
                        : hole.kind == HoleKind::kBored        ? ToolKind::kBoringBar
                        : hole.kind == HoleKind::kCounterbored ? ToolKind::kCounterbore
                                                               : ToolKind::kDrill;
  const int own = tool_where(tools, [&](const Tool& tool) { return is(tool, kind, hole.diameter); });
  if (own >= 0 || hole.kind == HoleKind::kReamed || hole.kind == HoleKind::kDrilled) return own;
  // A mill able to bore the hole along a helix, or to clear it: a rounded end leaves its shape in the corner.
  const auto widest = [&](bool flat) {
    return best_tool(
        tools,
        [&](const Tool& tool) {
          return mills_upright(tool) && tool.diameter < hole.diameter + kSameWidth &&
                 (!flat || flat_end(tool) >= tool.radius());
        },
        [](const Tool& tool) { return -tool.diameter; });
  };
  const int sharp = widest(true);
  return sharp >= 0 ? sharp : widest(false);
}

int tap_for(const std::vector<Tool>& tools, const Thread& thread) {
  return tool_where(tools, [&](const Tool& tool) {
    return is(tool, ToolKind::kTap, thread.diameter) && std::abs(tool.pitch - thread.pitch) < kSamePitch &&
           tool.left_hand == thread.left_hand;
  });
}

int thread_mill_for(const std::vector<Tool>& tools, const Thread& thread, bool external) {
  return best_tool(
      tools,
      [&](const Tool& tool) {
        return tool.kind == ToolKind::kThreadMill &&
               (external || tool.diameter < minor_diameter(thread) - kBesideThreadMill) &&
               (tool.pitch == 0 || std::abs(tool.pitch - thread.pitch) < kSamePitch);
      },
      [external](const Tool& tool) { return external ? tool.diameter : -tool.diameter; });
}

int cone_for(const std::vector<Tool>& tools, const HoleForm& hole, Radians lean) {
  constexpr double kSameLean = 0.002;  // radians
  const ToolKind first = hole.kind == HoleKind::kSpotted ? ToolKind::kSpotDrill : ToolKind::kChamferMill;
  return best_tool(
      tools,
      [&](const Tool& tool) {
        return is_conical(tool) && tool.diameter > hole.diameter - kSameWidth &&
               (lean.radians() == 0 || std::abs(tool.tip_angle->radians() / 2 - lean.radians()) < kSameLean);
      },
      [&](const Tool& tool) {
        const bool is_blunt = hole.kind == HoleKind::kSpotted && has_idle_tip(tool);
        return tool.diameter + (tool.kind == first ? 0 : 1000) + (is_blunt ? 10000 : 0);
      });
}

int drill_for(const std::vector<Tool>& tools, const Pilot& pilot) {
  return best_tool(
      tools,
      [&](const Tool& tool) {
        return tool.kind == ToolKind::kDrill && tool.diameter > pilot.least - kSameWidth &&
               tool.diameter < pilot.most + kSameWidth;
      },
      [&](const Tool& tool) { return std::abs(tool.diameter - pilot.best); });
}

int mill_for(const std::vector<Tool>& tools, const Pilot& pilot) {
  return best_tool(
      tools,
      [&](const Tool& tool) {
        return mills_upright(tool) && tool.corner_radius == 0 && tool.diameter * kLeastBore <= pilot.best;
      },
      [](const Tool& tool) { return -tool.diameter; });
}

bool comes_out_below(const Part& part, const Feature& feature, double z) {
  return part.stock && !feature.through && part.stock->z_bottom - z > kOnUnderside;
}

bool lies_below(const Part& part, const Feature& feature, double floor) {
  return part.stock && !feature.through && part.stock->z_bottom - floor > kBelowStock + kSamePlaceMm;
}

double asked_floor(const Feature& feature) {
  return feature.hole ? std::max(feature.floor_z, feature.hole->full_z) : feature.floor_z;
}

void mark_ways_through(Part& part) {
  for (const Workingstep& step : part.workplan) {
    Feature& feature = part.features[static_cast<std::size_t>(step.feature)];
    const bool is_drilled = feature.kind == FeatureKind::kRoundHole && !feature.hole &&
                            tool_of(part, step).kind == ToolKind::kDrill;
    const double floor = asked_floor(feature);
    if (!is_drilled && comes_out_below(part, feature, floor) && !lies_below(part, feature, floor))
      feature.through = true;
  }
}

}  // namespace clearcut::resolve
