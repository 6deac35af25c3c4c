#include "verify/faults/move_gouge.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/cutter_profile.h"
#include "verify/faults/crossed_draft.h"
#include "verify/faults/undercut.h"
#include "verify/program/gouge.h"
#include "verify/program/shaped_cutter.h"

namespace clearcut::verify {
namespace {

/// The deepest gouge of a cutter that may be `aside` mm off its path. If the cylinder around the cutter would gouge,
/// the cutter's own shape decides.
std::optional<Gouge> gouge_of_mill(const FinishedPart& finished, const Move& move, const Tool& tool,
                                   double aside, double slack, bool joined) {
  const auto gouge = gouge_of(finished, move, tool.radius() + aside, slack, joined);
  const CutterProfile cutter = outer_profile(tool);
  if (!gouge || cutter.is_cylinder()) return gouge;
  const auto shaped = shaped_gouge_of(finished, move, cutter.narrowed(-aside), slack);
  return shaped && shaped->depth < gouge->depth ? shaped : shaped ? gouge : std::nullopt;
}

/// The gouge that `check` finds of a cutter's move into a part. A wall with draft counts as standing where another feature cuts into
/// it: what is no gouge where one such feature alone is cut, as each of two grooves that cross, is none of the whole part either; the
/// places themselves are asked then (crossed_draft.h).
template <typename Check>
std::optional<Gouge> least_gouge(const FinishedParts& finished, const Tool& tool, const Move& move,
                                 Check check) {
  std::optional<Gouge> least = check(finished.for_tool(tool));
  if (!least) return least;
  for (const int feature : finished.drafted_at(move.is_vertical() ? move.path.from : move.path.at(0.5))) {
    const std::optional<Gouge> other = check(finished.with_one_draft(feature));
    if (!other) return other;
    if (other->depth < least->depth) least = other;
  }
  return least;
}

/// The pieces of a move that are looked at one by one, each about a cutter's radius long; vertical moves are one.
constexpr int kMostPiecesOfMove = 200;

std::vector<Move> pieces_of(const Move& move, double radius) {
  if (move.is_vertical() || radius <= 0) return {move};
  const int count =
      std::clamp(static_cast<int>(std::ceil(move.path.length() / radius)), 1, kMostPiecesOfMove);
  std::vector<Move> pieces(static_cast<std::size_t>(count), move);
  for (int i = 0; i < count; ++i) {
    Move& piece = pieces[static_cast<std::size_t>(i)];
    const double a = static_cast<double>(i) / count, b = (i + 1.0) / count;
    piece.path = move.path.part(a, b);
    piece.z_from = std::lerp(move.z_from, move.z_to, a);
    piece.z_to = std::lerp(move.z_from, move.z_to, b);
  }
  return pieces;
}

}  // namespace

std::optional<Gouge> gouge_of_move(const FinishedParts& finished, const CheckedMove& checked,
                                   const Move& move, double aside, double slack, bool joined) {
  const Tool& tool = *checked.tool;
  if (tool.kind == ToolKind::kTSlot) return undercut_gouge_of(finished, move, tool, aside, slack);
  const CutterProfile cutter = outer_profile(tool), wider = aside > 0 ? cutter.narrowed(-aside) : cutter;
  const auto gouge_by = [&](const Move& piece, bool begins_outside) {
    return least_gouge(finished, tool, piece, [&](const FinishedPart& part) {
      return has_flanks(tool) ? shaped_gouge_of(part, piece, wider, slack)
                              : gouge_of_mill(part, piece, tool, aside, slack, begins_outside);
    });
  };
  const auto least = gouge_by(move, joined);
  const FinishedPart& whole = finished.for_tool(tool);
  // A result without fault needs no second test.
  if (!least || least->depth <= slack || whole.greatest_draft_offset() <= 0) return least;
  // Only the pieces of a long move beside a crossed wall need the test of every place.
  for (const Move& piece : pieces_of(move, tool.radius())) {
    const auto own = gouge_by(piece, false);
    if (own && own->depth > slack && !is_clear_of_crossed_draft(whole, piece, wider, slack)) return least;
  }
  return std::nullopt;
}

}  // namespace clearcut::verify
