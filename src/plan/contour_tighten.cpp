// Symbols of the minimisation (an augmented Lagrangian with Newton steps):
//
//   v_i       vertices of the ways                       unknown
//   w         witnesses: places that have to be cut      given, more after each exact check
//   d(w)      distance from w to the nearest band (straight piece between neighbouring vertices)
//   lambda_w  force with which w holds its band          multiplier
//   rho       stiffness of that hold                     1 / mm
//
//   minimise  sum |v_i - v_(i+1)| + kEven / 2 sum |v_i - v_(i+1)|^2 / spacing   subject to   d(w) <= limit
//
// Along one way the Hessian couples neighbours only, so that a Newton step is one block-tridiagonal solve.
#include "plan/contour_tighten.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/units.h"
#include "plan/contour_cover.h"
#include "plan/contour_index.h"

namespace clearcut {
namespace {

/// mm. How much less than the radius the witnesses' limit is while ways are pulled, and at the end.
constexpr double kPullMargin = 0.0005;
constexpr double kWitnessMargin = 0.004;
/// mm. How much less than the radius the exact check runs with: above the rounding of any program text.
constexpr double kProvenMargin = 0.001;
/// Radii with which the check runs in the first rounds, where only large holes count, and how many rounds that are.
constexpr double kFirstLook = 1.01;
constexpr int kRoughRounds = 3;
/// mm. Where strokes fit exactly side by side nothing is left for margins: there the limit and the radius of
/// the check are this much more than the radius.
constexpr double kFilmLimit = 0.0012;
constexpr double kFilm = 0.0035;
/// Spacing of vertices, as a share of the radius.
constexpr double kSpacing = 0.6;
/// Spacing of the witnesses at the beginning, as a share of the radius.
constexpr double kSeedSpacing = 1.0;
/// Vertices that lie nearer to both their neighbours are dropped, in shares of the spacing.
constexpr double kCrowded = 0.3;
/// Holes are taken to be at most this large, as a share of the radius; larger ones count as several.
constexpr double kHoleSize = 2.0;
/// Rim vertices this near to the middle of a hole, in shares of its size, belong to it.
constexpr double kSameHole = 0.6;
/// Weight of the springs that keep vertices evenly spaced.
constexpr double kEven = 0.02;
/// Share of the radius below which lengths are smoothed, so that vertices may meet.
constexpr double kSoft = 0.01;
/// Damping of the Newton step, 1 / radius.
constexpr double kDamping = 0.02;
/// Rounds after the last pull in which the exact check has to find nothing left; with tension in the first of
/// them.
constexpr int kSettlingRounds = 4;
constexpr int kMendingRounds = 14;
/// Rounds that close fewer than a fifth of many holes show that there is no room to close them.
constexpr int kMostStalled = 2;
constexpr std::size_t kStalledAbove = 20;
/// So few are closed from all their corners: long thin ones would shrink by a share a round only.
constexpr std::size_t kFewHoles = 20;

/// How one round of Newton steps goes.
struct Pull {
  int steps = 0;
  double reach = 0;       ///< longest first step, shares of the radius
  double last_reach = 0;  ///< longest last step, as a share of the first
  double soft = 0;        ///< stiffness of the first step, 1 / radius
  double tension = 1;     ///< force of the bands
};
constexpr Pull kFirstPull{22, 0.3, 0.03, 2};
constexpr Pull kLaterPull{10, 0.1, 0.03, 100};
constexpr Pull kSettling{10, 0.02, 0.2, 2000};
/// Without tension nothing slides away while the last holes are closed.
constexpr Pull kMending{10, 0.02, 0.5, 2e4, 0};
/// Stiffness of every last step, 1 / radius.
constexpr double kStiffest = 2e4;

struct Band {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
};

/// A symmetric 2 x 2 matrix.
struct Sym2 {
  double xx = 0, xy = 0, yy = 0;
  Sym2& operator+=(const Sym2& o) {
    xx += o.xx;
    xy += o.xy;
    yy += o.yy;
    return *this;
  }
  friend Sym2 operator*(const Sym2& m, double k) { return {m.xx * k, m.xy * k, m.yy * k}; }
  friend Vec2 operator*(const Sym2& m, Vec2 v) { return {m.xx * v.x + m.xy * v.y, m.xy * v.x + m.yy * v.y}; }
  Sym2 inverse() const {
    const double det = xx * yy - xy * xy;
    return {yy / det, -xy / det, xx / det};
  }
  /// this * inner * this
  Sym2 around(const Sym2& inner) const {
    const Vec2 c0 = inner * Vec2{xx, xy}, c1 = inner * Vec2{xy, yy};
    return {xx * c0.x + xy * c0.y, xx * c1.x + xy * c1.y, xy * c1.x + yy * c1.y};
  }
};

Sym2 outer_product(Vec2 u) {
  return {u.x * u.x, u.x * u.y, u.y * u.y};
}

Vec2 nearest_on_ring(const Path& ring, Vec2 p, Vec2* tangent = nullptr) {
  Vec2 best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (const auto& edge : ring) {
    const auto on = nearest(edge, p);
    if (on.distance >= best_distance) continue;
    best_distance = on.distance;
    best = on.point;
    if (tangent) *tangent = edge.tangent_at(on.t);
  }
  return best;
}

struct Witness {
  Vec2 p;
  bool moving = false;  ///< keeps to the middle between the bands on both sides of it
  double near =
      1e300;  ///< distance of the nearest band when last looked at, and how far bands had moved by then
  double when = 0;
};

/// A band as it lies now, ready for questions.
struct Segment {
  Vec2 a;
  Vec2 d;
  double inverse = 0;  ///< 1 / squared length; 0 for none
};

/// A witness near the limit with the bands that may hold it while nothing moves farther than the skin.
struct Active {
  std::uint32_t witness = 0;
  std::uint32_t first = 0;
  std::uint32_t end = 0;
};

}  // namespace

struct Tightener::Impl {
  Impl(Skeleton skeleton, TightenJob job)
      : skeleton_(std::move(skeleton)), job_(std::move(job)), limit_(job_.radius - kPullMargin) {
    for (const auto& ring : skeleton_.rings) fixed_.insert(fixed_.end(), ring.begin(), ring.end());
    prove_with(kFirstLook * job_.radius);
    respace();
    list_bands();
    if (bands_.empty()) return;
    make_grid();
    seed_witnesses();
    seed_seams();
  }

