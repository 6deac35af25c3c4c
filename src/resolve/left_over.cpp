#include "resolve/left_over.h"

#include <algorithm>
#include <cmath>

#include "base/tolerances.h"
#include "features/round_hole.h"
#include "geometry/contours/boolean.h"
#include "geometry/voronoi/clearance.h"
#include "model/cutter_profile.h"

namespace clearcut::resolve {
namespace {

/// mm. The area assumed as swept is smaller by this than the really swept area.
constexpr double kSpare = 0.002;
/// mm. Rests narrower than twice this are left out: more than the strip left by kSpare along walls.
constexpr double kSliver = 0.003;
/// mm. Material left by an earlier program within this distance of its cut area is accepted: the certificate allows
/// more.
constexpr double kResidual = 0.007;
/// mm. Half the width of slivers of that material caused by the chords of swept arcs.
constexpr double kResidualSliver = 0.001;
/// mm. Overlap of the area planned for a rest with areas already cut.
constexpr double kOverlap = 0.05;
/// mm. Chord of the arcs of an earlier program.
constexpr double kChord = 0.002;

const Workingstep& step_at(const Part& part, int index) {
  return part.workplan.at(static_cast<std::size_t>(index));
}

/// Outline of the area swept by a disc along a line.
Loop capsule(Vec2 a, Vec2 b, double radius) {
  const Vec2 across = left_of(a == b ? Vec2{1, 0} : (b - a) / distance(a, b)) * radius;
  const Edge end = Edge::arc(b - across, b + across, b, Turn::kCounterClockwise);
  const Edge start = Edge::arc(a + across, a - across, a, Turn::kCounterClockwise);
  if (a == b) return {end, Edge::arc(a + across, a - across, a, Turn::kCounterClockwise)};
  return {Edge::line(a - across, b - across), end, Edge::line(b + across, a + across), start};
}

/// Outlines whose union is the area within `radius` mm of a move.
void add_swept(const Move& move, double radius, std::vector<Loop>& out) {
  if (move.is_vertical()) return out.push_back(capsule(move.path.from, move.path.from, radius));
  std::vector<Vec2> points{move.path.from};
  append_flattened(move.path, kChord, points);
  for (std::size_t i = 1; i < points.size(); ++i) out.push_back(capsule(points[i - 1], points[i], radius));
}

/// Union of many outlines, pairwise, so that each outline takes part in few operations.
Regions union_of(std::span<const Loop> loops, const Tolerances& tol) {
  constexpr std::size_t kAtOnce = 64;
  if (loops.size() <= kAtOnce) return resolve_nonzero(loops, tol);
  const std::size_t half = loops.size() / 2;
  return unite(union_of(loops.first(half), tol), union_of(loops.subspan(half), tol), tol);
}

/// mm; height of the highest tip of a move, of plunges of the lowest.
double tip_of(const Move& move) {
  return move.is_vertical() ? std::min(move.z_from, move.z_to) : std::max(move.z_from, move.z_to);
}

/// The area cut down to z near `where` by the earlier program, for a feature beginning at `top`, with residuals
/// beside this area.
Regions cut_by_program(const Toolpath& toolpath, const Part& part, double z, double top, const Box& where,
                       Tolerances tol) {
  tol.chord = kChord;
  std::vector<Loop> loops;
  for (const Section& section : toolpath.sections) {
    const Tool* const tool = tool_numbered(part.tools, section.tool_number);
    if (tool == nullptr || tool->kind == ToolKind::kTSlot || !section.counts_below(top)) continue;
    // Cuts of earlier set-ups were made narrower, by the ends of their cutters, when they were carried over.
    const CutterProfile removes =
        section.carried_below ? CutterProfile::cylinder(tool->radius()) : inner_profile(*tool);
    for (const Move& move : section.moves) {
      if (is_rapid(move.kind) || tip_of(move) > z + kSamePlaceMm) continue;
      const double radius = removes.radius_at(std::max(0.0, z - tip_of(move)));
      const Box path = move.path.box();
      if (radius > 0 && path.grown(radius).overlaps(where)) add_swept(move, radius + kResidual, loops);
    }
  }
  return loops.empty() ? Regions{} : union_of(loops, tol);
}

/// The part of a layer within reach of the flat end of a step's cutter, including lines on which the cutter just
/// fits. Ball ends are planned as flat.
Regions within_reach(const Layer& layer, const Tool& tool, double stock, const Tolerances& tol) {
  const double radius = tool.radius(), flat = flat_end(tool) > 0 ? std::min(radius, flat_end(tool)) : radius;
  Regions reached = swept(layer.allowed, radius, stock, flat - radius, tol);
  std::vector<Loop> fitting;
  for (const Region& region : layer.allowed) {
    for (const Path& line : Clearance(region, tol).fit_lines(radius + stock, layer.reserve)) {
      for (const Edge& edge : line) add_swept({edge, 0, 0, MoveKind::kCut, {}, 0}, flat, fitting);
    }
  }
  return fitting.empty() ? reached : unite(reached, union_of(fitting, tol), tol);
}

/// z of the lowest tip of a step.
double lowest_tip(const Part& part, const Workingstep& step) {
  return feature_of(part, step).floor_z + step.operation.allowance_floor;
}

bool reaches(const Part& part, const Workingstep& step, double z) {
  if (step.operation.kind == OperationKind::kSideFinishing) return false;  // only along the walls
  return lowest_tip(part, step) <= z + kSamePlaceMm && !makes_holes(tool_of(part, step));
}

/// mm; difference between the full radius of a step's cutter and its cleared radius at z, if its lowest passes run
/// deeper.
double narrower_at(const Part& part, const Workingstep& step, double z) {
  const Tool& tool = tool_of(part, step);
  return std::max(0.0, tool.radius() - radius_cleared(tool, z - lowest_tip(part, step)));
}

}  // namespace

Regions swept(const Regions& allowed, double radius, double stock, double more, const Tolerances& tol) {
  const Regions legal = inset(allowed, radius + stock, tol);
  return legal.empty() || radius + more <= 0 ? Regions{} : dilate(legal, radius + more, tol);
}

Regions left_over(const Part& part, int workingstep, const Layer& layer,
                  const std::optional<Toolpath>& earlier, const Tolerances& tol, const RoomBefore& room) {
  const Workingstep& own = step_at(part, workingstep);
  Regions left = layer.target;
  const bool upright = feature_of(part, own).wall_slope.radians() == 0;
  for (int i = 0; upright && i < workingstep && !left.empty(); ++i) {
    const Workingstep& step = step_at(part, i);
    if (step.feature != own.feature || !reaches(part, step, layer.z)) continue;
    const double stock = step.operation.allowance_side + layer.reserve;
    const std::optional<Regions> bounded = room ? room(i) : std::nullopt;
    left = subtract(left,
                    swept(bounded ? *bounded : layer.allowed, tool_of(part, step).radius(), stock,
                          -kSpare - narrower_at(part, step, layer.z), tol),
                    tol);
  }
  const double own_stock = own.operation.allowance_side;
  if (earlier && !left.empty()) {
    left = subtract(
        left, cut_by_program(*earlier, part, layer.z, feature_of(part, own).top_z, box(left), tol), tol);
    if (!left.empty())
      left = intersect(left, within_reach(layer, tool_of(part, own), own_stock + layer.reserve, tol), tol);
  }
  if (own_stock > 0 && !left.empty()) left = intersect(left, inset(layer.allowed, own_stock, tol), tol);
  const double sliver = earlier ? kResidualSliver : kSliver;
  const Regions thick = inset(left, sliver, tol);
  if (thick.empty()) return thick;
  // Up to the wall across the stock left there: targets are bounded by walls or by cut areas.
  const double grow = sliver + (earlier ? kResidual : 0) + kOverlap + 1.5 * own_stock;
  return intersect(dilate(thick, grow, tol), layer.target, tol);
}

bool meets_earlier(const Part& part, int workingstep, const std::optional<Toolpath>& earlier) {
  if (!earlier) return false;
  const Feature& feature = feature_of(part, step_at(part, workingstep));
  const Box here = box(feature.target);
  return std::any_of(earlier->sections.begin(), earlier->sections.end(), [&](const Section& section) {
    if (!section.carried_below) return true;
    const Tool* const tool = tool_numbered(part.tools, section.tool_number);
    return section.counts_below(feature.top_z) && tool != nullptr &&
           std::any_of(section.moves.begin(), section.moves.end(), [&](const Move& move) {
             const Box path = move.path.box();
             return path.grown(tool->radius()).overlaps(here);
           });
  });
}

bool follows_milling(const Part& part, int workingstep) {
  const Workingstep& own = step_at(part, workingstep);
  for (int i = 0; i < workingstep; ++i) {
    const Workingstep& step = step_at(part, i);
    if (step.feature == own.feature && !makes_holes(tool_of(part, step))) return true;
  }
  return false;
}

bool is_thicker_than(const Regions& left, double thickness, const Tolerances& tol) {
  return std::any_of(left.begin(), left.end(),
                     [&](const Region& region) { return !inset(region, thickness / 2, tol).empty(); });
}

}  // namespace clearcut::resolve
