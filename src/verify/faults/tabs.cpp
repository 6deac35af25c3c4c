#include "verify/faults/tabs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "base/elementary.h"
#include "base/text.h"
#include "base/units.h"
#include "verify/faults/faults.h"
#include "verify/part/edge_tree.h"

namespace clearcut::verify {
namespace {

/// A stretch of a move, as parameters of its path.
struct Span {
  double from = 0;
  double to = 0;
};

/// Spans of a path on which a disc of radius r contains p; at most two.
std::vector<Span> held_by_disc(const Edge& path, Vec2 p, double r) {
  std::vector<Span> spans;
  const auto add = [&](double from, double to) {
    from = std::max(from, 0.0);
    to = std::min(to, 1.0);
    if (from < to) spans.push_back({from, to});
  };
  if (!path.is_arc()) {
    const Vec2 way = path.to - path.from;
    const double all = norm(way), middle = dot(p - path.from, way) / all,
                 aside = cross(way, p - path.from) / all;
    const double half = r * r - aside * aside;
    if (half > 0) add((middle - std::sqrt(half)) / all, (middle + std::sqrt(half)) / all);
    return spans;
  }
  const double own = path.radius(), out = distance(path.center, p);
  const double cosine = (own * own + out * out - r * r) / (2 * own * out);
  if (cosine >= 1) return spans;
  const double half = cosine <= -1 ? kPi : base::acos(cosine), sweep = path.sweep();
  const double middle = angle_of(p - path.center) - angle_of(path.from - path.center);
  for (const double turn : {-2 * kPi, 0.0, 2 * kPi}) {
    const double a = (middle + turn - half) / sweep, b = (middle + turn + half) / sweep;
    add(std::min(a, b), std::max(a, b));
  }
  return spans;
}

}  // namespace

std::optional<double> lowest_tip(const CheckedMove& checked, Vec2 p) {
  const Move& move = *checked.move;
  std::optional<double> lowest;
  if (move.is_vertical()) {
    if (distance(move.path.from, p) < checked.radius()) lowest = checked.low_z();
    return lowest;
  }
  if (!move.path.box().grown(checked.radius()).contains(p)) return lowest;
  for (const Span& span : held_by_disc(move.path, p, checked.radius())) {
    const double t = move.z_to < move.z_from ? span.to : span.from;
    const double z = move.z_from + (move.z_to - move.z_from) * t;
    if (!lowest || z < *lowest) lowest = z;
  }
  return lowest;
}

namespace {

/// mm, square to the side of a tab. Sampled places are so close that an error between them is greater by at most
/// this.
constexpr double kBetweenPlaces = 0.0025;
/// mm. Distance beside a tab up to which places are sampled.
constexpr double kBesideBody = 0.5;
/// Number of lines of places along the kerf; one of them is its middle.
constexpr int kLines = 9;

/// The lowest tip of a cutter while covering a place.
struct Lowest {
  double z = std::numeric_limits<double>::infinity();
  int line = 0;
};

void lower(const CheckedMove& checked, Vec2 at, Lowest& lowest) {
  if (checked.low_z() >= lowest.z) return;
  const auto tip = lowest_tip(checked, at);
  if (tip && *tip < lowest.z) lowest = {*tip, checked.move->line};
}

Lowest lowest_over(Vec2 at, const std::vector<const CheckedMove*>& moves) {
  Lowest lowest;
  for (const CheckedMove* checked : moves) lower(*checked, at, lowest);
  return lowest;
}

/// The moves whose cutter comes near a tab.
std::vector<const CheckedMove*> moves_near(const Tab& tab, const CheckedProgram& program) {
  Box around = box(tab.body).grown(kBesideBody);
  around.add(tab.center);
  std::vector<const CheckedMove*> near;
  for (const CheckedMove& checked : program.moves) {
    if (checked.radius() <= 0) continue;
    if (checked.move->path.box().grown(checked.radius()).overlaps(around)) near.push_back(&checked);
  }
  return near;
}

std::string place_of(Vec2 at, int line) {
  std::string text = " at x " + trimmed(at.x, 3) + " y " + trimmed(at.y, 3);
  if (line > 0) text += ", line " + std::to_string(line);
  return text + ".";
}

/// mm from the tab's edge on the outline to the middle of the kerf.
double to_middle(const Tab& tab) {
  return distance(tab.foot, tab.center);
}

/// mm along the foot by which a tab stands longer in the middle of the kerf than at its foot, `sides` mm of stock being left on the wall and
/// on the tab's sides. In the middle of a curved kerf the cutter touches a shorter stretch of a tab than beside the middle.
double excess_of(const Tab& tab, double sides) {
  if (!tab.foot.is_arc()) return sides;
  const double r = to_middle(tab), outer = distance(tab.foot.center, tab.center),
               around = outer + (outer > tab.foot.radius() ? sides : -sides);
  return std::max(0.0, tab.foot.radius() * (base::asin(std::min(1.0, (r + sides) / around)) -
                                            2 * base::asin(std::min(1.0, r / (2 * around)))));
}

/// mm of stock to leave where a profile is cut: on its walls and the sides of its tabs, and on its floor.
struct StockLeft {
  double sides = 0;
  double floor = 0;
};

/// The least stock left of all steps on the feature.
StockLeft stock_left(const Part& part, const Feature& feature) {
  StockLeft left{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const Workingstep& step : part.workplan) {
    if (&feature_of(part, step) != &feature) continue;
    left.sides = std::min(left.sides, step.operation.allowance_side);
    left.floor = std::min(left.floor, step.operation.allowance_floor);
  }
  return std::isinf(left.sides) ? StockLeft{} : left;
}

/// The middle of the kerf `out` mm along the foot beyond one of its ends, `sides` mm of stock being left on the wall.
Vec2 beyond_foot(const Tab& tab, bool ahead, double out, double sides) {
  const Edge& foot = tab.foot;
  const Vec2 end = ahead ? foot.to : foot.from, along = foot.tangent_at(ahead ? 1 : 0);
  const double way = ahead ? out : -out;
  if (!foot.is_arc())
    return end + along * way + left_of(along) * ((to_middle(tab) + sides) * (tab.aside < 0 ? -1 : 1));
  const double outer = distance(foot.center, tab.center);
  const double angle = way / foot.radius(), around = outer + (outer > foot.radius() ? sides : -sides);
  const Vec2 outwards = (end - foot.center) / foot.radius();
  return foot.center + (outwards * base::cos(angle) + along * base::sin(angle)) * around;
}

/// Deviation of the material on one side of a triangular tab from this side.
struct SideError {
  double off = 0;  ///< mm, square to the side; below 0 if there is too little material
  Vec2 at;
  Lowest lowest;
};

/// Whether the sides of a triangular tab are as they should be: nowhere lower, and in the middle of the kerf nowhere
/// higher.
class SideCheck {
 public:
  SideCheck(const Tab& tab, const std::vector<const CheckedMove*>& moves, StockLeft left)
      : tab_(tab),
        moves_(moves),
        left_(left),
        half_(tab.foot.length() / 2),
        steepness_((tab.top_z - tab.bottom_z) / half_) {}