  void pull(int rounds) {
    if (round_ >= kRoughRounds) prove_with(job_.radius - kProvenMargin);
    for (int k = 0; k < rounds && !bands_.empty(); ++k) {
      relax(round_++ == 0 ? kFirstPull : kLaterPull);
      const Cover now = cover();
      add_witnesses(now.holes(job_.matters), now);
      respace();
      list_bands();
    }
  }

  bool finish() {
    // Still witnesses have done their work by now and would quarrel with the moving ones.
    std::erase_if(witnesses_, [](const Witness& w) { return !w.moving; });
    limit_ = job_.radius - kWitnessMargin;
    prove_with(job_.radius - kProvenMargin);
    if (!mend(kMostStalled)) {
      if (job_.bare) return false;
      limit_ = job_.radius + kFilmLimit;
      prove_with(job_.radius + kFilm);
      if (!mend(kMendingRounds)) return false;
    }
    if (!all_legal()) return false;
    polish();
    return true;
  }

  void prove_with(double radius) {
    if (proven_ == radius) return;
    proven_ = radius;
    auto rings = std::make_shared<Cover>(fixed_, radius);
    rings->keep_rim(job_.matters);
    by_rings_ = std::move(rings);
  }

  double film() const { return std::max(0.0, proven_ - job_.radius); }

