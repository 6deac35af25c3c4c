// Symbols of the minimisation (an augmented Lagrangian with Newton steps):
//
//   v_i       vertices of the paths                       unknown
//   w         witnesses: points that must be cleared     given, more after each exact check
//   d(w)      distance from w to the nearest band (straight piece between neighbouring vertices)
//   lambda_w  force with which w holds its band          multiplier
//   rho       stiffness of this force                    1 / mm
//
//   minimise  sum |v_i - v_(i+1)| + kEven / 2 sum |v_i - v_(i+1)|^2 / spacing   subject to   d(w) <= limit
//
// Along one path the Hessian couples successive vertices only, so that a Newton step is one block-tridiagonal
// solve.
#include "plan/contour/skeleton/minimise.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/elementary.h"
#include "geometry/spatial/box_tree.h"
#include "geometry/spatial/cell_grid.h"

namespace clearcut::plan::contour {
namespace {

/// Weight of the springs keeping vertices evenly spaced.
constexpr double kEven = 0.02;
/// Share of the radius. Lengths below this are smoothed, so that vertices may meet.
constexpr double kSoft = 0.01;
/// Damping of the Newton step, 1 / radius.
constexpr double kDamping = 0.02;
/// Stiffness of the witnesses in the last step, 1 / radius.
constexpr double kStiffest = 2e4;

/// Far above the rounding of a squared distance, as a share of it.
constexpr double kRounding = 1e-12;

/// mm. Boxes of arcs are greater by this, far above their rounding.
constexpr double kBoxRounding = 1e-9;

/// mm^2; from p to the nearest point of a box.
double squared_distance(const Box& box, Vec2 p) {
  return norm_squared(
      {std::max({box.min.x - p.x, 0.0, p.x - box.max.x}), std::max({box.min.y - p.y, 0.0, p.y - box.max.y})});
}

}  // namespace

struct BandMinimiser::Impl {
  /// An unchanged ring with the boxes of its edges: wall rings have thousands of edges, and the ends of paths slide along them
  /// in every step.
  class RingIndex {
   public:
    explicit RingIndex(const Path& ring) : ring_(&ring) {
      tree_.build(static_cast<std::uint32_t>(ring.size()),
                  [&](std::uint32_t i) { return ring[i].box().grown(kBoxRounding); });
    }

    /// The point of the ring nearest to p, and optionally the direction of the ring there.
    Vec2 nearest_to(Vec2 p, Vec2* tangent = nullptr) const {
      const Edge& edge = (*ring_)[tree_.nearest(p, [&](std::uint32_t i) {
        const Edge& one = (*ring_)[i];
        const double d = one.is_arc() ? distance(one, p) : nearest(one, p).distance;
        return d * d;
      })];
      const Nearest on = nearest(edge, p);
      if (tangent) *tangent = edge.tangent_at(on.t);
      return on.point;
    }

   private:
    const Path* ring_;
    BoxTree tree_;
  };

  /// A band at its current place, with precomputed values for distances to it.
  struct Segment {
    Vec2 a;
    Vec2 d;
    double inverse = 0;  ///< 1 / squared length, 1 / mm^2; 0 for a length of zero
  };

  /// A witness near the limit, and its part of the list of bands that may become its nearest one before the next
  /// listing.
  struct Active {
    std::uint32_t witness = 0;
    std::uint32_t first = 0;
    std::uint32_t end = 0;
    std::uint32_t nearest = 0;  ///< the nearest band at the listing
  };

  Impl(Bands& paths, const TightenJob& job) : paths_(paths), job_(job), grid_(job.where, job.radius) {
    for (std::uint32_t i = 0; i < paths_.fixed.size(); ++i) {
      const Box box = paths_.fixed[i].box();
      boxes_of_fixed_.push_back(box.grown(kBoxRounding));
      grid_.for_cells(box.grown(1.5 * job_.radius), [&](std::size_t cell, Vec2) { fixed_in_.add(cell, i); });
    }
    fixed_in_.build(grid_.count());
    rings_.reserve(paths_.skeleton.rings.size());
    for (const Path& ring : paths_.skeleton.rings) rings_.emplace_back(ring);
  }

