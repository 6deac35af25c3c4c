#include "verify/faults/stock_to_leave.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/contours/boolean.h"
#include "verify/faults/move_gouge.h"

namespace clearcut::verify {
namespace {

/// mm along a move that comes too near to a wall, and the greatest number of places.
constexpr double kLeftStep = 0.1;
constexpr double kMostLeftSteps = 2000;
/// Shares of a cutter's height at which the distance of rounded ends and flanks from inclined walls is measured.
constexpr std::array kShares{0.0, 0.05, 0.15, 0.3, 0.5, 0.75, 1.0};

int steps_along(const Move& move) {
  if (move.is_vertical()) return 1;
  return static_cast<int>(std::clamp(std::ceil(move.path.length() / kLeftStep), 1.0, kMostLeftSteps));
}

double lowest_of(const Move& move) {
  return std::min(move.z_from, move.z_to);
}

double apart_of(const Edge& path, const Edge& wall) {
  return path.from == path.to ? distance(wall, path.from) : distance(path, wall);
}

/// Whether the tool's own shape makes the feature, so that no stock can be left.
bool is_made_to_size(const Part& part, const Workingstep& step) {
  const Feature& feature = feature_of(part, step);
  if (step.operation.tool < 0 || step.operation.tool >= static_cast<int>(part.tools.size())) return false;
  const Tool& tool = tool_of(part, step);
  return makes_holes(tool) || tool.kind == ToolKind::kTSlot || is_formed(feature) || is_carved(feature, tool);
}

Part with_raised_floors(const Part& part, const std::vector<double>& by) {
  Part raised = part;
  for (std::size_t i = 0; i < by.size(); ++i) {
    Feature& feature = raised.features[i];
    if (!feature.through) feature.floor_z = std::min(feature.top_z, feature.floor_z + by[i]);
  }
  return raised;
}

/// The pieces of a move that are looked at one by one.
constexpr int kMostPiecesOverFloors = 200;

/// Whether a flat end of this radius goes into nothing along the move. An inclined wall counts as standing where another feature cuts
/// into it: each place is tested instead.
bool is_clear_beside_crossed_walls(const FinishedPart& raised, const Move& move, double radius,
                                   double slack) {
  const CutterProfile end = CutterProfile::cylinder(radius);
  if (move.is_vertical()) return is_clear_of_crossed_draft(raised, move, end, slack);
  const int count = std::clamp(static_cast<int>(std::ceil(move.path.length() / std::max(radius, kLeftStep))),
                               1, kMostPiecesOverFloors);
  for (int i = 0; i < count; ++i) {
    const double a = static_cast<double>(i) / count, b = (i + 1.0) / count;
    Move piece = move;
    piece.path = move.path.part(a, b);
    piece.z_from = std::lerp(move.z_from, move.z_to, a);
    piece.z_to = std::lerp(move.z_from, move.z_to, b);
    if (!is_clear_of_crossed_draft(raised, piece, end, slack)) return false;
  }
  return true;
}

/// Whether two features overlap and each also has a part outside the other: their walls then do not determine the
/// owner of the stock.
bool cross_each_other(const Feature& a, const Feature& b, const Tolerances& tol) {
  if (!box(a.target).overlaps(box(b.target))) return false;
  const double both = area(intersect(a.target, b.target, tol));
  return both > tol.uncut && area(a.target) - both > tol.uncut && area(b.target) - both > tol.uncut;
}

}  // namespace

StockToLeave::StockToLeave(const Part& part, const Tolerances& tol)
    : part_(part), tol_(tol), left_(part.features.size()) {
  std::vector<bool> known(part.features.size());
  for (const Workingstep& step : part.workplan) {
    const auto i = static_cast<std::size_t>(step.feature);
    const Left own = is_made_to_size(part, step)
                         ? Left{}
                         : Left{step.operation.allowance_side, step.operation.allowance_floor};
    left_[i] = known[i] ? Left{std::min(left_[i].side, own.side), std::min(left_[i].floor, own.floor)} : own;
    known[i] = true;
  }
  leave_out_crossing();
  std::vector<double> floors;
  for (const Left& left : left_) {
    most_side_ = std::max(most_side_, left.side);
    most_floor_ = std::max(most_floor_, left.floor);
    floors.push_back(std::max(0.0, left.floor));
  }
  if (std::max(most_side_, most_floor_) <= tol.uncut || !part.is_shape_stated) return;
  raised_ = std::make_unique<FinishedPart>(with_raised_floors(part, floors));
  for (const Feature& feature : part.features)
    lines_.emplace_back(feature.profile && feature.profile->side != ProfileSide::kOn
                            ? EdgeTree(std::vector<Edge>(feature.profile->line))
                            : EdgeTree());
  if (most_side_ > tol.uncut) find_walls();
}

/// Whether the feature leaves its allowance on the wall: a profile does so only beside its outline, and not on waste.
bool StockToLeave::owes(std::size_t feature, const Wall& wall) const {
  return lines_[feature].empty() ||
         lines_[feature].nearest(wall.edge.at(0.5), 2 * FinishedPart::kProbe).edge >= 0;
}

bool StockToLeave::is_chamfered(const Wall& wall) const {
  return std::any_of(part_.features.begin(), part_.features.end(), [&](const Feature& feature) {
    return feature.chamfer && EdgeTree(std::vector<Edge>(feature.chamfer->line))
                                      .nearest(wall.edge.at(0.5), 2 * FinishedPart::kProbe)
                                      .edge >= 0;
  });
}

void StockToLeave::leave_out_crossing() {
  const auto leaves = [&](std::size_t i) {
    return left_[i].side > tol_.uncut || left_[i].floor > tol_.uncut;
  };
  std::vector<bool> crosses(left_.size());
  for (std::size_t i = 0; i < left_.size(); ++i) {
    for (std::size_t k = i + 1; k < left_.size(); ++k) {
      if (!leaves(i) && !leaves(k)) continue;
      if (cross_each_other(part_.features[i], part_.features[k], tol_)) crosses[i] = crosses[k] = true;
    }
  }
  for (std::size_t i = 0; i < left_.size(); ++i)
    if (crosses[i]) left_[i] = Left{};
}

void StockToLeave::find_walls() {
  std::vector<Edge> edges;
  const auto add = [&](const Wall& wall) {
    const Vec2 beside = wall.edge.at(0.5) + left_of(wall.edge.tangent_at(0.5)) * FinishedPart::kProbe;
    double side = 0;
    std::vector<int> of;
    for (std::size_t i = 0; i < left_.size(); ++i) {
      if (left_[i].side <= tol_.uncut || !owes(i, wall) || !raised_->is_inside(static_cast<int>(i), beside))
        continue;
      side = std::max(side, left_[i].side);
      of.push_back(static_cast<int>(i));
    }
    if (side <= tol_.uncut) return;
    walls_.push_back({wall, side, is_chamfered(wall), std::move(of)});
    edges.push_back(wall.edge);
  };
  for (const Wall& wall : raised_->walls()) add(wall);
  for (const Wall& outline : raised_->outlines_beyond()) add(outline);
  tree_ = EdgeTree(std::move(edges));
}

/// mm from p to the nearest wall at z on which the feature leaves stock; `limit` if none is nearer.
double StockToLeave::least_apart(std::size_t feature, Vec2 p, double z, double limit) const {
  double least = limit;
  tree_.within(p, limit + raised_->greatest_draft_offset(), [&](int i) {
    const Wall& wall = walls_[static_cast<std::size_t>(i)].wall;
    if (!wall.stands_at(z) || !owes(feature, wall)) return;
    least = std::min(least, distance(wall.edge, p) - raised_->draft_offset(wall, z, p));
  });
  return least;
}

bool StockToLeave::is_cleared(Vec2 p, double z) const {
  for (std::size_t i = 0; i < left_.size(); ++i) {
    const Feature& feature = part_.features[i];
    if (feature.floor_z > z || !raised_->is_inside(static_cast<int>(i), p)) continue;
    if (left_[i].side <= tol_.uncut) return true;
    if (least_apart(i, p, z, left_[i].side) >= left_[i].side - tol_.uncut) return true;
  }
  return false;
}

int StockToLeave::feature_at(Vec2 p) const {
  int lowest = -1;
  for (std::size_t i = 0; i < left_.size(); ++i) {
    const bool lower =
        lowest < 0 || part_.features[i].floor_z < part_.features[static_cast<std::size_t>(lowest)].floor_z;
    if (lower && raised_->is_inside(static_cast<int>(i), p)) lowest = static_cast<int>(i);
  }
  return lowest;
}

/// With the tip at p and z: at each height common to wall and cutter, tests the place at which the cutter comes
/// nearest to the wall.
void StockToLeave::at_place(const KeptWall& kept, const Tool& tool, Vec2 p, double z,
                            std::optional<Gouge>& worst) const {
  const Wall& wall = kept.wall;
  const double low = std::max(z, wall.z_low), high = wall.z_high - tol_.uncut;
  if (low >= high) return;
  const Vec2 on_wall = nearest_point(wall.edge, p);
  const double apart = distance(on_wall, p);
  if (apart <= 0) return;
  const Vec2 toward = (on_wall - p) * (1 / apart);
  for (const double share : kShares) {
    const double height = low + (high - low) * share;
    const double to_wall = apart - raised_->draft_offset(wall, height, p);
    const double radius = radius_at(tool, height - z);
    const double depth = std::min(kept.side, kept.side - (to_wall - radius));
    if (depth <= tol_.uncut || (worst && depth <= worst->depth)) continue;
    const Vec2 place = p + toward * std::min(radius, to_wall - FinishedPart::kProbe);
    if (part_.stock && !part_.stock->plan.contains(place)) continue;
    if (!is_cleared(place, height)) worst = Gouge{depth, p, z, false, feature_at(place)};
  }
}

void StockToLeave::against(const KeptWall& kept, const CheckedMove& checked,
                           std::optional<Gouge>& worst) const {
  const Move& move = *checked.move;
  const Tool& tool = *checked.tool;
  // Of overlapping features, each leaves stock only on its own walls.
  if (checked.workingstep >= 0) {
    const int own = part_.workplan[static_cast<std::size_t>(checked.workingstep)].feature;
    if (std::find(kept.of.begin(), kept.of.end(), own) == kept.of.end()) return;
  }
  // A chamfer is cut through the stock left on the wall below.
  if (kept.is_chamfered && is_conical(tool)) return;
  const double reach = widest_radius(tool) + kept.side + kept.wall.draft_offset(lowest_of(move));
  if (lowest_of(move) >= kept.wall.z_high - tol_.uncut ||
      apart_of(move.path, kept.wall.edge) >= reach - tol_.uncut)
    return;
  const int steps = steps_along(move);
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Vec2 p = move.is_vertical() ? move.path.from : move.path.at(t);
    const double z = move.is_vertical() ? lowest_of(move) : move.z_from + (move.z_to - move.z_from) * t;
    at_place(kept, tool, p, z, worst);
  }
}

