#include "plan/zigzag/zigzag.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "plan/common/clearing_area.h"
#include "plan/common/layers.h"
#include "plan/common/machine_clock.h"
#include "plan/common/round_corners.h"
#include "plan/contour/step_rule.h"
#include "plan/zigzag/cells.h"

namespace clearcut::plan::zigzag {
namespace {

/// Share of the diameter: least overlap of neighbouring lines.
constexpr double kOverlap = 0.01;
/// Share of a line's time added to its time if the material is on the wrong side.
constexpr double kWrongSide = 0.02;
/// Tried directions: those of the longest walls, square to these, and multiples of kCompassStep
/// radians.
constexpr std::size_t kMostWallDirections = 6;
constexpr double kCompassStep = kPi / 4;
/// Radians. Directions that differ by less are equal.
constexpr double kSameDirection = 0.5 * kPi / 180;
/// Number of directions with a fully planned path; the others are only estimated.
constexpr std::size_t kFinalists = 3;
/// Outlines with more edges than this are planned only in the direction with the best estimate.
constexpr std::size_t kMostEdges = 5000;

Edge rotated(const Edge& edge, double angle) {
  return {clearcut::rotated(edge.from, angle), clearcut::rotated(edge.to, angle),
          clearcut::rotated(edge.center, angle), edge.turn};
}

Loop rotated(const Loop& loop, double angle) {
  Loop turned;
  for (const auto& edge : loop) turned.push_back(rotated(edge, angle));
  return turned;
}

Region rotated(const Region& region, double angle) {
  std::vector<Loop> islands;
  for (const auto& island : region.islands()) islands.push_back(rotated(island, angle));
  return Region::from_valid_loops(rotated(region.outer(), angle), std::move(islands));
}

/// A direction and its cells.
struct Draft {
  double angle = 0;  ///< radians
  std::vector<ZigzagCell> cells;
  double estimate = 0;  ///< seconds; see estimate()
};

/// Plans one connected legal area.
class ZigzagPlanner {
 public:
  ZigzagPlanner(const ClearingComponent& component, const Layer& layer, const ZigzagOptions& options)
      : component_(component),
        layer_(layer),
        options_(options),
        area_({component.legal}),
        routes_({component.legal}, area_),
        retract_(options.machine, options.feed, retract_heights(layer)) {}

  /// The paths of the cutter, one for each stretch without a retract link.
  std::vector<Path> plan() const {
    if (component_.rest.empty()) return {};
    auto drafts = drafts_of(directions());
    std::vector<Path> best;
    double best_time = std::numeric_limits<double>::infinity();
    const bool large = component_.legal.edges().size() > kMostEdges;
    drafts.resize(std::min(drafts.size(), large ? 1 : kFinalists));
    for (const auto& draft : drafts) {
      auto paths = paths_of(draft);
      const double time = retract_.time_of(paths, 2 * layer_.tool_radius);
      if (time >= best_time) continue;
      best_time = time;
      best = std::move(paths);
    }
    return best;
  }

 private:
  double speed() const { return options_.feed.mm_per_s(); }
  double widest_step() const {
    const double widest = 2 * layer_.tool_radius * (1 - kOverlap);
    return options_.stepover ? std::min(*options_.stepover, widest) : widest;
  }

  std::vector<double> directions() const {
    if (options_.angle) return {options_.angle->radians()};
    std::vector<std::pair<double, double>> walls;  // minus the length, mm; angle, radians
    for (const auto& edge : component_.legal.edges()) {
      if (!edge.is_arc()) walls.push_back({-edge.length(), angle_of(edge.to - edge.from)});
    }
    std::sort(walls.begin(), walls.end());
    std::vector<double> found;
    const auto add = [&](double angle) {
      const double turned = std::fmod(std::fmod(angle, kPi) + kPi, kPi);
      const bool known = std::any_of(found.begin(), found.end(), [&](double other) {
        return std::abs(std::remainder(turned - other, kPi)) < kSameDirection;
      });
      if (!known) found.push_back(turned);
    };
    for (std::size_t i = 0; i < walls.size() && found.size() < 2 * kMostWallDirections; ++i) {
      add(walls[i].second);
      add(walls[i].second + kPi / 2);
    }
    for (double angle = 0; angle < kPi - 1e-9; angle += kCompassStep) add(angle);
    return found;
  }

  std::vector<Draft> drafts_of(const std::vector<double>& angles) const {
    std::vector<Draft> drafts;
    for (const double angle : angles) {
      Draft draft{angle, {}, 0};
      for (const auto& rest : component_.rest) {
        const auto cells = zigzag_cells(rotated(rest, -angle), layer_.tool_radius, widest_step());
        draft.cells.insert(draft.cells.end(), cells.begin(), cells.end());
      }
      draft.estimate = estimate(draft.cells);
      drafts.push_back(std::move(draft));
    }
    std::stable_sort(drafts.begin(), drafts.end(),
                     [](const Draft& a, const Draft& b) { return a.estimate < b.estimate; });
    return drafts;
  }

  /// Seconds: the lines, the moves between them, and about one radius and two turns from each cell to the
  /// next.
  double estimate(const std::vector<ZigzagCell>& cells) const {
    double path = 0, turns = 0;
    for (const auto& cell : cells) {
      path += layer_.tool_radius;
      for (std::size_t i = 0; i < cell.lines.size(); ++i) {
        const auto& line = cell.lines[i];
        path += line.right.x - line.left.x;
        if (i == 0) continue;
        const auto& before = cell.lines[i - 1];
        const bool on_right = i % 2 == 1;
        path += on_right ? distance(before.right, line.right) : distance(before.left, line.left);
      }
      turns += 2 * static_cast<double>(cell.lines.size());
    }
    return path / speed() + turns * speed() / options_.machine.acceleration;
  }