  /// See BandMinimiser::relax.
  void relax(const Pull& pull, double limit) {
    limit_ = limit;
    skin_ = 0.1 * job_.radius;
    moved_since_listing_ = std::numeric_limits<double>::infinity();
    for (int i = 0; i < pull.steps; ++i) {
      const double share = static_cast<double>(i) / pull.steps;
      tension_ = pull.tension;
      stiffness_ = pull.soft / job_.radius * base::pow(kStiffest / pull.soft, share);
      step(pull.reach * job_.radius * base::pow(pull.last_reach, share));
    }
  }

  void step(double reach) {
    if (moved_since_listing_ > skin_) list_active();
    before_.resize(paths_.skeleton.points.size());
    for (std::size_t i = 0; i < before_.size(); ++i) before_[i] = paths_.skeleton.points[i].at;
    assemble();
    paths_.for_paths([&](const std::vector<int>& path) { solve(path); });
    const double longest = longest_move();
    for (std::size_t i = 0; i < before_.size(); ++i) {
      // Each move is limited on its own, so that one long move does not shorten the others.
      const double far = norm(move_[i]);
      paths_.skeleton.points[i].at = before_[i] + move_[i] * (far > reach ? reach / far : 1);
    }
    slide();
    undo_illegal();
    moved_since_listing_ += std::min(longest, reach);
    paths_.moved += std::min(longest, reach);
  }

  double longest_move() const {
    double most = 0;
    for (const Vec2 m : move_) most = std::max(most, norm_squared(m));
    return std::sqrt(most);
  }

  /// Computes gradient and Hessian of the augmented Lagrangian, by vertex and by band.
  void assemble() {
    gradient_.assign(paths_.skeleton.points.size(), {});
    diagonal_.assign(paths_.skeleton.points.size(), {kDamping / job_.radius, 0, kDamping / job_.radius});
    coupling_.assign(paths_.bands.size(), {});
    move_.assign(paths_.skeleton.points.size(), {});
    measure_bands();
    for (std::uint32_t i = 0; i < paths_.bands.size(); ++i) add_pull(i);
    for (const auto& active : active_) add_hold(active);
    if (job_.turn_cost * tension_ > 0)
      paths_.for_paths([&](const std::vector<int>& path) { add_turns(path); });
  }

  void add_pull(std::uint32_t i) {
    const Band band = paths_.bands[i];
    const Vec2 d = paths_.at(band.b) - paths_.at(band.a);
    const double soft = kSoft * job_.radius, spring = kEven / (kBandSpacing * job_.radius);
    const double l = std::sqrt(norm_squared(d) + soft * soft);
    const Vec2 u = d / l, g = (u + d * spring) * tension_;
    Sym2 h = Sym2{(1 - u.x * u.x) / l + spring, -u.x * u.y / l, (1 - u.y * u.y) / l + spring} * tension_;
    gradient_[band.a] = gradient_[band.a] - g;
    gradient_[band.b] = gradient_[band.b] + g;
    diagonal_[band.a] += h;
    diagonal_[band.b] += h;
    coupling_[i] += h * -1;
  }

