#include "stock/material.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace clearcut {
namespace {

/// Arcs are cut into pieces below this sweep, so that a piece is the part of a ring between two half-planes.
constexpr double kPieceSweep = 2.0;

double length_of(Vec2 a) {
  return std::sqrt(norm_squared(a));
}

double distance_to_path(const Edge& path, Vec2 p) {
  return path.from == path.to ? length_of(p - path.from) : distance(path, p);
}

/// The directions around a cutter's centre that are still in material, and a narrow view of them by which
/// most sweeps are turned away without trigonometry.
class Horizon {
 public:
  Horizon(AngleSet& angles, Vec2 center, double radius, double reference)
      : angles_(angles), center_(center), radius_(radius), reference_(reference) {
    look();
  }

  bool empty() const { return angles_.empty(); }

  /// Whether a disc of `reach` about `at` may cover any of what is left.
  bool may_meet(Vec2 at, double reach) const {
    const double far = reach + rest_radius_;
    return norm_squared(at - rest_center_) <= far * far;
  }

  void remove_disc(Vec2 at, double disc) {
    const Vec2 v = at - center_;
    const double d = length_of(v);
    if (d >= radius_ + disc || d + disc <= radius_) return;
    if (d + radius_ <= disc) return angles_.remove(0, kPi);
    const double cosine =
        std::clamp((radius_ * radius_ + d * d - disc * disc) / (2 * radius_ * d), -1.0, 1.0);
    if (!faces(v, d, cosine)) return;
    angles_.remove(angle_of(v) - reference_, std::acos(cosine));
    look();
  }

  void remove_line(const Edge& path, double direction, double length, double sweep) {
    const Vec2 d = (path.to - path.from) / length, w = center_ - path.from;
    const double along = dot(w, d), aside = cross(d, w);
    const bool meets = along > -radius_ && along < length + radius_ && std::abs(aside) < sweep + radius_;
    if (!meets || !faces_disc(path.from + d * (length / 2), std::sqrt(sweep * sweep + length * length / 4)))
      return;
    AngleSet::Arc outside[4];
    AngleSet::Arc* end = outside;
    append_beyond(direction + kPi / 2, (sweep - aside) / radius_, end);
    append_beyond(direction - kPi / 2, (sweep + aside) / radius_, end);
    append_beyond(direction + kPi, along / radius_, end);
    append_beyond(direction, (length - along) / radius_, end);
    keep({outside, end});
  }

  /// The part of a ring that an arc of less than a half turn sweeps.
  void remove_ring(const Edge& path, double sweep) {
    const Vec2 w = center_ - path.center;
    const double ring = path.radius(), d = length_of(w);
    const double outer = ring + sweep, inner = ring - sweep;
    if (d - radius_ >= outer || d + radius_ <= inner) return;
    AngleSet::Arc outside[4];
    AngleSet::Arc* end = outside;
    const double away = d > 0 ? angle_of(w) : 0.0, twice = 2 * d * radius_;
    const auto cosine_at = [&](double rho) {
      const double numerator = rho * rho - d * d - radius_ * radius_;
      return twice > 0 ? numerator / twice : (numerator > 0 ? 2.0 : -2.0);
    };
    append_beyond(away, cosine_at(outer), end);
    if (inner > 0) append_beyond(away + kPi, -cosine_at(inner), end);
    // Beyond the two rays that bound the piece.
    const double sign = path.turn == Turn::kCounterClockwise ? 1 : -1;
    const Vec2 before = left_of(unit(path.from - path.center)) * -sign;
    const Vec2 after = left_of(unit(path.to - path.center)) * sign;
    append_beyond(angle_of(before), -dot(before, w) / radius_, end);
    append_beyond(angle_of(after), -dot(after, w) / radius_, end);
    keep({outside, end});
  }

 private:
  /// Directions u with dot(n, u) > q form an arc about n's angle.
  static void append_beyond(double angle_of_normal, double q, AngleSet::Arc*& out) {
    if (q >= 1) return;
    *out++ = {angle_of_normal, q <= -1 ? kPi : std::acos(q)};
  }

  void keep(std::span<AngleSet::Arc> outside) {
    for (AngleSet::Arc& arc : outside) arc.center -= reference_;
    angles_.keep(outside);
    look();
  }

