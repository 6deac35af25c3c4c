#include "plan/contour/published_rings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "base/elementary.h"
#include "base/tolerances.h"
#include "base/units.h"
#include "geometry/contours/mitred_inset.h"
#include "geometry/route/legal_area.h"
#include "geometry/voronoi/clearance.h"

namespace clearcut::plan::contour {
namespace {

/// mm. Loops shorter than this clear nothing.
constexpr double kShortest = 1e-3;
/// sin(alpha / 2) of corners too flat for a loop with sides.
constexpr double kFlattest = 0.999;

Path circle(Vec2 root, Vec2 tip) {
  const Vec2 center = lerp(root, tip, 0.5);
  return {Edge::arc(root, tip, center, Turn::kCounterClockwise),
          Edge::arc(tip, root, center, Turn::kCounterClockwise)};
}

/// `point` mirrored at the line from `root` along the unit vector `axis`.
Vec2 mirrored(Vec2 point, Vec2 root, Vec2 axis) {
  const Vec2 d = point - root;
  return root + axis * (2 * dot(d, axis)) - d;
}

/// A kite whose sides at the tip are parallel to the corner's; the other two sides are square to them.
Path kite(Vec2 root, Vec2 tip, double half_sine) {
  const Vec2 path = tip - root, axis = unit(path), across{-axis.y, axis.x};
  const double half_cosine = std::sqrt(1 - half_sine * half_sine), side = norm(path) * half_sine;
  const Vec2 foot = root + axis * (side * half_sine) + across * (side * half_cosine);
  const Vec2 other = mirrored(foot, root, axis);
  return {Edge::line(root, foot), Edge::line(foot, tip), Edge::line(tip, other), Edge::line(other, root)};
}

/// A loop that continues straight along `in`, on an arc through the tip, and back along `out`; symmetric about
/// the line to the tip.
Path tangent_loop(Vec2 root, Vec2 tip, double half_sine, Vec2 in) {
  const Vec2 path = tip - root, axis = unit(path);
  const double radius = norm(path) * half_sine / (1 + half_sine);
  const double straight = radius * std::sqrt(1 - half_sine * half_sine) / half_sine;
  const Vec2 center = tip - axis * radius, across{-axis.y, axis.x};
  const double side = dot(in, across) > 0 ? 1 : -1, half_cosine = std::sqrt(1 - half_sine * half_sine);
  const Vec2 leave = root + (axis * half_cosine + across * (side * half_sine)) * straight;
  const Vec2 back = mirrored(leave, root, axis);
  return {Edge::line(root, leave),
          Edge::arc(leave, back, center, side > 0 ? Turn::kClockwise : Turn::kCounterClockwise),
          Edge::line(back, root)};
}

}  // namespace

std::optional<Path> corner_loop(CornerLoop kind, Vec2 root, Vec2 tip, Vec2 in, Vec2 out, double radius) {
  const double far = distance(root, tip);
  if (far < kShortest || (kind == CornerLoop::kCircle && far > 2 * radius)) return std::nullopt;
  if (kind == CornerLoop::kCircle) return circle(root, tip);
  // The contour turns by pi - alpha at its corner.
  const double half_sine = std::sqrt(std::max(0.0, (1 + dot(in, out)) / 2));
  if (cross(in, out) <= 0 || half_sine > kFlattest || half_sine < 1 - kFlattest) return std::nullopt;
  const double half_width = kind == CornerLoop::kPwid ? far * half_sine * std::sqrt(1 - half_sine * half_sine)
                                                      : far * half_sine / (1 + half_sine);
  if (half_width > radius) return std::nullopt;
  if (kind == CornerLoop::kPwid) return kite(root, tip, half_sine);
  Path loop = tangent_loop(root, tip, half_sine, in);
  if (kind == CornerLoop::kSingle) return loop;
  Path twice = tangent_loop(root, lerp(root, tip, 0.5), half_sine, in);
  twice.insert(twice.end(), loop.begin(), loop.end());
  return twice;
}

namespace {

constexpr double kEverywhere = 1e9;  // mm

/// The medial axis inside a contour up to `depth` mm from it; levels are counted from the wall.
std::vector<AxisPiece> axis_inside(const RingNode& ring, const Clearance& clearance, double depth) {
  std::vector<AxisPiece> pieces = axis_below(clearance, depth);
  for (AxisPiece& piece : pieces) {
    piece.low.clearance += ring.level;
    piece.high.clearance += ring.level;
  }
  return pieces;
}

}  // namespace

std::vector<RingNode> mitred_ring_tree(const Region& domain, double first_level, const StepOf& step_of,
                                       const Tolerances& tol) {
  std::vector<RingNode> nodes;
  const auto add = [&](const Region& around, double distance, int parent, double level) {
    const int depth = parent < 0 ? 0 : nodes[static_cast<std::size_t>(parent)].depth + 1;
    for (const Region& contour : mitred_inset(around, distance, tol)) {
      if (parent >= 0)
        nodes[static_cast<std::size_t>(parent)].children.push_back(static_cast<int>(nodes.size()));
      nodes.push_back({contour, level, level, parent, depth, {}, {}});
    }
  };
  add(domain, first_level, -1, first_level);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Region around = nodes[i].contour;  // a copy: the list grows
    const Clearance clearance(around, tol);
    const double step = step_of(nodes[i], axis_inside(nodes[i], clearance, kEverywhere));
    nodes[i].next_level = nodes[i].level + step;
    add(around, step, static_cast<int>(i), nodes[i].next_level);
    nodes[i].gap = axis_inside(nodes[i], clearance, nodes[i].children.empty() ? kEverywhere : step);
  }
  return nodes;
}