  /// Adds turn_cost * (1 - cosine of the turn) at every vertex, with an upper bound of its curvature instead
  /// of its Hessian.
  void add_turns(const std::vector<int>& path) {
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      const auto before = static_cast<std::uint32_t>(path[i - 1]), here = static_cast<std::uint32_t>(path[i]);
      const auto after = static_cast<std::uint32_t>(path[i + 1]);
      const Vec2 d1 = paths_.at(here) - paths_.at(before), d2 = paths_.at(after) - paths_.at(here);
      const double least = 0.1 * kBandSpacing * job_.radius;
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

  /// From the nearest point of a candidate to a witness.
  struct Offset {
    Vec2 from_band;
    double squared = 0;  ///< mm^2
    double t = 0;        ///< parameter of the point
  };

  /// The point of a band, or of a fixed edge, nearest to a witness.
  struct Hold {
    std::uint32_t band = kFixed;
    double t = 0;
    double distance = std::numeric_limits<double>::infinity();
    Vec2 away;  ///< unit vector from the point to the witness
  };

  void add_hold(const Active& active) {
    Witness& witness = paths_.witnesses[active.witness];
    // Within the limit a witness exerts no force, but one kept in the middle moves on.
    const double calm = witness.moving ? limit_ - skin_ : limit_;
    if (surely_within(active.nearest, witness.p, calm)) return;
    const Hold hold = nearest_hold(active, witness.p);
    if (hold.distance < calm) return;
    if (!witness.moving) return hold_band(hold, 1.0);
    const Hold other = opposite_hold(active, witness.p, hold);
    if (!std::isfinite(other.distance)) return hold_band(hold, 1.0);
    // The witness moves to a place equally far from both: along n1 - n2, the direction in which both distances
    // change at the same rate.
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

  /// Adds the force with which a witness at `hold.distance` pulls a band; `share`: change of the distance per mm of
  /// the band's motion.
  void hold_band(const Hold& hold, double share) {
    const double force = stiffness_ * (hold.distance - limit_) * share;
    if (force <= 0 || hold.distance < 1e-9 || hold.band == kFixed) return;
    const Band band = paths_.bands[hold.band];
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

  /// The vector to p from the nearest point of band `i`; `t` is the parameter of this point.
  Vec2 offset_from_band(std::uint32_t i, Vec2 p, double& t) const {
    const Segment& band = segments_[i];
    const Vec2 s = p - band.a;
    t = std::clamp(dot(s, band.d) * band.inverse, 0.0, 1.0);
    return s - band.d * t;
  }

  /// Whether a band is nearer to p than `reach`, whatever the rounding. Mostly spares the search for the nearest band.
  bool surely_within(std::uint32_t band, Vec2 p, double reach) const {
    double t = 0;
    return reach > 0 && norm_squared(offset_from_band(band, p, t)) < (1 - kRounding) * reach * reach;
  }

  static void finish(Hold& hold, Vec2 offset) {
    hold.distance = std::sqrt(norm_squared(offset));
    if (hold.distance > 0) hold.away = offset / hold.distance;
  }

  /// Leaves the offsets from all candidates in offsets_, for use by opposite_hold.
  Hold nearest_hold(const Active& active, Vec2 p) {
    Hold best;
    std::size_t nearest = 0;
    double nearest_squared = std::numeric_limits<double>::infinity();
    const std::size_t count = active.end - active.first;
    if (offsets_.size() < count) offsets_.resize(count);
    for (std::size_t k = 0; k < count; ++k) {
      Offset& offset = offsets_[k];
      offset.from_band = offset_from_band(candidates_[active.first + k], p, offset.t);
      offset.squared = norm_squared(offset.from_band);
      if (offset.squared >= nearest_squared) continue;
      nearest_squared = offset.squared;
      nearest = k;
    }
    best.band = candidates_[active.first + nearest];
    best.t = offsets_[nearest].t;
    finish(best, offsets_[nearest].from_band);
    return best;
  }

  /// The nearest hold on the opposite side of p, fixed edges included. Must be called after nearest_hold with the same
  /// witness, whose offsets it uses.
  Hold opposite_hold(const Active& active, Vec2 p, const Hold& nearest) const {
    Hold best;
    Vec2 best_offset;
    double best_squared = std::numeric_limits<double>::infinity();
    const auto opposite = [&](Vec2 offset, double squared) {
      if (squared >= best_squared) return false;
      const double c = dot(offset, nearest.away);
      return c <= 0 || c * c < 0.25 * squared;
    };
    for (std::uint32_t k = active.first; k < active.end; ++k) {
      const Offset& offset = offsets_[k - active.first];
      if (!opposite(offset.from_band, offset.squared)) continue;
      best_squared = offset.squared;
      best_offset = offset.from_band;
      best.band = candidates_[k];
      best.t = offset.t;
    }
    for (const std::uint32_t i : fixed_in_.at(grid_.cell_of(p))) {
      if (squared_distance(boxes_of_fixed_[i], p) >= best_squared) continue;
      const Vec2 offset = p - nearest_point(paths_.fixed[i], p);
      const double squared = norm_squared(offset);
      if (squared <= 0 || !opposite(offset, squared)) continue;
      best_squared = squared;
      best_offset = offset;
      best.band = kFixed;
    }
    if (std::isfinite(best_squared)) finish(best, best_offset);
    return best;
  }

  /// Newton step for the free vertices of one path, by block elimination from its first to its last.
  void solve(const std::vector<int>& path) {
    const std::size_t n = path.size();
    if (n == 0) return;
    const std::size_t first_band = next_band_;
    next_band_ = first_band + n - 1 == paths_.bands.size() ? 0 : first_band + n - 1;
    pivot_.resize(n);
    right_.resize(n);
    const auto vertex = [&](std::size_t i) { return static_cast<std::uint32_t>(path[i]); };
    for (std::size_t i = 0; i < n; ++i) {
      Sym2 d = diagonal_[vertex(i)];
      Vec2 r = -gradient_[vertex(i)];
      if (paths_.on_ring(vertex(i))) {
        d = kHeld;
        r = {};
      } else if (i > 0 && !paths_.on_ring(vertex(i - 1))) {
        const Sym2 c = coupling_[first_band + i - 1];
        const Sym2 reduced = c.around(pivot_[i - 1]);
        d += reduced * -1;
        r = r - c * (pivot_[i - 1] * right_[i - 1]);
      }
      pivot_[i] = d.inverse();
      right_[i] = r;
    }
    for (std::size_t i = n; i-- > 0;) {
      if (paths_.on_ring(vertex(i))) continue;
      Vec2 r = right_[i];
      if (i + 1 < n && !paths_.on_ring(vertex(i + 1)))
        r = r - coupling_[first_band + i] * move_[vertex(i + 1)];
      move_[vertex(i)] = pivot_[i] * r;
    }
    for (const std::size_t i : {std::size_t{0}, n - 1}) {
      if (paths_.on_ring(vertex(i))) move_[vertex(i)] = slide_step(vertex(i));
    }
  }

  const RingIndex& ring_of(const FlexPoint& vertex) const {
    return rings_[static_cast<std::size_t>(vertex.ring)];
  }

  Vec2 slide_step(std::uint32_t i) const {
    Vec2 tangent{1, 0};
    ring_of(paths_.skeleton.points[i]).nearest_to(paths_.at(i), &tangent);
    return tangent * (-dot(gradient_[i], tangent) / dot(tangent, diagonal_[i] * tangent));
  }

  void slide() {
    for (auto& vertex : paths_.skeleton.points) {
      if (vertex.ring < 0) continue;
      vertex.at = ring_of(vertex).nearest_to(vertex.at);
    }
  }

  /// Moves bands outside of the legal area back to their former places.
  void undo_illegal() {
    for (std::size_t i = 0; i < paths_.bands.size(); ++i) {
      const Band band = paths_.bands[i];
      if (safe_[i] || (paths_.at(band.a) == before_[band.a] && paths_.at(band.b) == before_[band.b]))
        continue;
      if (job_.legal->holds_line(paths_.at(band.a), paths_.at(band.b))) continue;
      paths_.at(band.a) = before_[band.a];
      paths_.at(band.b) = before_[band.b];
    }
  }

  void measure_bands() {
    segments_.resize(paths_.bands.size());
    for (std::size_t i = 0; i < paths_.bands.size(); ++i) {
      const Vec2 a = paths_.at(paths_.bands[i].a), d = paths_.at(paths_.bands[i].b) - a;
      const double whole = norm_squared(d);
      segments_[i] = {a, d, whole > 0 ? 1 / whole : 0};
    }
  }

  /// Lists witnesses near the limit. Those well inside are skipped until bands may have moved away from them.
  void list_active() {
    active_.clear();
    candidates_.clear();
    const double far = limit_ + 2 * skin_, near = limit_ - 2 * skin_;
    measure_bands();
    tree_is_built_ = false;
    sort_bands_into_grid(far);
    for (std::uint32_t w = 0; w < paths_.witnesses.size(); ++w) {
      Witness& witness = paths_.witnesses[w];
      if (witness.near + (paths_.moved - witness.when) < near) continue;
      const Vec2 p = witness.p;
      const auto first = static_cast<std::uint32_t>(candidates_.size());
      double nearest_squared = far * far, t = 0;
      std::uint32_t nearest = 0;
      for (const std::uint32_t band : bands_in_.at(grid_.cell_of(p))) {
        const double squared = norm_squared(offset_from_band(band, p, t));
        if (squared > far * far) continue;
        candidates_.push_back(band);
        if (squared > nearest_squared) continue;
        nearest_squared = squared;
        nearest = band;
      }
      witness.near = std::sqrt(nearest_squared);
      witness.when = paths_.moved;
      if (nearest_squared < near * near || (witness.moving && !job_.matters(p))) {
        candidates_.resize(first);
        continue;
      }
      if (candidates_.size() == first) {
        nearest = nearest_band(p);
        candidates_.push_back(nearest);
      }
      active_.push_back({w, first, static_cast<std::uint32_t>(candidates_.size()), nearest});
    }
    moved_since_listing_ = 0;
  }

  /// The band nearest to p at any distance; of several equally near ones the first.
  std::uint32_t nearest_band(Vec2 p) {
    if (!tree_is_built_) {
      tree_.build(static_cast<std::uint32_t>(paths_.bands.size()),
                  [&](std::uint32_t i) { return box_of(i); });
      tree_is_built_ = true;
    }
    return tree_.nearest(p, [&](std::uint32_t i) {
      double t = 0;
      return norm_squared(offset_from_band(i, p, t));
    });
  }

  Box box_of(std::uint32_t band) const {
    Box box;
    box.add(paths_.at(paths_.bands[band].a));
    box.add(paths_.at(paths_.bands[band].b));
    return box;
  }

  void sort_bands_into_grid(double far) {
    safe_.assign(paths_.bands.size(), 0);
    for (std::uint32_t i = 0; i < paths_.bands.size(); ++i) {
      const Box box = box_of(i);
      grid_.for_cells(box.grown(far), [&](std::size_t cell, Vec2) { bands_in_.add(cell, i); });
      safe_[i] = job_.legal->surely_holds(box.grown(2 * skin_));
    }
    bands_in_.build(grid_.count());
  }

  static constexpr Sym2 kHeld{1, 0, 1};

  Bands& paths_;
  const TightenJob& job_;
  double limit_ = 0;  ///< mm; witnesses pull bands farther away than this
  double skin_ = 0;
  double stiffness_ = 0;
  double tension_ = 1;
  std::vector<Active> active_;
  std::vector<std::uint32_t> candidates_;
  std::vector<Offset> offsets_;  ///< offsets of the current witness
  std::vector<Vec2> before_, gradient_, move_, right_;
  std::vector<Sym2> diagonal_, coupling_, pivot_;
  std::size_t next_band_ = 0;
  double moved_since_listing_ = 0;
  CellGrid grid_;
  CellLists bands_in_, fixed_in_;
  std::vector<Box> boxes_of_fixed_;
  std::vector<RingIndex> rings_;  ///< by the skeleton's numbers of rings
  /// Bands at their places during the last listing; built for the first query by a witness far from all bands.
  BoxTree tree_;
  bool tree_is_built_ = false;
  std::vector<Segment> segments_;
  /// For each band: whether the band cannot leave the legal area before the next listing.
  std::vector<char> safe_;
};

BandMinimiser::BandMinimiser(Bands& paths, const TightenJob& job)
    : impl_(std::make_unique<Impl>(paths, job)) {}
BandMinimiser::~BandMinimiser() = default;

void BandMinimiser::relax(const Pull& pull, double limit) {
  impl_->relax(pull, limit);
}

}  // namespace clearcut::plan::contour