  /// Whether directions within acos(cosine) of v (d long) meet those left.
  bool faces(Vec2 v, double d, double cosine) const {
    if (half_ >= kPi || cosine <= -cos_half_) return true;
    const double sum = cosine * cos_half_ - std::sqrt(1 - cosine * cosine) * sin_half_;
    return dot(v, ahead_) >= (sum - 1e-9) * d;
  }

  bool faces_disc(Vec2 at, double disc) const {
    const Vec2 v = at - center_;
    const double d = length_of(v);
    if (d + radius_ <= disc) return true;
    if (d >= radius_ + disc || d + disc <= radius_) return false;
    return faces(v, d, (radius_ * radius_ + d * d - disc * disc) / (2 * radius_ * d));
  }

  void look() {
    if (angles_.empty()) return;
    const double from = angles_.intervals().front().from, to = angles_.intervals().back().to;
    if (from == from_ && to == to_) return;
    from_ = from;
    to_ = to;
    half_ = (to - from) / 2;
    cos_half_ = std::cos(half_);
    sin_half_ = std::sin(half_);
    ahead_ = direction_of(reference_ + (from + to) / 2);
    const bool wide = half_ >= kPi / 2;
    rest_center_ = wide ? center_ : center_ + ahead_ * (radius_ * cos_half_);
    rest_radius_ = (wide ? radius_ : radius_ * sin_half_) * (1 + 1e-12) + 1e-12;
  }

  AngleSet& angles_;
  const Vec2 center_;
  const double radius_;
  const double reference_;
  // Everything left lies within half_ of ahead_, and within rest_radius_ of rest_center_.
  double from_ = 0, to_ = 0, half_ = 0, cos_half_ = 1, sin_half_ = 0;
  Vec2 ahead_, rest_center_;
  double rest_radius_ = 0;
};

}  // namespace

Material::Material(std::optional<Box> plan, double z_top, const std::vector<double>& radii)
    : plan_(plan), z_top_(z_top) {
  std::vector<double> reaches = radii;
  std::sort(reaches.begin(), reaches.end());
  reaches.erase(std::unique(reaches.begin(), reaches.end()), reaches.end());
  for (const double reach : reaches) {
    CLEARCUT_ASSERT(reach > 0);
    grids_.push_back({reach, reach / 2, {}});
  }
  CLEARCUT_ASSERT(!grids_.empty());
}

std::uint64_t Material::Grid::key(Vec2 p) const {
  const auto part = [this](double v) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(v / cell)));
  };
  return (std::uint64_t{part(p.x)} << 32) | part(p.y);
}

const std::vector<Material::Entry>* Material::Grid::at(Vec2 p) const {
  const auto found = cells.find(key(p));
  return found == cells.end() ? nullptr : &found->second;
}

/// The lists of all cells that a circle may reach the path from; each at least once.
template <typename F>
void Material::Grid::for_lists(const Edge& path, double radius, F&& f) {
  const double far = reach + radius;
  // Halving keeps the box of a long slanting path from covering many cells in vain.
  if (path.from != path.to && path.length() > 2 * far + 4 * cell) {
    for_lists(path.part(0, 0.5), radius, f);
    for_lists(path.part(0.5, 1), radius, f);
    return;
  }
  Box box = path.from == path.to ? Box{path.from, path.from} : path.box();
  box = box.grown(far + cell);
  const double half_diagonal = cell * 0.70711;
  const double x0 = (std::floor(box.min.x / cell) + 0.5) * cell,
               y0 = (std::floor(box.min.y / cell) + 0.5) * cell;
  for (double y = y0; y <= box.max.y; y += cell) {
    for (double x = x0; x <= box.max.x; x += cell) {
      if (distance_to_path(path, {x, y}) > far + half_diagonal) continue;
      f(cells[key({x, y})]);
    }
  }
}

void Material::Grid::insert(const Edge& path, double radius, Entry entry) {
  for_lists(path, radius, [&](std::vector<Entry>& list) {
    if (list.empty() || list.back().sweep != entry.sweep) list.push_back(entry);
  });
}

/// Only the newest sweep can be removed: it comes last in all its lists.
void Material::Grid::remove(const Edge& path, double radius, int sweep) {
  for_lists(path, radius, [&](std::vector<Entry>& list) {
    if (!list.empty() && list.back().sweep == sweep) list.pop_back();
  });
}

