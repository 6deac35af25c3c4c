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

/// Directions u with dot(n, u) > q form an arc about n's angle.
void append_beyond(double angle_of_normal, double q, AngleSet::Arc*& out) {
  if (q >= 1) return;
  *out++ = {angle_of_normal, q <= -1 ? kPi : std::acos(q)};
}

/// Directions from `center` at `radius` that end inside the disc about `at`.
void remove_disc(AngleSet& angles, Vec2 at, double disc, Vec2 center, double radius, double reference) {
  const Vec2 v = at - center;
  const double d = length_of(v);
  if (d >= radius + disc || d + disc <= radius) return;
  if (d + radius <= disc) return angles.remove(0, kPi);
  const double cosine = (radius * radius + d * d - disc * disc) / (2 * radius * d);
  angles.remove(angle_of(v) - reference, std::acos(std::clamp(cosine, -1.0, 1.0)));
}

/// What of the circle lies outside the straight part of a line's sweep; false when all of the circle does.
bool arcs_outside_strip(const Edge& path, double direction, double length, double sweep, Vec2 center,
                        double radius, AngleSet::Arc*& out) {
  const Vec2 d = (path.to - path.from) / length, w = center - path.from;
  const double along = dot(w, d), aside = cross(d, w);
  if (along <= -radius || along >= length + radius || std::abs(aside) >= sweep + radius) return false;
  append_beyond(direction + kPi / 2, (sweep - aside) / radius, out);
  append_beyond(direction - kPi / 2, (sweep + aside) / radius, out);
  append_beyond(direction + kPi, along / radius, out);
  append_beyond(direction, (length - along) / radius, out);
  return true;
}

/// The same for the part of a ring that an arc of less than a half turn sweeps.
bool arcs_outside_ring(const Edge& path, double sweep, Vec2 center, double radius, AngleSet::Arc*& out) {
  const Vec2 w = center - path.center;
  const double ring = path.radius(), d = length_of(w);
  const double outer = ring + sweep, inner = ring - sweep;
  if (d - radius >= outer || d + radius <= inner) return false;
  const double away = d > 0 ? angle_of(w) : 0.0, twice = 2 * d * radius;
  const auto cosine_at = [&](double rho) {
    const double numerator = rho * rho - d * d - radius * radius;
    return twice > 0 ? numerator / twice : (numerator > 0 ? 2.0 : -2.0);
  };
  append_beyond(away, cosine_at(outer), out);
  if (inner > 0) append_beyond(away + kPi, -cosine_at(inner), out);
  const double sign = path.turn == Turn::kCounterClockwise ? 1 : -1;
  // Beyond the two rays that bound the piece.
  const Vec2 before = left_of(unit(path.from - path.center)) * -sign;
  const Vec2 after = left_of(unit(path.to - path.center)) * sign;
  append_beyond(angle_of(before), -dot(before, w) / radius, out);
  append_beyond(angle_of(after), -dot(after, w) / radius, out);
  return true;
}

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

void Material::Grid::insert(const Edge& path, double radius, Entry entry) {
  const double far = reach + radius;
  // Halving keeps the box of a long slanting path from covering many cells in vain.
  if (path.from != path.to && path.length() > 2 * far + 4 * cell) {
    insert(path.part(0, 0.5), radius, entry);
    insert(path.part(0.5, 1), radius, entry);
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
      std::vector<Entry>& list = cells[key({x, y})];
      if (list.empty() || list.back().sweep != entry.sweep) list.push_back(entry);
    }
  }
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

void Material::add_piece(const Edge& path, double z_from, double z_to, double radius) {
  Sweep sweep = make_sweep(path, z_from, z_to, radius);
  if (sweep.z_low >= z_top_) return;
  if (path.from == path.to)
    sweep.z_high = sweep.z_from = sweep.z_to = sweep.z_low;  // straight down: only its end counts
  const Entry entry{sweep.z_low, static_cast<int>(sweeps_.size())};
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
    if (entry.z_low > z) continue;
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
    if (entry.z_low >= height || !covers(sweep, p)) continue;
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

void Material::remove_sweep(AngleSet& angles, const Sweep& sweep, Vec2 center, double radius,
                            double reference) {
  const Edge& path = sweep.path;
  if (path.from == path.to) return remove_disc(angles, path.from, sweep.radius, center, radius, reference);
  AngleSet::Arc outside[4];
  AngleSet::Arc* end = outside;
  const bool meets = path.is_arc() ? arcs_outside_ring(path, sweep.radius, center, radius, end)
                                   : arcs_outside_strip(path, sweep.direction, sweep.length, sweep.radius,
                                                        center, radius, end);
  if (meets) {
    for (AngleSet::Arc* arc = outside; arc != end; ++arc) arc->center -= reference;
    angles.keep({outside, end});
  }
  remove_disc(angles, path.from, sweep.radius, center, radius, reference);
  remove_disc(angles, path.to, sweep.radius, center, radius, reference);
}

void Material::remove_outside(AngleSet& angles, Vec2 center, double radius, double reference) const {
  if (!plan_) return;
  AngleSet::Arc beyond[4];
  AngleSet::Arc* end = beyond;
  append_beyond(0, (plan_->max.x - center.x) / radius, end);
  append_beyond(kPi, (center.x - plan_->min.x) / radius, end);
  append_beyond(kPi / 2, (plan_->max.y - center.y) / radius, end);
  append_beyond(-kPi / 2, (center.y - plan_->min.y) / radius, end);
  for (AngleSet::Arc* arc = beyond; arc != end; ++arc) angles.remove(arc->center - reference, arc->half);
}

void Material::remove_everything_else(AngleSet& angles, Vec2 center, double radius, double z,
                                      double reference) const {
  if (z >= z_top_) return angles.remove(0, kPi);
  remove_outside(angles, center, radius, reference);
  const std::vector<Entry>* near = grid_for(radius).at(center);
  if (!near) return;
  // Latest first: what was cut last is most often what the circle still touches.
  for (auto entry = near->rbegin(); entry != near->rend() && !angles.empty(); ++entry) {
    if (entry->z_low > z) continue;
    const Sweep& sweep = sweeps_[entry->sweep];
    if (sweep.z_high <= z) {
      remove_sweep(angles, sweep, center, radius, reference);
    } else {
      remove_sweep(angles, *below(sweep, z), center, radius, reference);
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
  for (int i = 0; i < pieces && !angles.empty(); ++i) {
    const Edge piece = move.path.part(t * i / pieces, t * (i + 1) / pieces);
    remove_sweep(angles, make_sweep(piece, z, z, radius), center, radius, angle_of(direction));
  }
  return contact_of(angles);
}

AngleSet Material::circle_in_material(Vec2 center, double radius, double z) const {
  AngleSet angles(-kPi, kPi);
  remove_everything_else(angles, center, radius, z, 0);
  return angles;
}

}  // namespace clearcut
