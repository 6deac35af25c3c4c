#include "verify/faults/undercut.h"

#include <algorithm>
#include <cmath>

namespace clearcut::verify {
namespace {

bool comes_into(const Undercut& undercut, const Edge& path, double radius) {
  if (undercut.outline.winding(path.from) != 0) return true;
  bool touches = false;
  const bool is_point = path.from == path.to;
  const double half = is_point ? 0 : path.length() / 2;
  undercut.outline.within(is_point ? path.from : path.at(0.5), half + radius, [&](int i) {
    const Edge& wall = undercut.outline.edges()[static_cast<std::size_t>(i)];
    touches = touches || (is_point ? distance(wall, path.from) : distance(path, wall)) < radius;
  });
  return touches;
}

/// The lowest of the undercuts entered by the disc; null if there is none.
const Undercut* lowest_roof(const FinishedParts& finished, const Edge& path, double radius) {
  const Undercut* lowest = nullptr;
  for (const Undercut& undercut : finished.undercuts()) {
    if ((!lowest || undercut.roof < lowest->roof) && comes_into(undercut, path, radius)) lowest = &undercut;
  }
  return lowest;
}

/// The gouge of the disc's upper side in undercuts that are too low for it, outside of undercuts that are high
/// enough.
std::optional<Gouge> gouge_of_roof(const FinishedParts& finished, const Move& move, double height,
                                   double radius, double slack) {
  const double highest = std::max(move.z_from, move.z_to);
  const Undercut* const undercut = lowest_roof(finished, move.path, radius);
  if (!undercut || highest + height <= undercut->roof) return std::nullopt;
  const auto met = gouge_of(finished.opened_up_to(highest + height), move, radius, slack, false);
  if (!met) return std::nullopt;
  const Vec2 at = move.z_from < move.z_to ? move.path.to : move.path.from;
  const double depth = std::min(highest + height - undercut->roof, met->depth);
  return Gouge{depth, at, highest, false, undercut->feature, CutterPart::kDisc};
}

Move raised(Move move, double by) {
  move.z_from += by;
  move.z_to += by;
  return move;
}

std::optional<Gouge> deeper(const std::optional<Gouge>& a, const std::optional<Gouge>& b) {
  if (!a || (b && b->depth > a->depth)) return b;
  return a;
}

}  // namespace

std::optional<Gouge> undercut_gouge_of(const FinishedParts& finished, const Move& move, const Tool& tool,
                                       double aside, double slack) {
  const double radius = tool.radius() + aside;
  const std::optional<Gouge> under = gouge_of(finished.plain(), move, radius, slack, false);
  if (!under || finished.undercuts().empty()) return under;
  const double height = tool.flute_length.value_or(HUGE_VAL);
  std::optional<Gouge> neck =
      gouge_of(finished.plain(), raised(move, height), tool.shank_diameter / 2 + aside, slack, false);
  if (neck) neck->by = CutterPart::kNeck;
  return deeper(deeper(gouge_of(finished.opened(), move, radius, slack, false), neck),
                gouge_of_roof(finished, move, height, radius, slack));
}

}  // namespace clearcut::verify