Material::Sweep Material::make_sweep(const Edge& path, double z_from, double z_to, double radius) {
  Sweep sweep{path, radius, z_from, z_to, std::min(z_from, z_to), std::max(z_from, z_to), 0, 0};
  if (!path.is_arc() && path.from != path.to) {
    sweep.direction = angle_of(path.to - path.from);
    sweep.length = length_of(path.to - path.from);
  }
  return sweep;
}

void Material::add(const Move& move, double radius) {
  const double sweep = std::abs(move.path.sweep());
  const int pieces = std::max(1, static_cast<int>(std::ceil(sweep / kPieceSweep)));
  for (int i = 0; i < pieces; ++i) {
    const double t0 = static_cast<double>(i) / pieces, t1 = static_cast<double>(i + 1) / pieces;
    const double dz = move.z_to - move.z_from;
    add_piece(pieces == 1 ? move.path : move.path.part(t0, t1), move.z_from + dz * t0, move.z_from + dz * t1,
              radius);
  }
}

void Material::forget_beyond(std::size_t sweeps) {
  for (; sweeps_.size() > sweeps; sweeps_.pop_back()) {
    const Sweep& last = sweeps_.back();
    for (Grid& grid : grids_) grid.remove(last.path, last.radius, static_cast<int>(sweeps_.size()) - 1);
  }
}

void Material::add_piece(const Edge& path, double z_from, double z_to, double radius) {
  Sweep sweep = make_sweep(path, z_from, z_to, radius);
  if (sweep.z_low >= z_top_) return;
  if (path.from == path.to)
    sweep.z_high = sweep.z_from = sweep.z_to = sweep.z_low;  // straight down: only its end counts
  const bool point = path.from == path.to;
  const Vec2 middle = point ? path.from : path.at(0.5);
  const double reach = (point ? 0 : path.length() / 2) + radius;
  const Entry entry{sweep.z_low, middle, reach * (1 + 1e-12), static_cast<int>(sweeps_.size())};
  for (Grid& grid : grids_) grid.insert(path, radius, entry);
  sweeps_.push_back(sweep);
}

const Material::Grid& Material::grid_for(double radius) const {
  for (const Grid& grid : grids_) {
    if (radius <= grid.reach) return grid;
  }
  throw_broken_promise("the radius asked about is among those announced", __FILE__, __LINE__);
}

/// The part of a sweep whose tip is at or below z.
std::optional<Material::Sweep> Material::below(const Sweep& sweep, double z) {
  if (sweep.z_low > z) return std::nullopt;
  if (sweep.z_high <= z) return sweep;
  const double t = std::clamp((z - sweep.z_from) / (sweep.z_to - sweep.z_from), 0.0, 1.0);
  const double t0 = sweep.z_from > z ? t : 0, t1 = sweep.z_from > z ? 1 : t;
  const Vec2 a = sweep.path.at(t0), b = sweep.path.at(t1);
  const Edge part = a == b ? Edge::line(a, a) : sweep.path.part(t0, t1);
  return make_sweep(part, sweep.z_low, sweep.z_low, sweep.radius);
}

bool Material::covers(const Sweep& sweep, Vec2 p) {
  return distance_to_path(sweep.path, p) <= sweep.radius;
}

bool Material::is_removed(Vec2 p, double z) const {
  if (z >= z_top_ || (plan_ && !plan_->contains(p))) return true;
  const std::vector<Entry>* near = grids_.front().at(p);
  if (!near) return false;
  for (const Entry& entry : *near) {
    if (entry.z_low > z || norm_squared(entry.middle - p) > entry.reach * entry.reach) continue;
    const Sweep& sweep = sweeps_[entry.sweep];
    if (sweep.z_high <= z ? covers(sweep, p) : covers(*below(sweep, z), p)) return true;
  }
  return false;
}

