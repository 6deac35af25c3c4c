#include "plan/contour/skeleton/tighten.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/units.h"
#include "geometry/spatial/cell_grid.h"
#include "plan/common/cover.h"
#include "plan/common/outer_rim.h"
#include "plan/contour/skeleton/bands.h"
#include "plan/contour/skeleton/minimise.h"

namespace clearcut::plan::contour {
namespace {

/// mm. The witnesses' limit is less than the radius by kPullMargin while paths are shortened, by
/// kWitnessMargin at the end.
constexpr double kPullMargin = 0.0005;
constexpr double kWitnessMargin = 0.004;
/// mm. The exact check runs with a radius smaller by this, more than any program's rounding.
constexpr double kProvenMargin = 0.001;
/// In the first kRoughRounds rounds the check runs with the radius times kFirstSample, so that only large
/// holes count.
constexpr double kFirstSample = 1.01;
constexpr int kRoughRounds = 3;
/// mm. If passes fit exactly side by side there is no room for margins: the limit and the radius of the
/// check are greater than the radius by these.
constexpr double kResidualLimit = 0.0012;
constexpr double kResidual = 0.0035;
/// Distance between the first witnesses, as a share of the radius.
constexpr double kSeedSpacing = 1.0;
/// A vertex nearer than this to both its neighbours is dropped; share of the vertices' distance.
constexpr double kCrowded = 0.3;
/// Greatest size of a hole as a share of the radius; larger ones count as several.
constexpr double kHoleSize = 2.0;
/// Rim vertices this near to the middle of a hole belong to this hole; share of the hole's size.
constexpr double kSameHole = 0.6;
/// Number of rounds at the end in which the exact check must find nothing; bands shorten in the first
/// kSettlingRounds of them.
constexpr int kSettlingRounds = 4;
constexpr int kMendingRounds = 14;
/// If more than kStalledAbove holes are left and kMostStalled rounds close fewer than a fifth of them, there
/// is no room to close them.
constexpr int kMostStalled = 2;
constexpr std::size_t kStalledAbove = 20;
/// Up to this many holes get a witness at every corner, because long thin holes would shrink slowly
/// otherwise.
constexpr std::size_t kFewHoles = 20;

constexpr Pull kFirstPull{22, 0.3, 0.03, 2};
constexpr Pull kLaterPull{10, 0.1, 0.03, 100};
constexpr Pull kSettling{10, 0.02, 0.2, 2000};
/// Without tension, so that no new holes open while the last ones are closed.
constexpr Pull kMending{10, 0.02, 0.5, 2e4, 0};

Bands bands_of(Skeleton skeleton) {
  Bands paths{std::move(skeleton), {}, {}, {}, 0};
  for (const auto& ring : paths.skeleton.rings)
    paths.fixed.insert(paths.fixed.end(), ring.begin(), ring.end());
  return paths;
}

}  // namespace

struct Tightener::Impl {
  Impl(Skeleton skeleton, TightenJob job)
      : paths_(bands_of(std::move(skeleton))),
        job_(std::move(job)),
        minimiser_(paths_, job_),
        limit_(job_.radius - kPullMargin) {
    prove_with(kFirstSample * job_.radius);
    respace();
    paths_.list();
    if (paths_.bands.empty()) return;
    seed_witnesses();
    seed_seams();
  }

  void pull(int rounds) {
    if (round_ >= kRoughRounds) prove_with(job_.radius - kProvenMargin);
    for (int k = 0; k < rounds && !paths_.bands.empty(); ++k) {
      minimiser_.relax(round_++ == 0 ? kFirstPull : kLaterPull, limit_);
      const Cover now = cover();
      add_witnesses(now.holes(job_.matters), now);
      respace();
      paths_.list();
    }
  }

  bool finish() {
    // Fixed witnesses are no longer needed and would work against the moving ones.
    std::erase_if(paths_.witnesses, [](const Witness& w) { return !w.moving; });
    limit_ = job_.radius - kWitnessMargin;
    prove_with(job_.radius - kProvenMargin);
    if (!mend(kMostStalled)) {
      if (job_.bare) return false;
      limit_ = job_.radius + kResidualLimit;
      prove_with(job_.radius + kResidual);
      if (!mend(kMendingRounds)) return false;
    }
    if (!all_legal()) return false;
    drop_needless_vertices(paths_, job_, proven_);
    return true;
  }