  SideError worst() const {
    const double step = kBetweenPlaces * base::hypot(1.0, steepness_) / steepness_;
    const int count = std::max(2, static_cast<int>(std::ceil(2 * half_ / step)));
    SideError worst;
    for (int line = 0; line < kLines; ++line) {
      for (int i = 0; i <= count; ++i) {
        const SideError here = error_at(static_cast<double>(i) / count, line);
        if (std::abs(here.off) > std::abs(worst.off)) worst = here;
      }
    }
    return worst;
  }

 private:
  /// `along`: share of the foot, from 0 to 1.
  SideError error_at(double along, int line) const {
    constexpr int kMiddle = kLines / 2;
    const double side = tab_.aside < 0 ? -1 : 1;
    const double aside = side * (to_middle(tab_) + left_.sides) * line / kMiddle;
    const Vec2 at = tab_.foot.at(along) + left_of(tab_.foot.tangent_at(along)) * aside;
    const Lowest lowest = lowest_over(at, moves_);
    const double from_ridge = std::abs(2 * along - 1) * half_;
    const double least = tab_.top_z - steepness_ * from_ridge;
    const double side_z = tab_.top_z - steepness_ * std::max(0.0, from_ridge - excess_of(tab_, 0));
    const double most = std::max(side_z, tab_.bottom_z + left_.floor);
    SideError error{0, at, lowest};
    if (lowest.z < least) error.off = lowest.z - least;
    if (line == kMiddle && lowest.z > most) error.off = std::min(lowest.z, tab_.top_z + 1) - most;
    error.off /= base::hypot(1.0, steepness_);
    return error;
  }

