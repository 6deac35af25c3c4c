#include "verify/coverage/feature_work.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <span>
#include <stop_token>

#include "base/elementary.h"
#include "base/parallel.h"
#include "base/progress.h"
#include "base/tolerances.h"
#include "geometry/spatial/box_tree.h"
#include "model/cutter_profile.h"
#include "verify/engagement/tool_takes.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {
namespace {

using Tasks = std::vector<std::function<void()>>;

/// Radians. Arcs are divided into swaths of at most this sweep, less than half a turn.
constexpr double kSwathSweep = 2.0;

/// Runs independent tasks on up to `threads` threads; no task may write data used by another one. Rethrows the first
/// exception in the order of tasks. Once `cancel` requests a stop no further task is begun, and Cancelled is thrown.
void run_all(const Tasks& tasks, int threads, const std::stop_token& cancel) {
  std::vector<std::exception_ptr> thrown(tasks.size());
  const auto work = [&](std::size_t i) {
    try {
      if (!cancel.stop_requested()) tasks[i]();
    } catch (...) {
      thrown[i] = std::current_exception();
    }
  };
  on_threads(threads, [&] { parallel_for(std::size_t{0}, tasks.size(), work); });
  for (const std::exception_ptr& exception : thrown) {
    if (exception) std::rethrow_exception(exception);
  }
  throw_if_cancelled(cancel);
}

/// mm; radius within which all material is removed `above` mm over the tip; for T-slot cutters only up to their upper
/// side.
double cleared_radius(const CheckedMove& checked, double above) {
  if (checked.tool->kind == ToolKind::kTSlot) return radius_at(*checked.tool, above);
  return removal_of(checked).profile.radius_at(std::max(0.0, above));
}

/// Adds the parts of a feed move whose tip is at or below z, with the cutter's radius at `level`, made smaller by
/// `narrower` mm.
void append_swaths(const CheckedMove& checked, double z, double level, double narrower,
                   std::vector<Swath>& out) {
  const Move& move = *checked.move;
  const double tip = move.is_vertical() ? checked.low_z() : std::max(move.z_from, move.z_to);
  const double radius = cleared_radius(checked, level - tip) - narrower;
  if (radius <= 0) return;
  if (move.is_vertical()) return out.push_back({move.path, radius});
  double t0 = 0, t1 = 1;
  if (move.z_from > z) t0 = (z - move.z_from) / (move.z_to - move.z_from);
  if (move.z_to > z) t1 = (z - move.z_from) / (move.z_to - move.z_from);
  const double sweep = std::abs(move.path.sweep()) * (t1 - t0);
  const int pieces = std::max(1, static_cast<int>(std::ceil(sweep / kSwathSweep)));
  for (int i = 0; i < pieces; ++i) {
    const double a = t0 + (t1 - t0) * i / pieces, b = t0 + (t1 - t0) * (i + 1) / pieces;
    Edge piece = a == 0 && b == 1 ? move.path : move.path.part(a, b);
    if (piece.from == piece.to) piece.turn = Turn::kStraight;
    out.push_back({piece, radius});
  }
}

/// The box around a feature's target, and the height of its material's top.
struct Around {
  explicit Around(const Feature& feature) : box(clearcut::box(feature.target)), top_z(feature.top_z) {}
  Box box;
  double top_z;
};

/// Whether the cutter has cleared all above its tip up to the feature's top: over the disc of a T-slot cutter there
/// may be material.
bool reaches_up(const CheckedMove& checked, double top_z, const Tolerances& tol) {
  if (checked.tool->kind != ToolKind::kTSlot) return true;
  return checked.low_z() + checked.tool->flute_length.value_or(HUGE_VAL) >= top_z - tol.uncut;
}

/// Whether a feed move is near the target with its tip at or below z.
bool counts_at(const CheckedMove& checked, double z, const Around& target, const Tolerances& tol) {
  if (!checked.feeds() || !checked.tool || checked.low_z() > z || !checked.counts_below(target.top_z))
    return false;
  if (!reaches_up(checked, target.top_z, tol)) return false;
  const Move& move = *checked.move;
  const Box path = move.path.box();
  return path.grown(widest_radius(*checked.tool) + 2 * tol.uncut).overlaps(target.box);
}

/// The moves of a program, found by place.
class MovesByPlace {
 public:
  MovesByPlace(const std::vector<CheckedMove>& moves, const Tolerances& tol) : moves_(moves) {
    tree_.build(static_cast<std::uint32_t>(moves.size()), [&](std::uint32_t i) {
      const CheckedMove& checked = moves[i];
      return checked.feeds() && checked.tool
                 ? checked.move->path.box().grown(widest_radius(*checked.tool) + 2 * tol.uncut)
                 : Box{};
    });
  }

