#include "verify/engagement/tool_takes.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/text.h"

namespace clearcut::verify {

stock::Removal removal_of(const CheckedMove& checked) {
  const double radius = checked.tool->radius();
  if (checked.is_carried()) return {CutterProfile::cylinder(radius), radius};
  return stock::removal_by(*checked.tool);
}

double height_of_edges(const Tool& tool) {
  return tool.kind == ToolKind::kTSlot ? tool.flute_length.value_or(HUGE_VAL) : HUGE_VAL;
}

// Thread depths: the basic profile of ISO 68-1 has 5/8 sqrt(3)/2 P in holes, 17/24 sqrt(3)/2 P about bosses.

namespace {

/// mm. Thinner material at the edge of the permitted ring is due to rounding and to holes slightly off their axis.
constexpr double kTakenSliver = 0.03;
/// mm. Slivers that passes may leave between them: no more than the certificate lets stand.
constexpr double kLeftByDesign = 0.01;
/// mm. Material this far beside a tool's rim is the wall of its hole.
constexpr double kHoleWall = 0.1;
/// mm down for each mm of advance. Steeper moves go down.
constexpr double kDownward = 1;
/// mm down for each mm of advance. On paths of smaller slope the flank of a chamfer mill cuts, ahead of the flat tip,
/// nearly as deep as the tip.
constexpr double kSinking = 0.05;
/// mm in the radius: greatest usual allowance for reamers and boring bars.
constexpr double kReamed = 0.25, kBored = 0.5;
/// mm; from this diameter on reamers may take this share of it: ISO 14649-11 reams 22 mm after a drill of 20 in its
/// example.
constexpr double kLargeReamer = 20, kReamedShare = 0.05;
/// Share of a counterbore's radius: its middle without a cutting edge.
constexpr double kCounterboreEdge = 0.75;
/// mm; radius of a ground flat up to which points of V-bits still cut.
constexpr double kCuttingTip = 0.5;
/// mm; radius of the chisel edge of a spot drill, which cuts only downwards; the drill's flanks can break edges.
constexpr double kSpotChisel = 0.2;
/// mm over the tip of reamers, boring bars and taps for each mm from their axis: lower material does not count. Their
/// ends are chamfered, and their pilot holes end in the point of a drill, 0.6 mm for each mm at 118 degrees.
constexpr double kLead = 0.65;
/// Shares of the pitch, for tapped holes and for thread mills, which also cut around bosses, with the permitted
/// undersize of a hole.
constexpr double kTapped = 0.5413 * 1.05, kThreadMilled = 0.6134 * 1.05;

/// mm; the largest pitch of the part's milled threads, for mills with one row of teeth.
double milled_pitch(const Part& part) {
  double most = 0;
  for (const Feature& feature : part.features) {
    if (feature.hole && feature.hole->kind == HoleKind::kThreadMilled && feature.hole->thread)
      most = std::max(most, feature.hole->thread->pitch);
  }
  return most;
}

double thread_ring(double pitch, double share, const Tool& tool) {
  return pitch > 0 ? pitch * share + kTakenSliver : tool.radius() / 2;
}

ToolTakes drill_row(const Tool& /*tool*/, const Part& /*part*/) {
  return {.sideways = 0};
}
ToolTakes reamer_row(const Tool& tool, const Part& /*part*/) {
  return {.sideways = 0,
          .down = tool.diameter > kLargeReamer ? kReamedShare * tool.diameter : kReamed,
          .lead = kLead,
          .feeds_out = true,
          .needs = "a hole a little narrower than it"};
}
ToolTakes boring_bar_row(const Tool& /*tool*/, const Part& /*part*/) {
  return {.sideways = 0, .down = kBored, .lead = kLead, .needs = "a hole a little narrower than it"};
}
ToolTakes counterbore_row(const Tool& tool, const Part& /*part*/) {
  return {.sideways = 0, .down = kCounterboreEdge * tool.radius(), .needs = "a hole on its axis"};
}
ToolTakes tap_row(const Tool& tool, const Part& /*part*/) {
  return {.sideways = 0,
          .down = thread_ring(tool.pitch, kTapped, tool),
          .lead = kLead,
          .needs = "the hole of its thread"};
}
ToolTakes thread_mill_row(const Tool& tool, const Part& part) {
  const double pitch = tool.pitch > 0 ? tool.pitch : milled_pitch(part);
  return {.sideways = thread_ring(pitch, kThreadMilled, tool),
          .down = 0,
          .needs = "room beside the thread, cleared before"};
}
ToolTakes chamfer_row(const Tool& tool, const Part& /*part*/) {
  return {
      .idle_tip = tool.tip_diameter / 2, .idle_from = kSinking, .needs = "a hole wider than its flat tip"};
}
ToolTakes vbit_row(const Tool& tool, const Part& /*part*/) {
  const double tip = tool.tip_diameter / 2;
  return {.idle_tip = tip > kCuttingTip ? tip : 0, .needs = "a hole wider than its flat tip"};
}

ToolTakes spot_drill_row(const Tool& tool, const Part& part) {
  ToolTakes takes = vbit_row(tool, part);
  takes.sideways = std::max(0.0, tool.radius() - std::max(kSpotChisel, tool.tip_diameter / 2));
  takes.says_sideways = "cuts sideways with its point, which has no edges there: only its flanks break edges";
  return takes;
}

struct TakesRow {
  ToolKind kind;
  ToolTakes (*takes)(const Tool& tool, const Part& part);
};
/// Kinds missing here cut any material before them; whether they may move straight down is a property of the tool.
constexpr TakesRow kRows[] = {{ToolKind::kDrill, drill_row},
                              {ToolKind::kReamer, reamer_row},
                              {ToolKind::kBoringBar, boring_bar_row},
                              {ToolKind::kCounterbore, counterbore_row},
                              {ToolKind::kTap, tap_row},
                              {ToolKind::kThreadMill, thread_mill_row},
                              {ToolKind::kChamferMill, chamfer_row},
                              {ToolKind::kSpotDrill, spot_drill_row},
                              {ToolKind::kVBit, vbit_row}};

/// Material above the underside of the block; the model of the material has none.
struct Block {
  const stock::Material& material;
  double bottom;
};

/// The part of a cutter above the underside of the block, where its tip is at z.
CutterProfile above_underside(CutterProfile profile, double z, double bottom) {
  profile.flat = std::min(profile.widest, profile.flat + profile.slope * std::max(0.0, bottom - z));
  return profile;
}

/// Material within `radius` mm of the path, above the passing tip by `lead` mm for each mm from the axis; nothing for
/// radii indistinguishable from 0.
std::optional<Place> within(const Block& block, const Move& move, double radius, double lead = 0) {
  if (radius <= kTakenSliver) return std::nullopt;
  const double inner = radius - kTakenSliver;
  const CutterProfile pointed = CutterProfile{0, 0, lead > 0 ? 1 / lead : 0, radius}.narrowed(kTakenSliver);
  const auto met = [&](const Edge& path, double tip) {
    const double z = std::max(tip, block.bottom) + kTakenSliver;
    return lead > 0
               ? block.material.in_reach(path, above_underside(pointed, tip, block.bottom), z, kLeftByDesign)
               : block.material.in_reach(path, inner, z, stock::Material::kCylinder, kLeftByDesign);
  };
  if (move.is_vertical() || move.z_from == move.z_to) {
    const double z = std::min(move.z_from, move.z_to);
    const auto hit = met(move.path, z);
    if (!hit) return std::nullopt;
    return Place{move.is_vertical() ? move.path.from : move.path.at(nearest(move.path, *hit).t), z,
                 move.line};
  }
  const int steps = std::max(1, static_cast<int>(std::ceil(move.path.length() / std::max(0.1, radius / 5))));
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps, z = move.z_from + (move.z_to - move.z_from) * t;
    const Vec2 p = move.path.at(t);
    if (met(Edge::line(p, p), z)) return Place{p, z, move.line};
  }
  return std::nullopt;
}

}  // namespace

