#include "plan/contour/passes.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "base/tolerances.h"
#include "geometry/contours/mitred_inset.h"
#include "geometry/edge.h"
#include "geometry/route/legal_area.h"
#include "plan/common/residual.h"
#include "plan/contour/published_rings.h"

namespace clearcut::plan::contour {
namespace {

/// mm. Steps are as wide as they may be up to rests of this thickness (ring_band.cpp), far less than may stay uncut.
constexpr double kStepResidual = 0.003;

/// mm. Curved bisectors are replaced by chords this near to them.
constexpr double kBisectorChord = 0.005;

Nearest nearest_on(const Path& path, Vec2 p, std::size_t& edge) {
  Nearest best{{}, std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto candidate = nearest(path[i], p);
    if (candidate.distance < best.distance) {
      best = candidate;
      edge = i;
    }
  }
  return best;
}

/// A published loop replaces a straight line from root to tip; the replaced detour may deviate from that line by this
/// share of the radius.
constexpr double kStraightDetour = 0.1;

std::optional<CornerLoop> loop_of(ResidualRule rule) {
  switch (rule) {
    case ResidualRule::kLoops:
      return CornerLoop::kCircle;
    case ResidualRule::kPwid:
      return CornerLoop::kPwid;
    case ResidualRule::kSingleLoops:
      return CornerLoop::kSingle;
    case ResidualRule::kDoubleLoops:
      return CornerLoop::kDouble;
    default:
      return std::nullopt;
  }
}

bool stays_clear(const Path& loop, const Region& domain, double level) {
  return std::all_of(loop.begin(), loop.end(), [&](const Edge& edge) {
    const Box around = edge.box().grown(level);
    const auto near = [&](const Edge& wall) {
      return around.overlaps(wall.box()) && distance(edge, wall) < level - 1e-6;
    };
    const auto clear = [&](const Loop& walls) { return std::none_of(walls.begin(), walls.end(), near); };
    return clear(domain.outer()) && std::all_of(domain.islands().begin(), domain.islands().end(), clear);
  });
}

/// mm. A path beginning no farther than this from a corner of its ring is treated as beginning at that corner.
constexpr double kAtCorner = 0.01;

/// Inserts into a ring, at the point nearest to `begin`, a path that returns to its start.
template <typename MakePath>
void insert_path(Path& ring, Vec2 begin, MakePath&& path_from) {
  std::size_t at = 0;
  const auto root = nearest_on(ring, begin, at);
  const Edge edge = ring[at];
  const double margin = kAtCorner / edge.length();
  const bool at_end = root.t >= 1 - margin, inside = root.t > margin && !at_end;
  const Vec2 from = inside ? root.point : at_end ? edge.to : edge.from;
  const Edge& before = at == 0 ? ring.back() : ring[at - 1];
  const Edge& after = at + 1 == ring.size() ? ring.front() : ring[at + 1];
  const Vec2 in = inside ? edge.tangent_at(root.t) : at_end ? edge.tangent_at(1) : before.tangent_at(1);
  const Vec2 out = inside ? in : at_end ? after.tangent_at(0) : edge.tangent_at(0);
  Path pieces = path_from(from, in, out);
  if (inside) {
    pieces.insert(pieces.begin(), edge.part(0, root.t));
    pieces.push_back(edge.part(root.t, 1));
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
  }
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(at_end ? at + 1 : at), pieces.begin(), pieces.end());
}

/// Turns the ring trees of one layer into passes.
class PassBuilder {
 public:
  PassBuilder(const RingJob& job, const Tolerances& tol) : job_(job), tol_(tol) {}

  /// Whether the domain's contours keep its corners.
  bool add_domain(const Domain& domain) {
    const std::size_t before = passes_.size();
    const int components_before = components_;
    if (keeps_corners(domain, job_)) {
      add_contours(domain, mitred_ring_tree(domain.region, job_.first_level, job_.sharp_step, tol_));
      if (!job_.leaves_nothing || mend_rings(before, domain)) return true;
      passes_.resize(before);
      boxes_.resize(std::min(boxes_.size(), before));
      components_ = components_before;
    }
    add_contours(domain, ring_tree(domain.clearance, domain.region, job_.first_level, job_.step, tol_));
    return false;
  }

  void add_fit_lines() {
    for (const auto& line : job_.fit_lines) add_fit_line(line);
  }