  const std::vector<CheckedMove>& all() const { return moves_; }

  /// The numbers of all moves possibly relevant near the target, and of some irrelevant ones, ascending.
  std::vector<std::size_t> near(const Around& target) const {
    std::vector<std::size_t> numbers;
    tree_.descend([&](const Box& box) { return box.overlaps(target.box); },
                  [&](std::uint32_t i) { numbers.push_back(i); });
    return numbers;
  }

 private:
  const std::vector<CheckedMove>& moves_;
  BoxTree tree_;
};

/// The greatest height at most tol.uncut above the level, with the rounding of their difference: material left below
/// a tip at this height is no thicker than permitted.
double highest_counted(double level, const Tolerances& tol) {
  double z = level + tol.uncut;
  while (z - level > tol.uncut) z = std::nextafter(z, level);
  return z;
}

/// Areas swept by feed moves at a level for any deviation up to `off` mm from their paths. Tips up to tol.uncut - off
/// above the level count. Only moves within 2 tol.uncut of the target count, because farther ones leave thick
/// residuals.
std::vector<Swath> swaths_at(double level, double off, const Around& target, const MovesByPlace& moves,
                             const std::vector<std::size_t>& near, const Tolerances& tol) {
  const double z = highest_counted(level, tol) - off;
  std::vector<Swath> swaths;
  for (const std::size_t i : near) {
    const CheckedMove& checked = moves.all()[i];
    if (counts_at(checked, z, target, tol)) append_swaths(checked, z, level, off, swaths);
  }
  return swaths;
}

/// mm; greatest deviation of the control from the paths of these moves: it rounds corners, or runs another arc.
double liberty_at(double z, const Around& target, const MovesByPlace& by_place,
                  const std::vector<std::size_t>& near, const Tolerances& tol) {
  const std::vector<CheckedMove>& moves = by_place.all();
  double most = 0;
  for (const std::size_t i : near) {
    if (!counts_at(moves[i], z, target, tol)) continue;
    most = std::max(most, moves[i].doubt);
    if (i > 0 && moves[i].path_tolerance > most)
      most = std::max(most, corner_tolerance(std::span(&moves[i - 1], 2)));
  }
  return most;
}

/// mm; height over the level of the highest level move counted as cutting it, `off` mm off its path.
double height_above(double level, double off, const Around& target, const MovesByPlace& moves,
                    const std::vector<std::size_t>& near, const Tolerances& tol) {
  double most = 0;
  for (const std::size_t i : near) {
    const CheckedMove& checked = moves.all()[i];
    const bool counts =
        checked.is_flat() && counts_at(checked, highest_counted(level, tol) - off, target, tol);
    if (counts) most = std::max(most, checked.low_z() + off - level);
  }
  return most;
}

/// The required clearing of one step. No other step goes as deep with a cutter no larger and as little left on the
/// walls and in corners.
struct FinestWork {
  double radius = 0;
  double flat = 0;  ///< radius of its flat end
  double allowance_side = 0;
  double above = 0;  ///< mm over the floor down to which the step clears: holes end in the cone of a drill
  CutterProfile profile;  ///< an outer bound
  /// The tool has only vertical moves, and its hole is narrower than the drawn one, or the drawn one is shallower than its point.
  bool is_other_hole = false;
};

/// Whether `a` reaches everything within reach of `b`: it goes as deep, comes as near to walls and leaves no more
/// between walls and floors.
bool covers(const FinestWork& a, const FinestWork& b) {
  return a.radius <= b.radius && a.allowance_side <= b.allowance_side && a.above <= b.above &&
         a.radius - a.flat <= b.radius - b.flat + kRoundingMm;
}

/// For a drilled hole, the width counts from the top of the drill's point, to within the permitted residual on
/// floors; pockets are flat down to their floor.
FinestWork work_of(const Feature& feature, const Tool& tool, double allowance_side, const Tolerances& tol) {
  const bool is_hole = feature.kind == FeatureKind::kRoundHole || feature.hole;
  const CutterProfile profile = outer_profile(tool);
  const bool is_wider = makes_holes(tool) && feature.target.size() == 1 &&
                        2 * std::sqrt(area(feature.target) / kPi) > tool.diameter + tol.uncut + kSamePlaceMm;
  const bool is_shallower = is_hole && tool.kind == ToolKind::kDrill &&
                            profile.radius_at(feature.top_z - feature.floor_z) < tool.radius() - tol.uncut;
  const bool is_other_hole = is_wider || is_shallower;
  if (is_hole && tool.kind == ToolKind::kDrill)
    return {tool.radius(), tool.radius(), allowance_side, profile.full_height() + tol.uncut,
            profile,       is_other_hole};
  return {tool.radius(), std::min(tool.radius(), profile.flat), allowance_side, 0, profile, is_other_hole};
}

struct CheckedHeight {
  double z = 0;
  double narrower =
      0;  ///< mm; how much less of the radius is asked for at this height than at the feature's top
};

/// Where a step has to clear its feature of this floor. A hole no deeper than the point of its drill is checked at its mouth, below the moves that
/// count at the height of the mouth: those of a counterbore would clear what the drill leaves.
CheckedHeight checked_height(const FinestWork& finest, double floor, double top, const Tolerances& tol) {
  const double z = floor + finest.above, highest = std::max(floor, top - 2 * tol.uncut);
  if (finest.above <= 0 || z <= highest) return {z, 0};
  // A drill that is at its full width at the mouth but for what may be left is not asked for that either.
  const double full = finest.is_other_hole ? finest.profile.radius_at(top - floor) : finest.radius;
  return {highest, full - finest.profile.radius_at(highest - floor)};
}

/// The finest of the steps with a floor, including its stock to leave, at z or below; usually only the last step.
std::vector<FinestWork> finest_works(const Part& part, const FeatureWork& work, double z,
                                     const Tolerances& tol) {
  std::vector<FinestWork> finest;
  for (const Workingstep& step : part.workplan) {
    const Operation& operation = step.operation;
    const double lowest = part.features[work.feature].floor_z + operation.allowance_floor;
    const bool known = operation.tool >= 0 && operation.tool < static_cast<int>(part.tools.size());
    if (step.feature != work.feature || lowest > z + tol.gouge) continue;
    const Tool tool = known ? part.tools[operation.tool] : Tool{};
    const FinestWork own = work_of(part.features[work.feature], tool, operation.allowance_side, tol);
    if (std::any_of(finest.begin(), finest.end(),
                    [&](const FinestWork& other) { return covers(other, own); }))
      continue;
    std::erase_if(finest, [&](const FinestWork& other) { return covers(own, other); });
    finest.push_back(own);
  }
  return finest;
}

/// Joins the coverage for two steps: the worse of the residuals; only places reached by neither are out of reach.
Coverage both(const Coverage& a, const Coverage& b) {
  Coverage worse = a.thickness_mm >= b.thickness_mm ? a : b;
  worse.reachable = a.reachable || b.reachable;
  worse.uncut_mm2 = std::max(a.uncut_mm2, b.uncut_mm2);
  worse.unreachable_mm2 = std::min(a.unreachable_mm2, b.unreachable_mm2);
  return worse;
}

const Tool* known_tool(const Part& part, const Operation& operation) {
  const bool known = operation.tool >= 0 && operation.tool < static_cast<int>(part.tools.size());
  return known ? &part.tools[static_cast<std::size_t>(operation.tool)] : nullptr;
}

/// Distance, as a share of the scallop, of the heights at which walls are tested, and the greatest number of heights.
constexpr double kHeightShare = 0.125;
constexpr int kMostHeights = 200;

/// mm; radius of a cutter's rounded end, 0 for flat ends.
double rounding_of(const Tool* tool) {
  if (!tool || has_flanks(*tool)) return 0;
  return tool->kind == ToolKind::kBallEndMill ? tool->radius() : tool->corner_radius;
}

/// The cutter with the roundest end of those that come to the walls.
const Tool* roundest_on_walls(const FeatureWork& work) {
  const Tool* roundest = work.on_walls;
  for (const LevelCoverage& layer : work.layers)
    if (rounding_of(layer.tool) > rounding_of(roundest)) roundest = layer.tool;
  return roundest;
}

/// mm over its tip at which a cutter comes nearest to a wall with draft: greater than 0 only for rounded ends.
double nearest_height(const Tool* tool, double draft) {
  return rounding_of(tool) * (1 - base::sin(draft));
}

/// mm over the floor, below which the walls with draft of the feature are not asked for: the rounding of the cutter leaves material in their
/// corner with the floor, out of reach of any cutter of its kind, and a fillet that the part asks for is to stay.
double corner_height(const Feature& feature, const Tool* tool) {
  const double draft = feature.wall_slope.radians();
  return std::max(nearest_height(tool, draft), feature.floor_fillet * (1 - base::sin(draft)));
}

class WorkCheck {
 public:
  WorkCheck(const Part& part, const FinishedParts& finished, const CheckedProgram& program,
            const VerifyOptions& options)
      : part_(part),
        finished_(finished),
        program_(program),
        options_(options),
        moves_(program.moves, options.tol) {}