ToolTakes takes_of(const Tool& tool, const Part& part) {
  for (const TakesRow& row : kRows)
    if (row.kind == tool.kind) return row.takes(tool, part);
  return {};
}

std::optional<Overcut> overcut_of(const CheckedMove& checked, const ToolTakes& takes,
                                  const stock::Material& material, double bottom) {
  const Block block{material, bottom};
  const Move& move = *checked.move;
  const double radius = checked.radius(), low = checked.low_z();
  if (low >= material.z_top() - kTakenSliver || radius <= kTakenSliver) return std::nullopt;
  if (!checked.feeds()) {
    if (!takes.feeds_out || !move.is_vertical()) return std::nullopt;
    const auto wall = within(block, move, radius + kHoleWall);
    return wall ? std::optional(Overcut{*wall, kHoleWall, false}) : std::nullopt;
  }
  // Tools without lateral cutting move only along their axis.
  const bool is_along_axis = move.is_vertical() || move.path.length() <= kTakenSliver;
  const bool down = checked.slope() >= kDownward && (takes.sideways > 0 || is_along_axis);
  if (takes.idle_tip > 0 && checked.slope() >= takes.idle_from) {
    const auto met = within(block, move, takes.idle_tip);
    return met ? std::optional(Overcut{*met, takes.idle_tip, false}) : std::nullopt;
  }
  if (move.is_vertical() && !down) return std::nullopt;
  const double ring = down ? takes.down : takes.sideways;
  if (ring >= radius) return std::nullopt;
  const auto met = within(block, move, radius - ring, down ? takes.lead : 0);
  return met ? std::optional(Overcut{*met, radius - ring, !down}) : std::nullopt;
}

std::string overcut_text(const CheckedMove& checked, const Part& part) {
  const Tool& tool = *checked.tool;
  const ToolTakes takes = takes_of(tool, part);
  const std::string name = "T" + std::to_string(tool.number) + ", a " + name_of(tool.kind) + ",";
  if (!checked.feeds())
    return name + " comes out of its hole, or goes into it, at the rapid; it feeds in and out";
  if (checked.load.overcut->sideways && *takes.says_sideways) return name + " " + takes.says_sideways;
  if (checked.load.overcut->sideways && takes.sideways > 0)
    return name + " takes more than " + trimmed(takes.sideways, 2) + " mm at its rim; it needs " +
           takes.needs;
  if (checked.load.overcut->sideways) return name + " cuts sideways, where it has no edges";
  if (takes.idle_tip > 0)
    return name + " goes down into material with its flat tip, which does not cut; it needs " + takes.needs;
  return name + " goes down into material that it cannot take" +
         (takes.down > 0 ? " (a ring of " + trimmed(takes.down, 2) + " mm at most)" : "") + "; it needs " +
         takes.needs;
}

}  // namespace clearcut::verify