  std::vector<Pass> take_passes() { return std::move(passes_); }

 private:
  void add_contours(const Domain& domain, const std::vector<RingNode>& nodes) {
    add_rings(nodes);
    if (clears_residuals()) add_residuals(nodes, domain.region);
    if (job_.residuals == ResidualRule::kPassages) add_passages(nodes, domain.region);
    if (job_.residuals == ResidualRule::kBisectors && !nodes.empty()) add_bisectors(domain, nodes);
  }

  bool clears_residuals() const {
    return job_.residuals == ResidualRule::kOurs || loop_of(job_.residuals).has_value();
  }

  /// Contours with sharp corners leave material about them of which the medial axis knows nothing: straight detours
  /// clear it. False if they do not.
  bool mend_rings(std::size_t first, const Domain& domain) {
    const LegalArea legal(safe_inset(domain.clearance, domain.region, job_.first_level, tol_));
    MendJob mending;
    mending.radius = job_.radius;
    mending.matters = [&](Vec2 p) { return legal.contains(p); };
    mending.legal = [&](Vec2 a, Vec2 b) { return legal.holds_line(a, b); };
    std::vector<Path> paths;
    for (std::size_t i = first; i < passes_.size(); ++i) paths.push_back(passes_[i].path);
    paths.insert(paths.end(), job_.fit_lines.begin(), job_.fit_lines.end());
    if (!clears_residuals()) {
      mending.residual = kStepResidual;
      return left_by(paths, mending).empty();
    }
    if (!mend(paths, mending)) return false;
    for (std::size_t i = first; i < passes_.size(); ++i) passes_[i].path = std::move(paths[i - first]);
    return true;
  }

  void add_rings(const std::vector<RingNode>& nodes) {
    rings_of_.assign(nodes.size(), {});
    component_of_.assign(nodes.size(), 0);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const int parent = nodes[i].parent;
      component_of_[i] = parent < 0 ? components_++ : component_of_[static_cast<std::size_t>(parent)];
      add_ring(i, nodes[i].contour.outer(), nodes[i]);
      for (const auto& island : nodes[i].contour.islands()) add_ring(i, island, nodes[i]);
    }
  }

  void add_ring(std::size_t node, const Loop& loop, const RingNode& ring) {
    Pass pass;
    pass.path = loop;
    pass.closed = true;
    pass.parent =
        ring.parent < 0 ? -1 : nearest_ring(static_cast<std::size_t>(ring.parent), loop.front().from);
    pass.component = component_of_[node];
    pass.offset = pass.start_priority = ring.level;
    pass.reversible = false;
    rings_of_[node].push_back(passes_.size());
    boxes_.resize(passes_.size());
    boxes_.push_back(box(loop));
    passes_.push_back(std::move(pass));
  }

  int nearest_ring(std::size_t node, Vec2 p) const {
    if (rings_of_[node].size() == 1) return static_cast<int>(rings_of_[node].front());
    NearestRing best{rings_of_[node].front()};
    look_through(rings_of_[node], p, best);
    return static_cast<int>(best.ring);
  }

  struct NearestRing {
    std::size_t ring = 0;
    double distance = std::numeric_limits<double>::infinity();
  };

  /// For a node around many islands only rings with sufficiently near boxes are measured.
  void look_through(const std::vector<std::size_t>& rings, Vec2 p, NearestRing& best) const {
    std::size_t edge = 0;
    for (const std::size_t ring : rings) {
      if (boxes_[ring].distance_to(p) > best.distance + kRoundingMm) continue;
      const double d = nearest_on(passes_[ring].path, p, edge).distance;
      if (d < best.distance) best = {ring, d};
    }
  }

  void add_detour(const RingNode& node, const ResidualPath& residual, const Region& domain) {
    const Vec2 root = residual.points.front();
    const std::size_t ring = ring_at_root(node, root);
    // A contour with sharp corners may have ended before the axis rises to its level.
    std::size_t edge = 0;
    const Nearest begin = nearest_on(passes_[ring].path, root, edge);
    if (job_.sharp_step && begin.distance > kAtCorner &&
        !stays_clear({Edge::line(begin.point, residual.points[1])}, domain, job_.first_level))
      return;
    insert_path(passes_[ring].path, root, [&](Vec2 from, Vec2 in, Vec2 out) {
      std::vector<Vec2> points = residual.points;
      points.front() = points.back() = from;
      Path path = loop_for(points, in, out, domain).value_or(line_path(points));
      boxes_[ring].add(box(path));
      return path;
    });
  }