  /// `scallop_left`: mm, square to walls with draft; permitted material on them. If greater than 0, the level is
  /// above the cutters' ends, at a height at which they clear their whole radius. `off`: mm; deviation of each move
  /// from its path.
  void check_level(const FeatureWork& work, LevelCoverage& level, double scallop_left = 0,
                   double off = 0) const {
    if (work.smallest_radius <= 0) return;
    const Tolerances& tol = options_.tol;
    const Feature& feature = part_.features[work.feature];
    const Regions in_stock =
        within_stock(feature.target, part_.stock ? std::optional(part_.stock->plan) : std::nullopt);
    const double kept = scallop_left / base::cos(feature.wall_slope.radians());
    const Around target(feature);
    const std::vector<std::size_t> near = moves_.near(target);
    bool first = true;
    for (const FinestWork& finest : finest_works(part_, work, level.z, tol)) {
      const auto [z, narrower] = checked_height(finest, level.z, feature.top_z, tol);
      CoverageQuestion question;
      question.part = &finished_.for_feature(feature);
      question.target = &in_stock;
      question.z = z + tol.gouge;
      question.swaths = swaths_at(z, off, target, moves_, near, tol);
      question.path_tolerance = liberty_at(highest_counted(z, tol), target, moves_, near, tol);
      question.above = height_above(z, off, target, moves_, near, tol);
      question.radius = finest.radius - narrower;
      question.flat = scallop_left > 0 ? question.radius : std::min(finest.flat, question.radius);
      question.corner = question.radius - question.flat;
      question.allowance = finest.allowance_side + kept + narrower;
      level.any_cut = level.any_cut || !question.swaths.empty();
      const bool none_is_made = finest.is_other_hole && question.swaths.empty();
      Coverage one = none_is_made ? nothing_in_reach(in_stock) : coverage_of(question, tol);
      const bool is_rounded = question.flat < question.radius - kRoundingMm;
      if (is_rounded && !none_is_made) add_left_above(feature, finest, z, off, {target, near}, question, one);
      level.coverage = first ? one : both(level.coverage, one);
      first = false;
    }
  }