  void prove_with(double radius) {
    if (proven_ == radius) return;
    proven_ = radius;
    auto rings = std::make_shared<Cover>(paths_.fixed, radius);
    rings->keep_rim(job_.matters);
    by_rings_ = std::move(rings);
  }

  double residual() const { return std::max(0.0, proven_ - job_.radius); }

  bool mend(int most_stalled) {
    std::size_t before = std::numeric_limits<std::size_t>::max();
    int stalled = 0;
    for (int k = 0; k < kMendingRounds && stalled < most_stalled; ++k) {
      if (!paths_.bands.empty()) minimiser_.relax(k < kSettlingRounds ? kSettling : kMending, limit_);
      const Cover now = cover();
      const auto left = now.holes(job_.matters);
      if (left.empty()) return true;
      if (paths_.bands.empty()) return false;
      if (left.size() > kStalledAbove && 5 * left.size() > 4 * before) ++stalled;
      before = left.size();
      add_witnesses(left, now);
      if (left.size() <= kFewHoles) {
        for (const Vec2 p : left) paths_.witnesses.push_back({p});
      }
      respace();
      paths_.list();
    }
    return false;
  }

  void seed_witnesses() {
    const Cover& by_rings = *by_rings_;
    const double spacing = job_.radius * kSeedSpacing;
    bool odd = false;
    for (double y = job_.where.min.y; y <= job_.where.max.y; y += spacing * 0.866, odd = !odd) {
      for (double x = job_.where.min.x + (odd ? spacing / 2 : 0); x <= job_.where.max.x; x += spacing) {
        const Vec2 p{x, y};
        if (!by_rings.holds(p) && job_.matters(p)) paths_.witnesses.push_back({p});
      }
    }
    for (const Vec2 p : by_rings.holes(job_.matters)) paths_.witnesses.push_back({p});
  }

  /// Sets moving witnesses on both sides of every band, at the border of its swept area with that of others.
  void seed_seams() {
    for (const auto& band : paths_.bands) {
      const Vec2 a = paths_.at(band.a), b = paths_.at(band.b);
      if (distance(a, b) < 1e-6) continue;
      const Vec2 n = left_of(unit(b - a)) * limit_;
      for (const Vec2 p : {lerp(a, b, 0.5) + n, lerp(a, b, 0.5) - n}) {
        if (job_.matters(p)) paths_.witnesses.push_back({p, true});
      }
    }
  }

  /// Sets one witness in the middle of every hole, because the rim is already at the limit.
  void add_witnesses(const std::vector<Vec2>& rim, const Cover& now) {
    if (rim.empty()) return;
    BoxIndex by_place(kHoleSize * job_.radius), by_witness(kHoleSize * job_.radius);
    for (std::uint32_t i = 0; i < rim.size(); ++i) by_place.add({rim[i], rim[i]}, i);
    std::vector<Vec2> added;
    std::vector<double> reach;  // mm; vertices this near to an added one are in its hole
    for (const Vec2 start : rim) {
      const auto holes_near = by_witness.near({start, start});
      if (std::any_of(holes_near.begin(), holes_near.end(),
                      [&](std::uint32_t i) { return distance(added[i], start) < reach[i]; }))
        continue;
      double size = 0;
      Vec2 p = across_hole(start, rim, by_place, now, size);
      if (size == 0) {
        p = deepest_near(start, now);
        size = distance(p, start);
      }
      reach.push_back(std::max(1e-4, kSameHole * size));
      by_witness.add(Box{p, p}.grown(reach.back()), static_cast<std::uint32_t>(added.size()));
      added.push_back(p);
      paths_.witnesses.push_back({p, true});
      if (size < 1e-3) paths_.witnesses.push_back({p, false});
    }
  }

  /// The middle between a rim vertex and the farthest other one in the same hole; `size` is 0 if there is
  /// none.
  Vec2 across_hole(Vec2 start, const std::vector<Vec2>& rim, const BoxIndex& by_place, const Cover& now,
                   double& size) const {
    const auto open = [&](Vec2 a, Vec2 b) {
      return !now.holds(lerp(a, b, 0.5)) && !now.holds(lerp(a, b, 0.25)) && !now.holds(lerp(a, b, 0.75));
    };
    Vec2 middle = start;
    for (const std::uint32_t i : by_place.near(Box{start, start}.grown(kHoleSize * job_.radius))) {
      const double d = std::sqrt(norm_squared(rim[i] - start));
      if (d <= size || !open(rim[i], start)) continue;
      size = d;
      middle = lerp(rim[i], start, 0.5);
    }
    return middle;
  }

