#include "verify/faults/loose_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/text/format.h"
#include "verify/faults/faults.h"
#include "verify/faults/lowest_tip.h"
#include "verify/part/edge_tree.h"

namespace clearcut::verify {
namespace {

/// Distance of places along the kerf as a share of the cutter's radius.
constexpr double kAlongKerf = 0.25;
/// mm. Places nearer to the outline than the cutter's radius, by more than this, are in a corner without a contour
/// pass.
constexpr double kOnContour = 1e-3;

using Moves = std::vector<CheckedMove>;

/// Whether the profile separates its inside from the rest.
bool frees(const Part& part, const Feature& feature, const Tolerances& tol) {
  if (!feature.profile || !feature.profile->closed) return false;
  // Followed lines are engraved, unless they go down to the underside of a stock.
  const bool is_through =
      feature.profile->side == ProfileSide::kOn ? part.stock.has_value() : feature.through;
  const bool is_held = !is_through || !feature.profile->tabs.empty();
  const double underside = feature.floor_z + feature.profile->beyond;
  return !is_held && (!part.stock || underside <= part.stock->z_bottom + tol.uncut);
}

/// mm; radius of the feature's cutter, 0 if there is none.
double radius_for(const Part& part, std::size_t feature) {
  for (const Workingstep& step : part.workplan)
    if (step.feature == static_cast<int>(feature)) return tool_of(part, step).radius();
  return 0;
}

/// The piece freed by one profile.
class Piece {
 public:
  Piece(const Feature& feature, double radius, const Tolerances& tol)
      : feature_(feature),
        cut_(*feature.profile),
        radius_(radius),
        underside_(feature.floor_z + cut_.beyond + tol.uncut),
        box_(box(cut_.line)) {}

  /// Whether the move cuts in the piece.
  bool is_cut_by(const CheckedMove& checked) const {
    if (checked.earlier || checked.is_carried() || !checked.cuts()) return false;
    const Edge& path = checked.move->path;
    if (checked.move->is_vertical()) return holds(path.from);
    return holds(path.from) || holds(path.at(0.5)) || holds(path.to);
  }

  /// Index of the move before `last` that frees the piece; absent if the piece is still held.
  std::optional<std::size_t> freed_at(const Moves& moves, std::size_t last) const {
    const EdgeTree outline(Path(cut_.line));
    std::optional<std::size_t> freed;
    for (const Edge& edge : cut_.line) {
      const int count = 1 + static_cast<int>(std::ceil(edge.length() / (kAlongKerf * radius_)));
      for (int i = 0; i < count; ++i) {
        const Vec2 p = beside(edge, (i + 0.5) / count);
        if (outline.distance_to(p) < std::abs(to_middle()) - kOnContour) continue;
        const auto cut = first_over(p, moves, last);
        if (!cut) return std::nullopt;
        freed = std::max(freed.value_or(0), *cut);
      }
    }
    return freed;
  }

 private:
  bool holds(Vec2 p) const {
    if (!box_.contains(p) || !contains(cut_.line, p)) return false;
    return cut_.side == ProfileSide::kOutside || !contains(feature_.allowed, p);
  }

  /// The middle of the kerf; the outline is counter-clockwise.
  Vec2 beside(const Edge& edge, double t) const {
    return edge.at(t) + left_of(edge.tangent_at(t)) * to_middle();
  }

  /// mm to the left of the outline.
  double to_middle() const {
    if (cut_.side == ProfileSide::kOn) return 0;
    return cut_.side == ProfileSide::kOutside ? -radius_ : radius_;
  }

  /// Index of the first move with its tip at the underside over p.
  std::optional<std::size_t> first_over(Vec2 p, const Moves& moves, std::size_t last) const {
    for (std::size_t i = 0; i < last; ++i) {
      const CheckedMove& checked = moves[i];
      if (!checked.feeds() || checked.radius() <= 0 || checked.low_z() > underside_) continue;
      const auto tip = lowest_tip(checked, p);
      if (tip && *tip <= underside_) return i;
    }
    return std::nullopt;
  }

  const Feature& feature_;
  const ProfileCut& cut_;
  double radius_;
  double underside_;
  Box box_;
};

std::optional<Fault> fault_of_piece(const Part& part, const Feature& feature, const Piece& piece,
                                    const Moves& moves) {
  std::vector<std::size_t> cuts;
  for (std::size_t i = 0; i < moves.size(); ++i)
    if (piece.is_cut_by(moves[i])) cuts.push_back(i);
  if (cuts.empty()) return std::nullopt;
  const auto freed = piece.freed_at(moves, cuts.back());
  if (!freed) return std::nullopt;
  const auto first = std::upper_bound(cuts.begin(), cuts.end(), *freed);
  double length = 0;
  for (auto i = first; i != cuts.end(); ++i) length += moves[*i].move->length();
  const Move& move = *moves[*first].move;
  const std::string what = feature.profile->side == ProfileSide::kOutside ? "the part" : "the piece";
  return fault_of(part, FaultKind::kLoosePart, moves[*first], {move.path.from, move.z_to, move.line}, length,
                  "Cuts in " + what + " that " + feature.name +
                      " has cut free: cut it out last, leave tabs, or state the stock if it is thicker");
}

}  // namespace

std::vector<Fault> faults_of_loose_parts(const Part& part, const CheckedProgram& program,
                                         const Tolerances& tol) {
  std::vector<Fault> faults;
  for (std::size_t i = 0; i < part.features.size(); ++i) {
    const Feature& feature = part.features[i];
    const double radius = radius_for(part, i);
    if (radius <= 0 || !frees(part, feature, tol)) continue;
    const Piece piece(feature, radius, tol);
    if (auto fault = fault_of_piece(part, feature, piece, program.moves)) faults.push_back(*std::move(fault));
  }
  return faults;
}

}  // namespace clearcut::verify