  void check_floor(FeatureWork& work) const {
    check_level(work, work.floor);
    if (!work.floor.any_cut) work.deepest = deepest_in(work);
  }

  void add_layers(FeatureWork& work) const {
    for (std::size_t i = 0; i < part_.workplan.size(); ++i) {
      const Workingstep& step = part_.workplan[i];
      // Steps leaving stock on walls for a later step make no scallops.
      if (step.feature != work.feature || step.operation.allowance_side > work.allowance_side) continue;
      const Tool* tool = known_tool(part_, step.operation);
      for (const double z : program_.layers[i]) {
        if (z > highest_counted(work.floor.z, options_.tol)) work.layers.push_back({z, false, {}, tool});
      }
    }
    const auto higher = [](const LevelCoverage& a, const LevelCoverage& b) { return a.z > b.z; };
    std::sort(work.layers.begin(), work.layers.end(), higher);
  }

  /// Between layers that leave too much on walls with draft, sloping moves may have cut: tests at many heights
  /// whether only the permitted material remains.
  void check_between_layers(FeatureWork& work) const {
    const Feature& feature = part_.features[static_cast<std::size_t>(work.feature)];
    const auto scallop = scallop_of(feature, work, options_.tol);
    const bool leaves_more = scallop && scallop->height_mm > *scallop->asked_mm + options_.tol.uncut;
    if (!leaves_more || !work.on_walls) return;
    const bool is_rounded = rounding_of(roundest_on_walls(work)) > 0,
               is_flat = flat_end(*work.on_walls) >= work.on_walls->radius();
    // Rounded ends may also run nearer to the wall than a flat end could.
    if (!is_rounded && (!is_flat || !any_slopes(feature))) return;
    const double draft = feature.wall_slope.radians(),
                 apart = kHeightShare * *scallop->asked_mm / base::sin(draft);
    const double above_corner = work.floor.z + corner_height(feature, work.on_walls);
    const double depth = feature.top_z - work.floor.z;
    const int heights = static_cast<int>(std::clamp(std::ceil(depth / apart), 1.0, 1.0 * kMostHeights));
    // From the top; the top itself is left out, because no material is above it.
    for (int i = heights - 1; i > 0; --i) {
      LevelCoverage level;
      level.z = work.floor.z + depth * i / heights;
      if (level.z < above_corner) break;
      check_level(work, level, *scallop->asked_mm + options_.tol.uncut);
      if (level.coverage.reachable &&
          (!level.any_cut || level.coverage.thickness_mm > widest_left(options_.tol)))
        return;
    }
    work.is_cut_between_layers = true;
  }