  const Tab& tab_;
  const std::vector<const CheckedMove*>& moves_;
  StockLeft left_;
  double half_;       ///< mm
  double steepness_;  ///< mm up for each mm along the outline
};

std::optional<Fault> fault_of_sides(const Feature& feature, const Tab& tab,
                                    const std::vector<const CheckedMove*>& moves, StockLeft left,
                                    const Tolerances& tol) {
  if (tab.shape != TabShape::kTriangular) return std::nullopt;
  const SideError worst = SideCheck(tab, moves, left).worst();
  if (std::abs(worst.off) <= tol.uncut) return std::nullopt;
  const std::string what = "a side of the triangular tab stands " + trimmed(std::abs(worst.off), 3) +
                           " mm too " + (worst.off < 0 ? "low" : "high");
  return Fault{FaultKind::kTabHeight,
               feature.name,
               {worst.at, worst.lowest.z, worst.lowest.line},
               std::abs(worst.off),
               feature.name + ": " + what + place_of(worst.at, worst.lowest.line)};
}

/// Fault of a square tab that is longer along the middle of the kerf than required.
std::optional<Fault> fault_of_width(const Feature& feature, const Tab& tab,
                                    const std::vector<const CheckedMove*>& moves, StockLeft left,
                                    const Tolerances& tol) {
  if (tab.shape != TabShape::kSquare) return std::nullopt;
  const double may_stand = excess_of(tab, left.sides) + tol.uncut;
  const auto is_cut = [&](Vec2 at) {
    return lowest_over(at, moves).z <= tab.bottom_z + left.floor + tol.uncut;
  };
  for (const bool ahead : {false, true}) {
    if (is_cut(beyond_foot(tab, ahead, may_stand, left.sides))) continue;
    double out = may_stand;
    while (out < may_stand + kBesideBody && !is_cut(beyond_foot(tab, ahead, out + tol.uncut, left.sides)))
      out += tol.uncut;
    const Vec2 at = beyond_foot(tab, ahead, out, left.sides);
    return Fault{
        FaultKind::kUncut,
        feature.name,
        {at, tab.bottom_z, 0},
        out,
        feature.name + ": the tab stands " + trimmed(out, 2) + " mm too wide on one side" + place_of(at, 0)};
  }
  return std::nullopt;
}

}  // namespace

std::vector<Fault> faults_of_tabs(const Part& part, const CheckedProgram& program, const Tolerances& tol) {
  std::vector<Fault> faults;
  for (const Feature& feature : part.features) {
    if (!feature.profile) continue;
    const StockLeft left = stock_left(part, feature);
    for (const Tab& tab : feature.profile->tabs) {
      const std::vector<const CheckedMove*> near = moves_near(tab, program);
      const Lowest lowest = lowest_over(tab.center, near);
      if (std::abs(lowest.z - tab.top_z) <= tol.uncut) {
        if (const auto fault = fault_of_sides(feature, tab, near, left, tol)) faults.push_back(*fault);
        if (const auto fault = fault_of_width(feature, tab, near, left, tol)) faults.push_back(*fault);
        continue;
      }
      const double under = tab.bottom_z + feature.profile->beyond;
      const double asked = tab.top_z - under, height = std::min(lowest.z, feature.top_z + asked) - under;
      const bool missing = height <= tol.uncut;
      const std::string what = missing ? "the tab is cut away"
                               : std::isinf(lowest.z)
                                   ? "nothing is cut over the tab"
                                   : "the tab stands " + trimmed(height, 3) + " mm high where " +
                                         trimmed(asked, 3) + " mm is asked";
      faults.push_back({missing ? FaultKind::kMissingTab : FaultKind::kTabHeight,
                        feature.name,
                        {tab.center, std::isinf(lowest.z) ? tab.top_z : lowest.z, lowest.line},
                        std::abs(asked - height),
                        feature.name + ": " + what + place_of(tab.center, lowest.line)});
    }
  }
  return faults;
}

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