double Material::height(Vec2 p) const {
  if (plan_ && !plan_->contains(p)) return -std::numeric_limits<double>::infinity();
  double height = z_top_;
  const std::vector<Entry>* near = grids_.front().at(p);
  if (!near) return height;
  for (const Entry& entry : *near) {
    const Sweep& sweep = sweeps_[entry.sweep];
    if (entry.z_low >= height || norm_squared(entry.middle - p) > entry.reach * entry.reach) continue;
    if (!covers(sweep, p)) continue;
    double low = sweep.z_low, high = sweep.z_high;  // covered at high, perhaps not at low
    if (covers(*below(sweep, low), p)) high = low;
    while (high - low > 1e-6) {
      const double middle = (low + high) / 2;
      (covers(*below(sweep, middle), p) ? high : low) = middle;
    }
    height = std::min(height, high);
  }
  return height;
}

template <typename View>
void Material::remove_sweep(View& view, const Sweep& sweep) {
  const Edge& path = sweep.path;
  if (path.from == path.to) return view.remove_disc(path.from, sweep.radius);
  if (path.is_arc()) {
    view.remove_ring(path, sweep.radius);
  } else {
    view.remove_line(path, sweep.direction, sweep.length, sweep.radius);
  }
  view.remove_disc(path.from, sweep.radius);
  view.remove_disc(path.to, sweep.radius);
}

void Material::remove_outside(AngleSet& angles, Vec2 center, double radius, double reference) const {
  if (!plan_) return;
  const double beyond[] = {plan_->max.x - center.x, plan_->max.y - center.y, center.x - plan_->min.x,
                           center.y - plan_->min.y};
  for (int side = 0; side < 4; ++side) {
    const double q = beyond[side] / radius;
    if (q < 1) angles.remove(side * kPi / 2 - reference, q <= -1 ? kPi : std::acos(q));
  }
}

void Material::remove_everything_else(AngleSet& angles, Vec2 center, double radius, double z,
                                      double reference) const {
  if (z >= z_top_) return angles.remove(0, kPi);
  remove_outside(angles, center, radius, reference);
  const std::vector<Entry>* near = grid_for(radius).at(center);
  if (!near) return;
  Horizon horizon(angles, center, radius, reference);
  // Latest first: what was cut last is most often what the circle still touches.
  for (auto entry = near->rbegin(); entry != near->rend() && !horizon.empty(); ++entry) {
    if (entry->z_low > z || !horizon.may_meet(entry->middle, entry->reach)) continue;
    const Sweep& sweep = sweeps_[entry->sweep];
    if (sweep.z_high <= z) {
      remove_sweep(horizon, sweep);
    } else {
      remove_sweep(horizon, *below(sweep, z));
    }
  }
}

namespace {

Contact contact_of(const AngleSet& angles) {
  Contact contact{angles, angles.measure(), 0, 0};
  for (const AngleInterval& item : angles.intervals()) {
    contact.left += std::max(0.0, item.to) - std::max(0.0, item.from);
    contact.right += std::min(0.0, item.to) - std::min(0.0, item.from);
  }
  return contact;
}

}  // namespace

Contact Material::engagement(Vec2 center, Vec2 direction, double radius, double z) const {
  AngleSet angles(-kPi / 2, kPi / 2);
  remove_everything_else(angles, center, radius, z, angle_of(direction));
  return contact_of(angles);
}

Contact Material::engagement(const Move& move, double t, double radius) const {
  const double z = move.z_from + (move.z_to - move.z_from) * t;
  const Vec2 center = move.path.at(t), direction = move.path.tangent_at(t);
  AngleSet angles(-kPi / 2, kPi / 2);
  remove_everything_else(angles, center, radius, z, angle_of(direction));
  // Going straight on, the front never meets the move's own start; going round, it may. What a descending
  // move passed stands higher than its tip is now.
  const bool counts = move.path.is_arc() && move.z_to >= move.z_from;
  const int pieces = counts ? static_cast<int>(std::ceil(std::abs(move.path.sweep()) * t / kPieceSweep)) : 0;
  Horizon horizon(angles, center, radius, angle_of(direction));
  for (int i = 0; i < pieces && !angles.empty(); ++i) {
    const Edge piece = move.path.part(t * i / pieces, t * (i + 1) / pieces);
    remove_sweep(horizon, make_sweep(piece, z, z, radius));
  }
  return contact_of(angles);
}

AngleSet Material::circle_in_material(Vec2 center, double radius, double z) const {
  AngleSet angles(-kPi, kPi);
  remove_everything_else(angles, center, radius, z, 0);
  return angles;
}

}  // namespace clearcut