  static std::array<Vec2, 8> directions_round() {
    std::array<Vec2, 8> directions;
    for (int k = 0; k < 8; ++k) directions[static_cast<std::size_t>(k)] = direction_of(k * kPi / 4);
    return directions;
  }

  /// Moves from p, by shorter and shorter steps, to the place farthest from all bands.
  Vec2 deepest_near(Vec2 p, const Cover& now) const {
    static const std::array<Vec2, 8> directions = directions_round();
    double depth = now.distance_to(p);
    for (double step = 0.05 * job_.radius; step > 1e-3 * job_.radius;) {
      Vec2 best = p;
      for (const Vec2 direction : directions) {
        const Vec2 q = p + direction * step;
        const auto d = now.distance_above(depth, q);
        if (d && *d < 2 * job_.radius && job_.matters(q)) {
          depth = *d;
          best = q;
        }
      }
      if (best == p) step /= 4;
      p = best;
    }
    return p;
  }

  Cover cover() const {
    std::vector<Edge> edges;
    for (const auto& band : paths_.bands) {
      if (paths_.at(band.a) != paths_.at(band.b))
        edges.push_back(Edge::line(paths_.at(band.a), paths_.at(band.b)));
    }
    return Cover(edges, by_rings_);
  }

  /// Splits long bands and drops vertices too close together.
  void respace() {
    const double spacing = kBandSpacing * job_.radius;
    paths_.moved += kCrowded * spacing;
    paths_.for_paths([&](std::vector<int>& path) {
      std::vector<int> even;
      for (std::size_t i = 0; i < path.size(); ++i) {
        const bool inner = i > 0 && i + 1 < path.size();
        if (inner &&
            crowded(paths_.point(even.back()), paths_.point(path[i]), paths_.point(path[i + 1]), spacing))
          continue;
        if (i > 0) split(even.back(), path[i], spacing, even);
        even.push_back(path[i]);
      }
      path = std::move(even);
    });
  }

  static bool crowded(Vec2 before, Vec2 p, Vec2 after, double spacing) {
    const double reach = distance(before, p) + distance(p, after);
    if (reach < kCrowded * spacing) return true;
    return reach < spacing && reach - distance(before, after) < 0.002 * spacing;
  }

  void split(int from, int to, double spacing, std::vector<int>& path) {
    const Vec2 a = paths_.point(from), b = paths_.point(to);
    const int parts = static_cast<int>(distance(a, b) / spacing + 0.7);
    for (int k = 1; k < parts; ++k) {
      path.push_back(static_cast<int>(paths_.skeleton.points.size()));
      paths_.skeleton.points.push_back({lerp(a, b, static_cast<double>(k) / parts), -1});
    }
  }

  bool all_legal() const {
    return std::all_of(paths_.bands.begin(), paths_.bands.end(), [&](const Band& band) {
      return job_.legal->holds_line(paths_.at(band.a), paths_.at(band.b));
    });
  }

  Bands paths_;
  TightenJob job_;
  BandMinimiser minimiser_;
  double limit_;       ///< mm; witnesses pull bands farther away than this
  double proven_ = 0;  ///< mm; radius of the exact check
  std::shared_ptr<const Cover> by_rings_;
  int round_ = 0;
};

Tightener::Tightener(Skeleton skeleton, TightenJob job)
    : impl_(std::make_unique<Impl>(std::move(skeleton), std::move(job))) {}
Tightener::~Tightener() = default;
Tightener::Tightener(Tightener&&) noexcept = default;
Tightener& Tightener::operator=(Tightener&&) noexcept = default;

void Tightener::pull(int rounds) {
  impl_->pull(rounds);
}

bool Tightener::finish() {
  return impl_->finish();
}

double Tightener::residual() const {
  return impl_->residual();
}

const Skeleton& Tightener::skeleton() const {
  return impl_->paths_.skeleton;
}

namespace {

/// mm. A place counts as cleared by a vertex if it is this much nearer than the radius; places on the margin of being
/// cleared by other edges are left to the exact search.
constexpr double kWithin = 1e-6;

/// Drops vertices of one path after the other, each from its first vertex to its last.
class Polish {
 public:
  Polish(Bands& paths, const TightenJob& job, double radius) : paths_(paths), job_(job), radius_(radius) {}