  /// The published loop instead of the path to the tip and back; nothing if the loop does not fit or does not clear
  /// the same area.
  std::optional<Path> loop_for(const std::vector<Vec2>& detour, Vec2 in, Vec2 out,
                               const Region& domain) const {
    const auto kind = loop_of(job_.residuals);
    if (!kind) return std::nullopt;
    const Vec2 root = detour.front();
    const Vec2 tip = *std::max_element(detour.begin(), detour.end(), [&](Vec2 a, Vec2 b) {
      return norm_squared(a - root) < norm_squared(b - root);
    });
    if (tip == root) return std::nullopt;
    const Edge path = Edge::line(root, tip);
    const bool straight = std::all_of(detour.begin(), detour.end(), [&](Vec2 p) {
      return distance(path, p) <= kStraightDetour * job_.radius;
    });
    auto loop = straight ? corner_loop(*kind, root, tip, in, out, job_.radius) : std::nullopt;
    return loop && stays_clear(*loop, domain, job_.first_level) ? loop : std::nullopt;
  }

  void add_residuals(const std::vector<RingNode>& nodes, const Region& domain) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (const auto& residual : residual_paths(nodes[i], job_.radius - job_.margin)) {
        if (residual.rooted && !nodes[i].children.empty()) {
          add_detour(nodes[i], residual, domain);
        } else {
          add_ridge(i, residual);
        }
      }
    }
  }

  std::size_t ring_at_root(const RingNode& node, Vec2 root) const {
    NearestRing best;
    for (const int child : node.children)
      look_through(rings_of_[static_cast<std::size_t>(child)], root, best);
    return best.ring;
  }

  void add_ridge(std::size_t node, const ResidualPath& residual) {
    Pass pass;
    pass.parent = nearest_ring(node, residual.points.front());
    pass.closed = residual.closed;
    pass.path = line_path(residual.points);
    if (residual.closed && residual.points.back() != residual.points.front())
      pass.path.push_back(Edge::line(residual.points.back(), residual.points.front()));
    if (pass.path.empty()) {
      // One position clears the whole residual: it is reached on a short path from the ring around it.
      std::size_t edge = 0;
      const auto foot =
          nearest_on(passes_[static_cast<std::size_t>(pass.parent)].path, residual.points[0], edge);
      pass.path = {Edge::line(residual.points[0], foot.point)};
    }
    pass.component = component_of_[node];
    pass.start_priority = passes_[static_cast<std::size_t>(pass.parent)].offset;
    passes_.push_back(std::move(pass));
  }

  /// CPO-rho 3.2: the passage from a contour's corner to the next contour, along the bisector, clears the residual of
  /// the step there.
  void add_passages(const std::vector<RingNode>& nodes, const Region& domain) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i].children.empty()) continue;
      const auto corner = single_smallest_corner(nodes[i].contour);
      if (!corner) continue;
      std::size_t edge = 0;
      const Vec2 next = nearest_on(passes_[ring_at_root(nodes[i], *corner)].path, *corner, edge).point;
      const Path path{Edge::line(next, *corner)};
      if (next == *corner || !stays_clear(path, domain, job_.first_level)) continue;
      Pass pass;
      pass.path = path;
      pass.parent = nearest_ring(i, *corner);
      pass.component = component_of_[i];
      pass.start_priority = passes_[static_cast<std::size_t>(pass.parent)].offset;
      passes_.push_back(std::move(pass));
    }
  }

  /// Lin et al.: a pass along the bisector of every corner in which the step leaves material, from the ring at the
  /// wall to its intersection with another bisector. A bisector within reach of the ring at the wall has nothing left.
  void add_bisectors(const Domain& domain, const std::vector<RingNode>& nodes) {
    const auto& axis = domain.clearance.axis();
    std::vector<std::vector<int>> edges_at(axis.points.size());
    for (std::size_t i = 0; i < axis.edges.size(); ++i) {
      edges_at[static_cast<std::size_t>(axis.edges[i].a)].push_back(static_cast<int>(i));
      edges_at[static_cast<std::size_t>(axis.edges[i].b)].push_back(static_cast<int>(i));
    }
    const double step = nodes.front().next_level - nodes.front().level;
    for (std::size_t v = 0; v < axis.points.size(); ++v) {
      if (edges_at[v].size() != 1 || axis.points[v].clearance > 0) continue;
      const auto curve = bisector_from(static_cast<int>(v), edges_at, domain.clearance);
      const double rise =
          (curve[1].clearance - curve[0].clearance) / distance(curve[0].point, curve[1].point);
      const bool is_reached = curve.back().clearance <= job_.first_level + job_.radius;
      if (step > job_.radius * (1 + rise) + 1e-6 && !is_reached) add_bisector(curve);
    }
  }

  static std::vector<AxisPoint> bisector_from(int corner, const std::vector<std::vector<int>>& edges_at,
                                              const Clearance& clearance) {
    const auto& axis = clearance.axis();
    std::vector<AxisPoint> curve{axis.points[static_cast<std::size_t>(corner)]};
    int at = corner, came_by = -1;
    do {
      const auto& edges = edges_at[static_cast<std::size_t>(at)];
      const int edge = edges.front() != came_by ? edges.front() : edges.back();
      auto piece = clearance.axis_curve(edge, kBisectorChord);
      const AxisEdge ends = axis.edges[static_cast<std::size_t>(edge)];
      if (ends.b == at) std::reverse(piece.begin(), piece.end());
      curve.insert(curve.end(), piece.begin() + 1, piece.end());
      at = ends.b == at ? ends.a : ends.b;
      came_by = edge;
    } while (edges_at[static_cast<std::size_t>(at)].size() == 2);
    return curve;
  }

  void add_bisector(const std::vector<AxisPoint>& curve) {
    std::vector<Vec2> points;
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const AxisPoint &a = curve[i - 1], &b = curve[i];
      if (b.clearance <= job_.first_level) continue;
      if (points.empty()) {
        const double t = (job_.first_level - a.clearance) / (b.clearance - a.clearance);
        points.push_back(lerp(a.point, b.point, std::max(t, 0.0)));
      }
      points.push_back(b.point);
    }
    if (points.size() < 2) return;
    Pass pass;
    pass.path = line_path(points);
    pass.start_priority = job_.first_level;
    std::size_t edge = 0;
    double nearest_distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < passes_.size(); ++i) {
      if (!passes_[i].closed || passes_[i].parent >= 0) continue;
      const double d = nearest_on(passes_[i].path, points.front(), edge).distance;
      if (d >= nearest_distance) continue;
      nearest_distance = d;
      pass.parent = static_cast<int>(i);
    }
    if (pass.parent < 0) return;
    pass.component = passes_[static_cast<std::size_t>(pass.parent)].component;
    passes_.push_back(std::move(pass));
  }

  void add_fit_line(const Path& line) {
    Pass pass;
    pass.path = line;
    pass.closed = line.size() > 1 && line.front().from == line.back().to;
    pass.component = components_++;
    pass.offset = pass.start_priority = job_.first_level;
    passes_.push_back(std::move(pass));
  }

  const RingJob& job_;
  const Tolerances& tol_;
  std::vector<Pass> passes_;
  /// For each node: indices of its rings' passes, the outer one first.
  std::vector<std::vector<std::size_t>> rings_of_;
  std::vector<int> component_of_;
  std::vector<Box> boxes_;  ///< boxes of the rings among the passes
  int components_ = 0;
};

}  // namespace

bool keeps_corners(const Domain& domain, const RingJob& job) {
  return job.sharp_step != nullptr && !has_arcs(domain.region);
}

std::vector<Path> fit_lines_of(const std::vector<Domain>& domains, const RingJob& job) {
  std::vector<Path> lines;
  for (const auto& domain : domains)
    for (auto& line : domain.clearance.fit_lines(job.first_level, job.reserve))
      lines.push_back(std::move(line));
  return lines;
}

RingPasses ring_passes(const std::vector<Domain>& domains, const RingJob& job, const Tolerances& tol) {
  RingPasses made;
  PassBuilder builder(job, tol);
  for (const auto& domain : domains) made.with_corners.push_back(builder.add_domain(domain));
  builder.add_fit_lines();
  made.passes = builder.take_passes();
  return made;
}

}  // namespace clearcut::plan::contour