  /// The surroundings of a feature: its target, and the numbers of the moves near it.
  struct Nearby {
    const Around& target;
    const std::vector<std::size_t>& near;
  };

  /// Adds to `floor` the material left above the end of a cutter that is no flat end mill, whose tip has to reach `z`: beside walls, and
  /// for cutters without a flat everywhere, cusps or a cone stay on the floor, out of its reach, but at the height of its full width, or at
  /// the feature's top if this is lower, it clears as much as a flat end of its width there. `question` is that of the floor.
  void add_left_above(const Feature& feature, const FinestWork& finest, double z, double off,
                      const Nearby& nearby, CoverageQuestion question, Coverage& floor) const {
    const Tolerances& tol = options_.tol;
    const double level = std::min(z + finest.profile.full_height(), feature.top_z);
    question.flat = std::min(finest.radius, finest.profile.radius_at(std::max(0.0, level - z)));
    if (question.flat <= tol.uncut) return;
    question.swaths = swaths_at(level, off, nearby.target, moves_, nearby.near, tol);
    question.path_tolerance =
        liberty_at(highest_counted(level, tol), nearby.target, moves_, nearby.near, tol);
    const Coverage above = coverage_of(question, tol);
    floor.uncut_mm2 = std::max(floor.uncut_mm2, above.uncut_mm2);
    if (above.thickness_mm < floor.thickness_mm) return;
    floor.thickness_mm = above.thickness_mm;
    floor.worst = above.worst;
    floor.path_tolerance_mm = above.path_tolerance_mm;
  }

  /// End of the lowest feed move below the feature's top that ends in the feature.
  std::optional<Place> deepest_in(const FeatureWork& work) const {
    const Feature& feature = part_.features[static_cast<std::size_t>(work.feature)];
    std::optional<Place> deepest;
    for (const std::size_t i : moves_.near(Around(feature))) {
      const CheckedMove& checked = moves_.all()[i];
      const Move& move = *checked.move;
      if (checked.tool && !reaches_up(checked, feature.top_z, options_.tol)) continue;
      if (checked.earlier || move.z_to >= std::min(feature.top_z, deepest ? deepest->z : feature.top_z))
        continue;
      if (contains(feature.target, move.path.to)) deepest = Place{move.path.to, move.z_to, move.line};
    }
    return deepest;
  }

  /// Whether a feed move near the feature has a changing height, below the feature's top.
  bool any_slopes(const Feature& feature) const {
    const std::vector<std::size_t> near = moves_.near(Around(feature));
    return std::any_of(near.begin(), near.end(), [&](std::size_t i) {
      const CheckedMove& checked = moves_.all()[i];
      return !checked.move->is_vertical() && !checked.is_flat() && checked.low_z() < feature.top_z;
    });
  }

  bool leans(const FeatureWork& work) const { return part_.features[work.feature].wall_slope.radians() > 0; }