  void run() {
    EdgesInUse state(2 * job_.radius);
    for (const auto& edge : paths_.fixed) state.add(edge);
    std::vector<std::uint32_t> first_edges;
    paths_.for_paths([&](const std::vector<int>& path) {
      first_edges.push_back(static_cast<std::uint32_t>(state.edges.size()));
      for (std::size_t i = 1; i < path.size(); ++i)
        state.add(Edge::line(paths_.point(path[i - 1]), paths_.point(path[i])));
    });
    std::size_t next_path = 0;
    paths_.for_paths([&](std::vector<int>& path) { polish(path, first_edges[next_path++], state); });
    paths_.list();
  }

 private:
  /// All edges while vertices are dropped, flags of the edges in use, and an index of their places.
  struct EdgesInUse {
    explicit EdgesInUse(double cell) : index(cell) {}
    std::vector<Edge> edges;
    std::vector<char> used;
    BoxIndex index;

    std::uint32_t add(const Edge& edge) {
      const auto number = static_cast<std::uint32_t>(edges.size());
      edges.push_back(edge);
      used.push_back(edge.from == edge.to ? 0 : 1);
      index.add(edge.from == edge.to ? Box{edge.from, edge.to} : edge.box(), number);
      return number;
    }
  };

  /// `edge`: the number of the path's first edge; the others follow it.
  void polish(std::vector<int>& path, std::uint32_t edge, EdgesInUse& state) const {
    std::vector<int> kept;
    std::uint32_t arriving = edge;
    for (std::size_t i = 0; i < path.size(); ++i) {
      const std::uint32_t leaving = edge + static_cast<std::uint32_t>(i);
      if (i > 0 && i + 1 < path.size() && may_drop(arriving, leaving, state)) {
        state.used[arriving] = state.used[leaving] = 0;
        arriving = state.add(Edge::line(paths_.point(kept.back()), paths_.point(path[i + 1])));
      } else {
        kept.push_back(path[i]);
        arriving = leaving;
      }
    }
    path = std::move(kept);
  }

  /// Whether one straight edge in place of two successive ones clears everything cleared by them.
  bool may_drop(std::uint32_t arriving, std::uint32_t leaving, const EdgesInUse& state) const {
    const Edge first = state.edges[arriving], second = state.edges[leaving];
    if (first.from == first.to || second.from == second.to) return true;
    if (distance(first.from, second.to) < 1e-6 || !job_.legal->holds_line(first.from, second.to))
      return false;
    Box both = first.box();
    both.add(second.box());
    const Box near = both.grown(2 * radius_);
    std::vector<Edge> edges{Edge::line(first.from, second.to)};
    for (const std::uint32_t i : state.index.near(near)) {
      if (state.used[i] && i != arriving && i != leaving && near.overlaps(state.edges[i].box())) {
        edges.push_back(state.edges[i]);
      }
    }
    if (uncovers_outer_side(first, second, edges)) return false;
    const bool is_blunt = dot(first.to - first.from, second.to - second.from) > 0;
    if (is_blunt &&
        clear_outer_rim(first, second, edges, radius_, distance(edges.front(), first.to) + kAtRim))
      return true;
    const auto was_cut = [&](Vec2 q) {
      return (distance(first, q) <= radius_ || distance(second, q) <= radius_) && job_.matters(q);
    };
    const Box where = both.grown(radius_);
    return !Cover(edges, radius_, where).has_hole(where, was_cut);
  }

  /// Whether the place cleared by the vertex between two edges that is farthest from the replacing line is left by
  /// all of `edges`: decides most vertices, and is cheaper than a search for all holes.
  bool uncovers_outer_side(const Edge& first, const Edge& second, const std::vector<Edge>& edges) const {
    const Vec2 along = second.to - first.from, to_vertex = first.to - first.from;
    const double side = cross(along, to_vertex);
    const Vec2 outwards = left_of(unit(along)) * (side < 0 ? -1.0 : 1.0);
    const Vec2 place = first.to + outwards * (radius_ - kWithin);
    const double reach = radius_ + kWithin;
    return job_.matters(place) && std::none_of(edges.begin(), edges.end(), [&](const Edge& edge) {
             return norm_squared(place - nearest_point(edge, place)) <= reach * reach;
           });
  }

  Bands& paths_;
  const TightenJob& job_;
  double radius_;
};

}  // namespace

void drop_needless_vertices(Bands& paths, const TightenJob& job, double radius) {
  Polish(paths, job, radius).run();
}

}  // namespace clearcut::plan::contour