  bool mend(int most_stalled) {
    std::size_t before = std::numeric_limits<std::size_t>::max();
    int stalled = 0;
    for (int k = 0; k < kMendingRounds && stalled < most_stalled; ++k) {
      if (!bands_.empty()) relax(k < kSettlingRounds ? kSettling : kMending);
      const Cover now = cover();
      const auto left = now.holes(job_.matters);
      if (left.empty()) return true;
      if (bands_.empty()) return false;
      if (left.size() > kStalledAbove && 5 * left.size() > 4 * before) ++stalled;
      before = left.size();
      add_witnesses(left, now);
      if (left.size() <= kFewHoles) {
        for (const Vec2 p : left) witnesses_.push_back({p});
      }
      respace();
      list_bands();
    }
    return false;
  }

  Vec2& at(std::uint32_t i) { return skeleton_.points[i].at; }
  Vec2 at(std::uint32_t i) const { return skeleton_.points[i].at; }
  Vec2 point(int i) const { return skeleton_.points[static_cast<std::size_t>(i)].at; }
  bool on_ring(std::uint32_t i) const { return skeleton_.points[i].ring >= 0; }

  // --- witnesses

  void seed_witnesses() {
    const Cover& by_rings = *by_rings_;
    const double spacing = job_.radius * kSeedSpacing;
    bool odd = false;
    for (double y = job_.where.min.y; y <= job_.where.max.y; y += spacing * 0.866, odd = !odd) {
      for (double x = job_.where.min.x + (odd ? spacing / 2 : 0); x <= job_.where.max.x; x += spacing) {
        const Vec2 p{x, y};
        if (!by_rings.holds(p) && job_.matters(p)) witnesses_.push_back({p});
      }
    }
    for (const Vec2 p : by_rings.holes(job_.matters)) witnesses_.push_back({p});
  }

  /// Moving witnesses beside every band: they follow the seam between it and what runs there.
  void seed_seams() {
    for (const auto& band : bands_) {
      const Vec2 a = at(band.a), b = at(band.b);
      if (distance(a, b) < 1e-6) continue;
      const Vec2 n = left_of(unit(b - a)) * limit_;
      for (const Vec2 p : {lerp(a, b, 0.5) + n, lerp(a, b, 0.5) - n}) {
        if (job_.matters(p)) witnesses_.push_back({p, true});
      }
    }
  }

  /// One witness in the depth of every hole: its rim is as near as can be to the limit.
  void add_witnesses(const std::vector<Vec2>& rim, const Cover& now) {
    if (rim.empty()) return;
    BoxIndex by_place(kHoleSize * job_.radius), by_witness(kHoleSize * job_.radius);
    for (std::uint32_t i = 0; i < rim.size(); ++i) by_place.add({rim[i], rim[i]}, i);
    std::vector<Vec2> added;
    std::vector<double> reach;  // of the holes that the added ones stand in
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
      witnesses_.push_back({p, true});
      if (size < 1e-3) witnesses_.push_back({p, false});
    }
  }

  /// The middle between a rim vertex and the farthest other one that sees it across the hole; size 0 if there
  /// is none.
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