 private:
  const Part& part_;
  const FinishedParts& finished_;
  const CheckedProgram& program_;
  const VerifyOptions& options_;
  const MovesByPlace moves_;
};

/// The end of a cutter moving along the outline of an inclined wall at its height.
struct LayerOnWall {
  double z = 0;
  const Tool* tool = nullptr;
};

/// mm, square to the wall; material left by the cutter `over` mm above its tip: its radius there, compared with the
/// wall inclined away.
double left_over_tip(const Tool* tool, double over, double draft) {
  const double narrower = tool ? tool->radius() - radius_at(*tool, over) : 0;
  return over * base::sin(draft) + narrower * base::cos(draft);
}

/// Number of places in a step tested for rounded ends.
constexpr int kPlacesInStep = 16;

/// mm; greatest material left between two heights over the first of these layers, the highest; lower layers cut
/// there, too.
double most_left(std::span<const LayerOnWall> layers, double from, double to, double draft) {
  double most = 0;
  for (int i = 0; i <= kPlacesInStep; ++i) {
    const double over = from + (to - from) * i / kPlacesInStep;
    double least = HUGE_VAL;
    for (const LayerOnWall& layer : layers) {
      const double height = over + layers.front().z - layer.z;
      least = std::min(least, left_over_tip(layer.tool, height, draft));
      // Above its rounding a cutter leaves the more the higher, and lower ones leave more.
      if (height >= rounding_of(layer.tool)) break;
    }
    most = std::max(most, least);
  }
  return most;
}

/// Whether a cutter reaches more than another: a narrower one, or one as wide with a wider flat.
bool reaches_more(const Tool& tool, const Tool& other) {
  return tool.radius() < other.radius() ||
         (tool.radius() == other.radius() && flat_end(tool) > flat_end(other));
}

/// After a step with this tool, which may come nearer to the walls than those before.
void refine_on_walls(FeatureWork& work, const Operation& operation, const Tool& tool) {
  const bool is_nearer = operation.allowance_side < work.allowance_side;
  const bool is_as_near = operation.allowance_side == work.allowance_side;
  if (!work.on_walls || is_nearer || (is_as_near && reaches_more(tool, *work.on_walls)))
    work.on_walls = &tool;
}

void refine(FeatureWork& work, const Operation& operation, const Tool& tool) {
  refine_on_walls(work, operation, tool);
  const double radius = tool.radius(), flat = flat_end(tool);
  if (radius < work.smallest_radius || (radius == work.smallest_radius && flat > work.smallest_flat)) {
    work.smallest_radius = radius;
    work.smallest_flat = flat;
    work.ends_in_point = flat <= 0 && outer_profile(tool).round <= 0;
  }
  work.greatest_radius = std::max(work.greatest_radius, radius);
  work.allowance_side = std::min(work.allowance_side, operation.allowance_side);
  work.allowance_floor = std::min(work.allowance_floor, operation.allowance_floor);
  if (operation.scallop)
    work.scallop = std::min(work.scallop.value_or(*operation.scallop), *operation.scallop);
}

}  // namespace

namespace {

/// `any_of_them`: which of the cutters has made which part of the walls is not known, and the roundest end leaves the most.
Scallop scallop_by(const Feature& feature, const FeatureWork& work, const Tolerances& tol, bool any_of_them) {
  const double draft = feature.wall_slope.radians();
  Scallop scallop{0, work.scallop.value_or(tol.scallop), feature.top_z};
  const Tool* roundest = any_of_them ? roundest_on_walls(work) : nullptr;
  std::vector<LayerOnWall> layers;
  for (const LevelCoverage& layer : work.layers) {
    const Tool* tool = layer.tool ? layer.tool : work.on_walls;
    layers.push_back({layer.z, rounding_of(roundest) > rounding_of(tool) ? roundest : tool});
  }
  layers.push_back({work.floor.z, work.on_walls});
  const double above_corner = work.floor.z + corner_height(feature, work.on_walls);
  double above = feature.top_z;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const double to = above - layers[i].z, from = std::max(above_corner - layers[i].z, 0.0);
    const double left = from < to ? most_left({layers.data() + i, layers.size() - i}, from, to, draft) : 0;
    if (left > scallop.height_mm) scallop.height_mm = left, scallop.z = layers[i].z;
    above = layers[i].z;
  }
  return scallop;
}

}  // namespace

std::optional<Scallop> scallop_of(const Feature& feature, const FeatureWork& work, const Tolerances& tol) {
  if (feature.wall_slope.radians() <= 0) return std::nullopt;
  Scallop scallop = scallop_by(feature, work, tol, true);
  // The test place by place found no more than the permitted material.
  if (work.is_cut_between_layers) scallop.height_mm = std::min(scallop.height_mm, *scallop.asked_mm);
  return scallop;
}