namespace {

/// Interior angles outside of these limits, radians, are no corners of a contour: tips of loops, and smooth joints.
constexpr double kSharpest = 0.01, kBluntest = kPi - 1e-6;

struct Place {
  Vec2 point;
  std::size_t edge = 0;
  double t = 0;
};

Place nearest_place(const Path& ring, Vec2 p) {
  Place best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto near = nearest(ring[i], p);
    if (near.distance >= least) continue;
    least = near.distance;
    best = {near.point, i, near.t};
  }
  return best;
}

double angle_before(const Path& ring, std::size_t edge) {
  const Vec2 in = ring[edge == 0 ? ring.size() - 1 : edge - 1].tangent_at(1), out = ring[edge].tangent_at(0);
  return kPi - base::atan2(cross(in, out), dot(in, out));
}

/// The corner with the smallest interior angle; the start of the ring if it has no corner.
Place sharpest_corner(const Path& ring) {
  std::size_t best = 0;
  double least = kBluntest;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double angle = angle_before(ring, i);
    if (angle < kSharpest || angle > least - kSameAngleRad) continue;
    least = angle;
    best = i;
  }
  return {ring[best].from, best, 0};
}

/// The ring once round from the given place.
Path begun_at(const Path& ring, const Place& place) {
  const auto at = static_cast<std::ptrdiff_t>(place.edge);
  const Edge& edge = ring[place.edge];
  Path path;
  const bool inside = place.point != edge.from && place.point != edge.to;
  const std::ptrdiff_t first = place.point == edge.from ? at : at + 1;
  if (inside) path.push_back(edge.part(place.t, 1));
  path.insert(path.end(), ring.begin() + first, ring.end());
  path.insert(path.end(), ring.begin(), ring.begin() + std::min(first, at + (inside ? 0 : 1)));
  if (inside) path.push_back(edge.part(0, place.t));
  return path;
}

/// Rings joined in one pass, from the wall inwards, and the start of each.
struct Run {
  std::vector<std::size_t> rings;
  std::vector<Place> begins;
};

class Joiner {
 public:
  Joiner(LayerPasses& layer, const ContourOptions& options)
      : layer_(layer), options_(options), legal_(layer.legal), inner_(layer.passes.size()) {
    for (std::size_t i = 0; i < layer.passes.size(); ++i) {
      const Pass& pass = layer.passes[i];
      if (pass.closed && pass.parent >= 0) inner_[static_cast<std::size_t>(pass.parent)].push_back(i);
    }
  }

  void join() {
    const std::size_t count = layer_.passes.size();
    std::vector<int> place(count, -1);  // for each pass: index of the joined pass containing it; -1: none
    std::vector<Pass> joined;
    for (std::size_t i = 0; i < count; ++i) {
      if (place[i] >= 0 || !layer_.passes[i].closed) continue;
      const Run run = run_from(i);
      for (const std::size_t ring : run.rings) place[ring] = static_cast<int>(joined.size());
      joined.push_back(run.rings.size() > 1 ? joined_pass(run) : layer_.passes[i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (!layer_.passes[i].closed && !is_held(layer_.passes[i])) joined.push_back(layer_.passes[i]);
    }
    for (Pass& pass : joined) {
      if (pass.parent >= 0) pass.parent = place[static_cast<std::size_t>(pass.parent)];
    }
    layer_.passes = std::move(joined);
  }

 private:
  Run run_from(std::size_t outermost) const {
    Run run{{outermost}, {sharpest_corner(layer_.passes[outermost].path)}};
    while (inner_[run.rings.back()].size() == 1) {
      const std::size_t next = inner_[run.rings.back()].front();
      const Place begin = nearest_place(layer_.passes[next].path, run.begins.back().point);
      if (!legal_.holds_line(run.begins.back().point, begin.point)) break;
      run.rings.push_back(next);
      run.begins.push_back(begin);
    }
    return run;
  }

  Path oriented_ring(std::size_t ring, const Place& begin) const {
    Path path = begun_at(layer_.passes[ring].path, begin);
    return options_.wall_on_right ? path : reversed(path);
  }

  Pass joined_pass(const Run& run) {
    Pass joined = layer_.passes[run.rings.front()];
    joined.path.clear();
    joined.closed = joined.reversible = false;
    const std::size_t last = run.rings.size() - 1;
    for (std::size_t step = 0; step <= last; ++step) {
      const std::size_t i = options_.outside_in ? step : last - step;
      const Path ring = oriented_ring(run.rings[i], run.begins[i]);
      if (step > 0) {
        passages_.push_back(Edge::line(joined.path.back().to, ring.front().from));
        joined.path.push_back(passages_.back());
      }
      joined.path.insert(joined.path.end(), ring.begin(), ring.end());
    }
    return joined;
  }

  /// Whether a pass is a single passage already contained in a joined pass.
  bool is_held(const Pass& pass) const {
    if (pass.path.size() != 1) return false;
    const Edge& own = pass.path.front();
    const auto same = [](Vec2 a, Vec2 b) { return norm_squared(a - b) < kSamePlaceMm * kSamePlaceMm; };
    return std::any_of(passages_.begin(), passages_.end(), [&](const Edge& edge) {
      return (same(edge.from, own.from) && same(edge.to, own.to)) ||
             (same(edge.from, own.to) && same(edge.to, own.from));
    });
  }

  LayerPasses& layer_;
  const ContourOptions& options_;
  LegalArea legal_;
  std::vector<std::vector<std::size_t>> inner_;  ///< rings right inside each ring
  std::vector<Edge> passages_;
};

}  // namespace

void join_along_bisectors(LayerPasses& layer, const ContourOptions& options) {
  Joiner(layer, options).join();
}

}  // namespace clearcut::plan::contour