  /// mm of a cell's lines with the material on the wrong side. The first line is cut as a slot; for each other line
  /// the material is ahead: above the line if the cell is cut upwards.
  double wrong_side_length(const ZigzagCell& cell, int variant) const {
    const bool upwards = (variant & 1) == 0;
    double wrong = 0;
    const auto lines = cut_lines(cell, variant);
    for (std::size_t i = 1; i < lines.size(); ++i) {
      const bool rightwards = lines[i].right.x > lines[i].left.x;
      const bool on_right = rightwards != upwards;
      if (on_right != options_.material_on_right) wrong += std::abs(lines[i].right.x - lines[i].left.x);
    }
    return wrong;
  }

  std::vector<Path> paths_of(const Draft& draft) const {
    const auto original = [&](Vec2 p) { return clearcut::rotated(p, draft.angle); };
    OrderQuestion question;
    question.travel = [&](Vec2 from, Vec2 to) {
      const Vec2 a = original(from), b = original(to);
      const auto path = retract_.link_at_depth(a, b, routes_);
      return path ? length(*path) / speed() : retract_.time(distance(a, b));
    };
    question.far_travel = [&](Vec2 from, Vec2 to) { return retract_.time(distance(from, to)); };
    question.own = [&](const CellVisit& visit) {
      return kWrongSide * wrong_side_length(draft.cells[visit.cell], visit.variant) / speed();
    };
    std::vector<Path> paths(1);
    std::optional<Vec2> at;
    for (const auto& visit : order_cells(draft.cells, question)) {
      for (const auto& line : cut_lines(draft.cells[visit.cell], visit.variant)) {
        add_line(original(line.left), original(line.right), at, paths);
      }
    }
    if (paths.back().empty()) paths.back() = path_to_wall(*at);
    return paths;
  }

  void add_line(Vec2 from, Vec2 to, std::optional<Vec2>& at, std::vector<Path>& paths) const {
    if (at && *at != from) {
      const auto path = retract_.link_at_depth(*at, from, routes_);
      if (!path) {
        if (paths.back().empty()) paths.back() = path_to_wall(*at);
        paths.emplace_back();
      } else {
        for (Edge edge : *path) {
          edge.from = *at;
          paths.back().push_back(edge);
          at = edge.to;
        }
        from = *at;
      }
    }
    if (distance(from, to) > 1e-7) {
      paths.back().push_back(Edge::line(from, to));
      at = to;
    } else {
      at = from;
    }
  }

  /// A path from p, a single position clearing everything, to the nearest place on the wall.
  Path path_to_wall(Vec2 p) const {
    Vec2 best = p;
    double best_distance = std::numeric_limits<double>::infinity();
    for (const auto& edge : component_.legal.edges()) {
      const auto foot = nearest(edge, p);
      if (foot.distance >= best_distance) continue;
      best_distance = foot.distance;
      best = foot.point;
    }
    return {Edge::line(p, best)};
  }

  const ClearingComponent& component_;
  const Layer& layer_;
  const ZigzagOptions& options_;
  LegalArea area_;
  LegalRoutes routes_;
  RetractLink retract_;
};

}  // namespace

LayerPasses plan_zigzag(const Layer& layer, const ZigzagOptions& options, const Tolerances& tol) {
  CLEARCUT_ASSERT(layer.tool_radius > 0);
  auto area = clearing_area(layer, tol);
  LayerPasses result = std::move(area.walls);
  result.strategy = "zigzag";
  for (std::size_t i = 0; i < area.components.size(); ++i) {
    for (auto& path : ZigzagPlanner(area.components[i], layer, options).plan()) {
      Pass pass;
      pass.path = std::move(path);
      pass.parent = area.components[i].outer_wall;
      pass.component = static_cast<int>(i);
      pass.start_priority = 2 * layer.tool_radius + layer.wall_stock;  // farther from walls than their passes
      pass.reversible = false;
      result.passes.push_back(std::move(pass));
    }
  }
  round_corners(result, layer.tool_radius, options.feed.mm_per_s(), options.machine.acceleration);
  return result;
}

namespace {

Strategy make(const StrategyRequest& request) {
  ZigzagOptions options;
  options.angle = request.step.stroke_angle;
  options.material_on_right = request.step.wall_on_right();
  options.machine = request.plan.machine;
  options.feed = request.step.feed;
  line_distance(request.stepover,
                1);  // throws for rules without meaning for lines, before planning begins
  return once_per_outline(
      [options, stepover = request.stepover, tol = request.plan.tol](const Layer& layer) mutable {
        options.stepover = line_distance(stepover, 2 * layer.tool_radius);
        return plan_zigzag(layer, options, tol);
      });
}

}  // namespace

StrategyEntry entry() {
  StrategyEntry entry;
  entry.name = "zigzag";
  entry.description = "parallel lines to and fro, then along the walls";
  entry.make = make;
  entry.keeps_direction = false;
  entry.loses_air_cuts = true;
  entry.in_auto = AutoUse::kTried;
  return entry;
}

}  // namespace clearcut::plan::zigzag