void StockToLeave::against_floors(const CheckedMove& checked, std::optional<Gouge>& worst) const {
  const Move& move = *checked.move;
  const Tool& tool = *checked.tool;
  std::optional<Gouge> found;
  const bool is_flat = !has_flanks(tool) && flat_end(tool) > 0;
  if (is_flat) found = gouge_of(*raised_, move, flat_end(tool), tol_.uncut, false);
  const int steps = is_flat ? 0 : steps_along(move);
  for (int i = 0; !is_flat && i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Vec2 p = move.is_vertical() ? move.path.from : move.path.at(t);
    const double z = move.is_vertical() ? lowest_of(move) : move.z_from + (move.z_to - move.z_from) * t;
    const double depth = raised_->height(p) - z;
    if (!found || depth > found->depth) found = Gouge{depth, p, z, true, -1};
  }
  if (!found || found->depth <= tol_.uncut || (worst && found->depth <= worst->depth)) return;
  const double tested = is_flat ? flat_end(tool) : FinishedPart::kProbe;
  if (raised_->greatest_draft_offset() > 0 &&
      is_clear_beside_crossed_walls(*raised_, move, tested, tol_.uncut))
    return;
  found->feature = feature_at(found->point);
  found->floor = true;
  worst = found;
}

std::optional<Gouge> StockToLeave::cut_by(const CheckedMove& checked) const {
  if (!checked.feeds() || checked.radius() <= 0 || checked.is_carried()) return std::nullopt;
  const Move& move = *checked.move;
  std::optional<Gouge> worst;
  if (!walls_.empty()) {
    const double half = move.is_vertical() ? 0 : move.path.length() / 2;
    const Vec2 middle = move.is_vertical() ? move.path.from : move.path.at(0.5);
    const double reach = half + widest_radius(*checked.tool) + most_side_ + raised_->greatest_draft_offset();
    tree_.within(middle, reach, [&](int i) { against(walls_[static_cast<std::size_t>(i)], checked, worst); });
  }
  if (most_floor_ > tol_.uncut && checked.tool->kind != ToolKind::kTSlot) against_floors(checked, worst);
  return worst;
}

void check_stock_to_leave(const StockToLeave& left, std::vector<CheckedMove>& moves, std::size_t first,
                          std::size_t last) {
  for (std::size_t i = first; left.is_any() && i < last; ++i) {
    if (const std::optional<Gouge> cut = left.cut_by(moves[i])) moves[i].into_stock_to_leave = *cut;
  }
}

}  // namespace clearcut::verify