std::vector<FeatureWork> works_of(const Part& part) {
  std::vector<FeatureWork> works;
  for (std::size_t i = 0; i < part.workplan.size(); ++i) {
    const Workingstep& step = part.workplan[i];
    const Operation& operation = step.operation;
    if (is_formed(part.features[static_cast<std::size_t>(step.feature)]) ||
        part.features[static_cast<std::size_t>(step.feature)].carving ||
        part.features[static_cast<std::size_t>(step.feature)].chamfer)
      continue;
    const bool known = operation.tool >= 0 && operation.tool < static_cast<int>(part.tools.size());
    static const Tool kNone;
    const Tool& tool = known ? part.tools[static_cast<std::size_t>(operation.tool)] : kNone;
    if (is_carved(part.features[static_cast<std::size_t>(step.feature)], tool)) continue;
    auto work = std::find_if(works.begin(), works.end(),
                             [&](const FeatureWork& w) { return w.feature == step.feature; });
    if (work == works.end()) {
      FeatureWork first;
      first.feature = step.feature;
      first.smallest_radius = first.greatest_radius = tool.radius();
      first.smallest_flat = -1;
      first.allowance_side = operation.allowance_side;
      first.allowance_floor = operation.allowance_floor;
      works.push_back(first);
      work = works.end() - 1;
    }
    work->last_workingstep = static_cast<int>(i);
    refine(*work, operation, tool);
    work->floor.z = part.features[step.feature].floor_z + work->allowance_floor;
  }
  return works;
}

FloorCheck floor_check(const Part& part, const FinishedParts& finished, const CheckedProgram& program,
                       const VerifyOptions& options) {
  const auto check = std::make_shared<const WorkCheck>(part, finished, program, options);
  return [check](const FeatureWork& work, double off) {
    LevelCoverage floor = work.floor;
    check->check_level(work, floor, 0, off);
    return floor;
  };
}

namespace {

/// Leaves out the layers that are not cleared if the others by themselves leave no more than the permitted scallop: a layer clears all
/// above it within its own outline, so that no more stands on the walls than the steps between the cleared layers. Level moves of entries,
/// and layers of a wider cutter in corners that a narrower one clears at its own heights, are such layers.
void leave_out_uncleared_layers(const Feature& feature, FeatureWork& work, const Tolerances& tol) {
  FeatureWork cleared = work;
  std::erase_if(cleared.layers,
                [&](const LevelCoverage& layer) { return layer.coverage.thickness_mm > widest_left(tol); });
  if (cleared.layers.size() == work.layers.size()) return;
  const Scallop scallop = scallop_by(feature, cleared, tol, false);
  if (scallop.height_mm <= *scallop.asked_mm + tol.uncut) work.layers = std::move(cleared.layers);
}

}  // namespace

void check_works(const Part& part, const FinishedParts& finished, const CheckedProgram& program,
                 const VerifyOptions& options, std::vector<FeatureWork>& works, Tasks beside) {
  const WorkCheck check(part, finished, program, options);
  const auto add_layer_tasks = [&](FeatureWork& work, Tasks& tasks) {
    check.add_layers(work);
    for (LevelCoverage& layer : work.layers) {
      tasks.push_back([&check, &work, &layer] { check.check_level(work, layer); });
    }
  };
  Tasks first = std::move(beside);
  for (FeatureWork& work : works) {
    first.push_back([&check, &work] { check.check_floor(work); });
    if (check.leans(work)) add_layer_tasks(work, first);
  }
  run_all(first, options.threads, options.cancel);

  for (FeatureWork& work : works) {
    if (check.leans(work))
      leave_out_uncleared_layers(part.features[static_cast<std::size_t>(work.feature)], work, options.tol);
  }
  Tasks second;
  for (FeatureWork& work : works) {
    const bool left = work.floor.any_cut && work.floor.coverage.thickness_mm > options.tol.uncut;
    if (left && work.layers.empty()) add_layer_tasks(work, second);
  }
  for (FeatureWork& work : works) {
    if (check.leans(work)) second.push_back([&check, &work] { check.check_between_layers(work); });
  }
  run_all(second, options.threads, options.cancel);
}

}  // namespace clearcut::verify
