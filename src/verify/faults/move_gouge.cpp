#include "verify/faults/move_gouge.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/cutter_profile.h"
#include "verify/faults/foot_fillet.h"
#include "verify/program/shaped_cutter.h"

namespace clearcut::verify {
namespace {

/// mm. So much nearer to its axis the cutter's surface is taken to be, and so far beside anything cleared a place is solid: both together are
/// less than the smallest gouge that counts.
constexpr double kNarrower = 0.0006, kSolid = 0.0003;
/// Greatest number of cells tested for one move; more would take seconds.
constexpr int kMostCells = 400000;
/// Pieces of a sloping move at most.
constexpr int kMostPieces = 32;
constexpr double kSqrt2 = 1.41421356237309515;

struct Cell {
  Vec2 center;
  double half = 0;
};

double distance_from(const Edge& path, Vec2 p) {
  return path.from == path.to ? distance(path.from, p) : distance(path, p);
}

class SweptArea {
 public:
  SweptArea(const FinishedPart& part, const CutterProfile& cutter) : part_(part), cutter_(cutter) {}

  bool is_clear(const Edge& path, double z) {
    const Box box = path.box().grown(cutter_.widest);
    std::vector<Cell> cells{{box.center(), std::max(box.width(), box.height()) / 2}};
    while (!cells.empty()) {
      const Cell cell = cells.back();
      cells.pop_back();
      if (++looked_at_ > kMostCells) return false;
      const double far = cell.half * kSqrt2, off = distance_from(path, cell.center);
      if (off - far >= cutter_.widest) continue;
      const double cleared = part_.cleared_by(cell.center, z + cutter_.height_at(std::max(0.0, off - far)));
      if (cleared >= far) continue;
      if (cleared < -kSolid && off < cutter_.widest &&
          part_.cleared_by(cell.center, z + cutter_.height_at(off)) < -kSolid)
        return false;
      if (far < kSolid) continue;
      const double half = cell.half / 2;
      for (const Vec2 corner : {Vec2{half, half}, Vec2{-half, half}, Vec2{half, -half}, Vec2{-half, -half}})
        cells.push_back({cell.center + corner, half});
    }
    return true;
  }

 private:
  const FinishedPart& part_;
  CutterProfile cutter_;
  int looked_at_ = 0;
};

}  // namespace

bool is_clear_of_crossed_draft(const FinishedPart& part, const Move& move, const CutterProfile& cutter,
                               double slack) {
  SweptArea area(part, cutter.narrowed(kNarrower));
  const double low = std::min(move.z_from, move.z_to), high = std::max(move.z_from, move.z_to);
  if (move.is_vertical() || low == high) return area.is_clear(move.path, low + slack);
  const double span = high - low;
  const int pieces = std::clamp(static_cast<int>(std::ceil(span / kSolid)), 1, kMostPieces);
  for (int i = 0; i < pieces; ++i) {
    const double a = static_cast<double>(i) / pieces, b = (i + 1.0) / pieces;
    const double z = std::min(std::lerp(move.z_from, move.z_to, a), std::lerp(move.z_from, move.z_to, b));
    if (!area.is_clear(move.path.part(a, b), z + slack)) return false;
  }
  return true;
}

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
/// places themselves are asked then (move_gouge.h).
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

/// The deepest gouge of the walls and floors themselves; `wider`: the tool's profile, `aside` mm wider.
std::optional<Gouge> wall_gouge_of(const FinishedParts& finished, const Tool& tool,
                                   const CutterProfile& wider, const Move& move, double aside, double slack,
                                   bool joined) {
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

}  // namespace

std::optional<Gouge> gouge_of_move(const FinishedParts& finished, const CheckedMove& checked,
                                   const Move& move, double aside, double slack, bool joined) {
  const Tool& tool = *checked.tool;
  if (tool.kind == ToolKind::kTSlot) return undercut_gouge_of(finished, move, tool, aside, slack);
  const CutterProfile cutter = outer_profile(tool), wider = aside > 0 ? cutter.narrowed(-aside) : cutter;
  return deeper(wall_gouge_of(finished, tool, wider, move, aside, slack, joined),
                fillet_gouge_of(finished.plain(), move, wider));
}

}  // namespace clearcut::verify