  /// Climbs from p to where the bands are farthest, by shorter and shorter steps.
  Vec2 deepest_near(Vec2 p, const Cover& now) const {
    double depth = now.distance_to(p);
    for (double step = 0.05 * job_.radius; step > 1e-3 * job_.radius;) {
      Vec2 best = p;
      for (int k = 0; k < 8; ++k) {
        const Vec2 q = p + direction_of(k * kPi / 4) * step;
        const double d = now.distance_to(q);
        if (d > depth && d < 2 * job_.radius && job_.matters(q)) {
          depth = d;
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
    for (const auto& band : bands_) {
      if (at(band.a) != at(band.b)) edges.push_back(Edge::line(at(band.a), at(band.b)));
    }
    return Cover(edges, by_rings_);
  }

  // --- bands

  template <typename F>
  void for_ways(F&& f) {
    for (auto& leg : skeleton_.legs) {
      f(leg.way_in);
      for (auto& way : leg.detours) f(way);
    }
  }

  void list_bands() {
    bands_.clear();
    for_ways([&](const std::vector<int>& way) {
      for (std::size_t i = 1; i < way.size(); ++i) {
        bands_.push_back({static_cast<std::uint32_t>(way[i - 1]), static_cast<std::uint32_t>(way[i])});
      }
    });
  }

  /// Splits long bands and drops vertices that crowd.
  void respace() {
    const double spacing = kSpacing * job_.radius;
    moved_ += kCrowded * spacing;
    for_ways([&](std::vector<int>& way) {
      std::vector<int> even;
      for (std::size_t i = 0; i < way.size(); ++i) {
        const bool inner = i > 0 && i + 1 < way.size();
        if (inner && crowded(point(even.back()), point(way[i]), point(way[i + 1]), spacing)) continue;
        if (i > 0) split(even.back(), way[i], spacing, even);
        even.push_back(way[i]);
      }
      way = std::move(even);
    });
  }

  static bool crowded(Vec2 before, Vec2 p, Vec2 after, double spacing) {
    const double reach = distance(before, p) + distance(p, after);
    if (reach < kCrowded * spacing) return true;
    return reach < spacing && reach - distance(before, after) < 0.002 * spacing;
  }

  void split(int from, int to, double spacing, std::vector<int>& way) {
    const Vec2 a = point(from), b = point(to);
    const int parts = static_cast<int>(distance(a, b) / spacing + 0.7);
    for (int k = 1; k < parts; ++k) {
      way.push_back(static_cast<int>(skeleton_.points.size()));
      skeleton_.points.push_back({lerp(a, b, static_cast<double>(k) / parts), -1});
    }
  }

  bool all_legal() const {
    return std::all_of(bands_.begin(), bands_.end(),
                       [&](const Band& band) { return job_.legal->holds_line(at(band.a), at(band.b)); });
  }

  // --- polish

  /// All edges while vertices are dropped: those in use, and where they lie.
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

  /// Drops every vertex that coverage can do without: fewer corners, shorter way.
  void polish() {
    EdgesInUse state(2 * job_.radius);
    for (const auto& edge : fixed_) state.add(edge);
    std::vector<std::uint32_t> first_edges;
    for_ways([&](const std::vector<int>& way) {
      first_edges.push_back(static_cast<std::uint32_t>(state.edges.size()));
      for (std::size_t i = 1; i < way.size(); ++i) state.add(Edge::line(point(way[i - 1]), point(way[i])));
    });
    std::size_t next_way = 0;
    for_ways([&](std::vector<int>& way) { polish(way, first_edges[next_way++], state); });
    list_bands();
  }

  /// `edge` is the number of the way's first edge; the others follow it.
  void polish(std::vector<int>& way, std::uint32_t edge, EdgesInUse& state) const {
    std::vector<int> kept;
    std::uint32_t arriving = edge;
    for (std::size_t i = 0; i < way.size(); ++i) {
      const std::uint32_t leaving = edge + static_cast<std::uint32_t>(i);
      if (i > 0 && i + 1 < way.size() && may_drop(arriving, leaving, state)) {
        state.used[arriving] = state.used[leaving] = 0;
        arriving = state.add(Edge::line(point(kept.back()), point(way[i + 1])));
      } else {
        kept.push_back(way[i]);
        arriving = leaving;
      }
    }
    way = std::move(kept);
  }

  /// Whether one straight edge in place of two neighbouring ones still clears all that they clear.
  bool may_drop(std::uint32_t arriving, std::uint32_t leaving, const EdgesInUse& state) const {
    const Edge first = state.edges[arriving], second = state.edges[leaving];
    if (first.from == first.to || second.from == second.to) return true;
    if (distance(first.from, second.to) < 1e-6 || !job_.legal->holds_line(first.from, second.to))
      return false;
    Box both = first.box();
    both.add(second.box());
    const Box near = both.grown(2 * proven_);
    std::vector<Edge> edges{Edge::line(first.from, second.to)};
    for (const std::uint32_t i : state.index.near(near)) {
      if (state.used[i] && i != arriving && i != leaving && near.overlaps(state.edges[i].box())) {
        edges.push_back(state.edges[i]);
      }
    }
    const auto was_cut = [&](Vec2 q) {
      return (distance(first, q) <= proven_ || distance(second, q) <= proven_) && job_.matters(q);
    };
    return !Cover(edges, proven_).has_hole(both.grown(proven_), was_cut);
  }

  // --- minimisation

  /// Newton steps, at first wide and soft, at last small and stiff.
  void relax(const Pull& pull) {
    skin_ = 0.1 * job_.radius;
    moved_since_listing_ = std::numeric_limits<double>::infinity();
    for (int i = 0; i < pull.steps; ++i) {
      const double share = static_cast<double>(i) / pull.steps;
      tension_ = pull.tension;
      stiffness_ = pull.soft / job_.radius * std::pow(kStiffest / pull.soft, share);
      step(pull.reach * job_.radius * std::pow(pull.last_reach, share));
    }
  }

  void step(double reach) {
    if (moved_since_listing_ > skin_) list_active();
    before_.resize(skeleton_.points.size());
    for (std::size_t i = 0; i < before_.size(); ++i) before_[i] = skeleton_.points[i].at;
    assemble();
    for_ways([&](const std::vector<int>& way) { solve(way); });
    const double longest = longest_move();
    for (std::size_t i = 0; i < before_.size(); ++i) {
      // Each for itself: one that is thrown far must not hold up all others.
      const double far = norm(move_[i]);
      skeleton_.points[i].at = before_[i] + move_[i] * (far > reach ? reach / far : 1);
    }
    slide();
    undo_illegal();
    moved_since_listing_ += std::min(longest, reach);
    moved_ += std::min(longest, reach);
  }

  double longest_move() const {
    double most = 0;
    for (const Vec2 m : move_) most = std::max(most, norm_squared(m));
    return std::sqrt(most);
  }

  /// Gradient and Hessian of the augmented Lagrangian, per vertex and per band.
  void assemble() {
    gradient_.assign(skeleton_.points.size(), {});
    diagonal_.assign(skeleton_.points.size(), {kDamping / job_.radius, 0, kDamping / job_.radius});
    coupling_.assign(bands_.size(), {});
    move_.assign(skeleton_.points.size(), {});
    measure_bands();
    for (std::uint32_t i = 0; i < bands_.size(); ++i) add_pull(i);
    for (const auto& active : active_) add_hold(active);
    if (job_.turn_cost * tension_ > 0) for_ways([&](const std::vector<int>& way) { add_turns(way); });
  }

  void add_pull(std::uint32_t i) {
    const Band band = bands_[i];
    const Vec2 d = at(band.b) - at(band.a);
    const double soft = kSoft * job_.radius, spring = kEven / (kSpacing * job_.radius);
    const double l = std::sqrt(norm_squared(d) + soft * soft);
    const Vec2 u = d / l, g = (u + d * spring) * tension_;
    Sym2 h = Sym2{(1 - u.x * u.x) / l + spring, -u.x * u.y / l, (1 - u.y * u.y) / l + spring} * tension_;
    gradient_[band.a] = gradient_[band.a] - g;
    gradient_[band.b] = gradient_[band.b] + g;
    diagonal_[band.a] += h;
    diagonal_[band.b] += h;
    coupling_[i] += h * -1;
  }

  /// turn_cost * (1 - cosine of the turn) at every vertex, with a bound of its curvature in place of the
  /// Hessian.
  void add_turns(const std::vector<int>& way) {
    for (std::size_t i = 1; i + 1 < way.size(); ++i) {
      const auto before = static_cast<std::uint32_t>(way[i - 1]), here = static_cast<std::uint32_t>(way[i]);
      const auto after = static_cast<std::uint32_t>(way[i + 1]);
      const Vec2 d1 = at(here) - at(before), d2 = at(after) - at(here);
      const double least = 0.1 * kSpacing * job_.radius;
      const double l1 = std::max(least, std::sqrt(norm_squared(d1))),
                   l2 = std::max(least, std::sqrt(norm_squared(d2)));
      const Vec2 u1 = d1 / l1, u2 = d2 / l2;
      const double c = dot(u1, u2);
      const Vec2 g1 = (u2 - u1 * c) * (job_.turn_cost / l1), g2 = (u2 * c - u1) * (job_.turn_cost / l2);
      gradient_[before] = gradient_[before] + g1;
      gradient_[after] = gradient_[after] + g2;
      gradient_[here] = gradient_[here] - g1 - g2;
      const double bound = 2 * job_.turn_cost * (1 / (l1 * l1) + 1 / (l2 * l2));
      for (const std::uint32_t v : {before, here, after}) diagonal_[v] += Sym2{bound, 0, bound};
    }
  }

  static constexpr std::uint32_t kFixed = std::numeric_limits<std::uint32_t>::max();

  /// The place of a band, or of a fixed edge, that is nearest to a witness.
  struct Hold {
    std::uint32_t band = kFixed;
    double t = 0;
    double distance = std::numeric_limits<double>::infinity();
    Vec2 away;  ///< unit, from there to the witness
  };

  void add_hold(const Active& active) {
    Witness& witness = witnesses_[active.witness];
    const Hold hold = nearest_hold(active, witness.p);
    if (hold.distance < limit_ - skin_) return;
    if (!witness.moving) return hold_band(hold, 1.0);
    const Hold other = opposite_hold(active, witness.p, hold);
    if (!std::isfinite(other.distance)) return hold_band(hold, 1.0);
    // To where both are equally far: along n1 - n2, in which direction each distance changes at the same
    // rate.
    const double rate = 1 - dot(hold.away, other.away);
    const double gap = other.distance - hold.distance;
    const double step = std::min(gap, 0.2 * job_.radius);
    witness.p = witness.p + (hold.away - other.away) * (0.5 * step / rate);
    const double half = (hold.distance + other.distance) / 2;
    for (Hold h : {hold, other}) {
      h.distance = half;
      hold_band(h, 0.5);
    }
  }

  /// Adds the force with which a witness at `hold.distance` holds a band; `share` is how far the distance
  /// changes with the band.
  void hold_band(const Hold& hold, double share) {
    const double force = stiffness_ * (hold.distance - limit_) * share;
    if (force <= 0 || hold.distance < 1e-9 || hold.band == kFixed) return;
    const Band band = bands_[hold.band];
    const double bend = force / hold.distance;
    Sym2 h = outer_product(hold.away) * (stiffness_ * share - bend);
    h.xx += bend;
    h.yy += bend;
    const double s = 1 - hold.t, t = hold.t;
    gradient_[band.a] = gradient_[band.a] - hold.away * (force * s);
    gradient_[band.b] = gradient_[band.b] - hold.away * (force * t);
    diagonal_[band.a] += h * (s * s);
    diagonal_[band.b] += h * (t * t);
    coupling_[hold.band] += h * (s * t);
  }

  /// From the place of band `i` that is nearest to p, to p.
  Vec2 way_from_band(std::uint32_t i, Vec2 p, double& t) const {
    const Segment& band = segments_[i];
    const Vec2 s = p - band.a;
    t = std::clamp(dot(s, band.d) * band.inverse, 0.0, 1.0);
    return s - band.d * t;
  }

  static void finish(Hold& hold, Vec2 way) {
    hold.distance = std::sqrt(norm_squared(way));
    if (hold.distance > 0) hold.away = way / hold.distance;
  }

  Hold nearest_hold(const Active& active, Vec2 p) const {
    Hold best;
    Vec2 best_way;
    double nearest_squared = std::numeric_limits<double>::infinity(), t = 0;
    for (std::uint32_t k = active.first; k < active.end; ++k) {
      const Vec2 way = way_from_band(candidates_[k], p, t);
      const double squared = norm_squared(way);
      if (squared >= nearest_squared) continue;
      nearest_squared = squared;
      best_way = way;
      best.band = candidates_[k];
      best.t = t;
    }
    finish(best, best_way);
    return best;
  }

  /// The nearest hold on the other side of p, fixed edges included.
  Hold opposite_hold(const Active& active, Vec2 p, const Hold& nearest) const {
    Hold best;
    Vec2 best_way;
    double best_squared = std::numeric_limits<double>::infinity(), t = 0;
    const auto opposite = [&](Vec2 way, double squared) {
      const double c = dot(way, nearest.away);
      return squared < best_squared && (c <= 0 || c * c < 0.25 * squared);
    };
    for (std::uint32_t k = active.first; k < active.end; ++k) {
      const Vec2 way = way_from_band(candidates_[k], p, t);
      const double squared = norm_squared(way);
      if (!opposite(way, squared)) continue;
      best_squared = squared;
      best_way = way;
      best.band = candidates_[k];
      best.t = t;
    }
    for (const std::uint32_t i : fixed_in_.at(grid_.cell_of(p))) {
      const Vec2 way = p - nearest_point(fixed_[i], p);
      const double squared = norm_squared(way);
      if (squared <= 0 || !opposite(way, squared)) continue;
      best_squared = squared;
      best_way = way;
      best.band = kFixed;
    }
    if (std::isfinite(best_squared)) finish(best, best_way);
    return best;
  }

  /// Newton step of the free vertices of one way, by block elimination from its first to its last.
  void solve(const std::vector<int>& way) {
    const std::size_t n = way.size();
    if (n == 0) return;
    const std::size_t first_band = next_band_;
    next_band_ = first_band + n - 1 == bands_.size() ? 0 : first_band + n - 1;
    pivot_.resize(n);
    right_.resize(n);
    const auto vertex = [&](std::size_t i) { return static_cast<std::uint32_t>(way[i]); };
    for (std::size_t i = 0; i < n; ++i) {
      Sym2 d = diagonal_[vertex(i)];
      Vec2 r = -gradient_[vertex(i)];
      if (on_ring(vertex(i))) {
        d = kHeld;
        r = {};
      } else if (i > 0 && !on_ring(vertex(i - 1))) {
        const Sym2 c = coupling_[first_band + i - 1];
        const Sym2 reduced = c.around(pivot_[i - 1]);
        d += reduced * -1;
        r = r - c * (pivot_[i - 1] * right_[i - 1]);
      }
      pivot_[i] = d.inverse();
      right_[i] = r;
    }
    for (std::size_t i = n; i-- > 0;) {
      if (on_ring(vertex(i))) continue;
      Vec2 r = right_[i];
      if (i + 1 < n && !on_ring(vertex(i + 1))) r = r - coupling_[first_band + i] * move_[vertex(i + 1)];
      move_[vertex(i)] = pivot_[i] * r;
    }
    for (const std::size_t i : {std::size_t{0}, n - 1}) {
      if (on_ring(vertex(i))) move_[vertex(i)] = slide_step(vertex(i));
    }
  }

  Vec2 slide_step(std::uint32_t i) const {
    Vec2 tangent{1, 0};
    nearest_on_ring(skeleton_.rings[static_cast<std::size_t>(skeleton_.points[i].ring)], at(i), &tangent);
    return tangent * (-dot(gradient_[i], tangent) / dot(tangent, diagonal_[i] * tangent));
  }

  void slide() {
    for (auto& vertex : skeleton_.points) {
      if (vertex.ring < 0) continue;
      vertex.at = nearest_on_ring(skeleton_.rings[static_cast<std::size_t>(vertex.ring)], vertex.at);
    }
  }

  /// Bands that have left the legal area go back to where they were.
  void undo_illegal() {
    for (std::size_t i = 0; i < bands_.size(); ++i) {
      const Band band = bands_[i];
      if (safe_[i] || (at(band.a) == before_[band.a] && at(band.b) == before_[band.b])) continue;
      if (job_.legal->holds_line(at(band.a), at(band.b))) continue;
      at(band.a) = before_[band.a];
      at(band.b) = before_[band.b];
    }
  }

  // --- which witnesses count

  void measure_bands() {
    segments_.resize(bands_.size());
    for (std::size_t i = 0; i < bands_.size(); ++i) {
      const Vec2 a = at(bands_[i].a), d = at(bands_[i].b) - a;
      const double whole = norm_squared(d);
      segments_[i] = {a, d, whole > 0 ? 1 / whole : 0};
    }
  }

  /// Witnesses near the limit. Those well inside sleep until bands may have moved away from them.
  void list_active() {
    active_.clear();
    candidates_.clear();
    const double far = limit_ + 2 * skin_, near = limit_ - 2 * skin_;
    measure_bands();
    sort_bands_into_grid(far);
    for (std::uint32_t w = 0; w < witnesses_.size(); ++w) {
      Witness& witness = witnesses_[w];
      if (witness.near + (moved_ - witness.when) < near) continue;
      const Vec2 p = witness.p;
      const auto first = static_cast<std::uint32_t>(candidates_.size());
      double nearest_squared = far * far, t = 0;
      for (const std::uint32_t band : bands_in_.at(grid_.cell_of(p))) {
        const double squared = norm_squared(way_from_band(band, p, t));
        if (squared > far * far) continue;
        candidates_.push_back(band);
        nearest_squared = std::min(nearest_squared, squared);
      }
      witness.near = std::sqrt(nearest_squared);
      witness.when = moved_;
      if (nearest_squared < near * near || (witness.moving && !job_.matters(p))) {
        candidates_.resize(first);
        continue;
      }
      if (candidates_.size() == first) candidates_.push_back(nearest_band(p));
      active_.push_back({w, first, static_cast<std::uint32_t>(candidates_.size())});
    }
    moved_since_listing_ = 0;
  }

  std::uint32_t nearest_band(Vec2 p) const {
    std::uint32_t best = 0;
    double best_distance = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < bands_.size(); ++i) {
      double t = 0;
      const double d = norm_squared(way_from_band(i, p, t));
      if (d >= best_distance) continue;
      best_distance = d;
      best = i;
    }
    return best;
  }

  void make_grid() {
    grid_ = CellGrid(job_.where, job_.radius);
    for (std::uint32_t i = 0; i < fixed_.size(); ++i) {
      grid_.for_cells(fixed_[i].box().grown(1.5 * job_.radius),
                      [&](std::size_t cell, Vec2) { fixed_in_.add(cell, i); });
    }
    fixed_in_.build(grid_.count());
  }

  void sort_bands_into_grid(double far) {
    safe_.assign(bands_.size(), 0);
    for (std::uint32_t i = 0; i < bands_.size(); ++i) {
      Box box;
      box.add(at(bands_[i].a));
      box.add(at(bands_[i].b));
      grid_.for_cells(box.grown(far), [&](std::size_t cell, Vec2) { bands_in_.add(cell, i); });
      safe_[i] = job_.legal->surely_holds(box.grown(2 * skin_));
    }
    bands_in_.build(grid_.count());
  }

  static constexpr Sym2 kHeld{1, 0, 1};
  /// Pulls are unit forces: more than this only builds up where witnesses contradict each other.
  static constexpr double kMostForce = 20;

  Skeleton skeleton_;
  TightenJob job_;
  double limit_;       ///< distance at which witnesses begin to hold
  double proven_ = 0;  ///< radius of the exact check
  std::shared_ptr<const Cover> by_rings_;
  double skin_ = 0;
  double stiffness_ = 0;
  double tension_ = 1;
  std::vector<Edge> fixed_;
  std::vector<Band> bands_;
  std::vector<Witness> witnesses_;
  std::vector<Active> active_;
  std::vector<std::uint32_t> candidates_;
  std::vector<Vec2> before_, gradient_, move_, right_;
  std::vector<Sym2> diagonal_, coupling_, pivot_;
  std::size_t next_band_ = 0;
  double moved_since_listing_ = 0;
  int round_ = 0;
  CellGrid grid_;
  CellLists bands_in_, fixed_in_;
  std::vector<Segment> segments_;
  double moved_ = 0;        ///< mm; no band has moved farther since the beginning
  std::vector<char> safe_;  ///< of each band: it cannot leave the legal area before the next listing
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

double Tightener::film() const {
  return impl_->film();
}

const Skeleton& Tightener::skeleton() const {
  return impl_->skeleton_;
}

}  // namespace clearcut
