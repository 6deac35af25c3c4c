#include "stock/material.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.h"

namespace clearcut::stock {
namespace {

/// Radians. Arcs are divided into pieces below this sweep, so that each is the part of a ring between two
/// half-planes.
constexpr double kPieceSweep = 2.0;
/// Radians. A smaller bend between sweeps is due to rounding.
constexpr double kBend = 1e-12;
/// mm. Sweeps up to this length do not cover the round ends of sweeps before or after.
constexpr double kShort = 1e-6;
/// Number of stretches of a ramp, each counted in queries of circles with the profile over its highest tip.
constexpr int kStretches = 4;
/// Number of steps of the search for the lowest place of a ramp over a point: exact to 1e-6 of its length.
constexpr int kSections = 30;
constexpr double kGolden = 0.6180339887498949;

double length_of(Vec2 a) {
  return std::sqrt(norm_squared(a));
}

}  // namespace

Material::Material(std::optional<Box> plan, double z_top, const std::vector<double>& radii)
    : plan_(plan), z_top_(z_top) {
  std::vector<double> reaches = radii;
  std::sort(reaches.begin(), reaches.end());
  reaches.erase(std::unique(reaches.begin(), reaches.end()), reaches.end());
  for (const double reach : reaches) {
    CLEARCUT_ASSERT(reach > 0);
    grids_.emplace_back(reach);
  }
  CLEARCUT_ASSERT(!grids_.empty());
}

int Material::Grid::place(double v) const {
  return static_cast<int>(static_cast<std::int64_t>(std::floor(v / cell)));
}

/// Index of a tile in the table, or the index of the free place for it.
std::size_t Material::Grid::slot_of(int tile_x, int tile_y) const {
  const std::uint64_t key =
      (std::uint64_t{static_cast<std::uint32_t>(tile_x)} << 32) | static_cast<std::uint32_t>(tile_y);
  std::size_t slot = (key * 0x9E3779B97F4A7C15u) >> shift;
  while (table[slot] != kNone && (tiles[table[slot]].x != tile_x || tiles[table[slot]].y != tile_y))
    slot = (slot + 1) & (table.size() - 1);
  return slot;
}

std::size_t Material::Grid::within_tile(int x, int y) {
  constexpr int kMask = (1 << kTileBits) - 1;
  return static_cast<std::size_t>(((y & kMask) << kTileBits) | (x & kMask));
}

const Material::List* Material::Grid::at(int x, int y) const {
  const std::uint32_t found = table[slot_of(x >> kTileBits, y >> kTileBits)];
  return found == kNone ? nullptr : &tiles[found].cells[within_tile(x, y)];
}

Material::List& Material::Grid::list(int x, int y) {
  const int tile_x = x >> kTileBits, tile_y = y >> kTileBits;
  std::uint32_t& found = table[slot_of(tile_x, tile_y)];
  if (found != kNone) return tiles[found].cells[within_tile(x, y)];
  found = static_cast<std::uint32_t>(tiles.size());
  tiles.push_back({tile_x, tile_y, {}});
  if (2 * tiles.size() > table.size()) grow();
  return tiles.back().cells[within_tile(x, y)];
}

void Material::Grid::grow() {
  table.assign(2 * table.size(), kNone);
  --shift;
  for (std::size_t i = 0; i < tiles.size(); ++i)
    table[slot_of(tiles[i].x, tiles[i].y)] = static_cast<std::uint32_t>(i);
}

/// Calls f for the lists of all cells from which a circle may touch the sweep along the path; each at least once.
template <typename F>
void Material::Grid::for_lists(const Swept& swept, const Edge& path, F&& f) {
  const double far = reach + swept.radius;
  // Halved, because the box of a long slanting path would cover many cells in vain.
  if (path.from != path.to && path.length() > 2 * far + 4 * cell) {
    for_lists(swept, path.part(0, 0.5), f);
    for_lists(swept, path.part(0.5, 1), f);
    return;
  }
  const Box box = (path.from == path.to ? Box{path.from, path.from} : path.box()).grown(far + cell);
  const double half_diagonal = cell * 0.70711;
  const int last_x = place(box.max.x), last_y = place(box.max.y);
  for (int y = place(box.min.y); y <= last_y; ++y) {
    for (int x = place(box.min.x); x <= last_x; ++x) {
      if (swept.comes_within(Vec2{x + 0.5, y + 0.5} * cell, far + half_diagonal)) f(list(x, y));
    }
  }
}

void Material::Grid::insert(const Sweep& sweep, std::uint32_t index) {
  for_lists(sweep.shape, sweep.path, [&](List& list) {
    if (list.empty() || list.back() != index) list.push_back(index);
  });
}

/// Removes the newest sweep, the last one in all its lists.
void Material::Grid::remove(const Sweep& sweep, std::uint32_t index) {
  for_lists(sweep.shape, sweep.path, [&](List& list) {
    if (!list.empty() && list.back() == index) list.pop_back();
  });
}

Material::Sweep Material::make_sweep(const Edge& path, double z_from, double z_to, double radius) {
  Sweep sweep{path, {}, z_from, z_to, std::min(z_from, z_to), std::max(z_from, z_to)};
  Swept& shape = sweep.shape;
  shape.radius = radius;
  shape.from = path.from;
  shape.to = path.to;
  if (path.from == path.to) return sweep;
  if (path.is_arc()) {
    const double side = path.turn == Turn::kCounterClockwise ? 1 : -1;
    shape.kind = Swept::Kind::kArc;
    shape.center = path.center;
    shape.ring = path.radius();
    shape.before = left_of(unit(path.from - path.center)) * -side;
    shape.after = left_of(unit(path.to - path.center)) * side;
  } else {
    shape.kind = Swept::Kind::kLine;
    shape.after = (path.to - path.from) / length_of(path.to - path.from);
    shape.before = -shape.after;
  }
  return sweep;
}

/// If `next` continues `last`, each covers the other's round end there, unless the path bends.
void Material::join(Sweep& last, Sweep& next) {
  const bool goes_on = last.path.to == next.path.from && next.shape.kind != Swept::Kind::kDisc &&
                       last.cutter == next.cutter && last.shape.radius == next.shape.radius &&
                       last.z_high <= next.z_low;
  if (!goes_on) return;
  next.shape.round_start = false;
  last.shape.round_end = !(last.shape.kind != Swept::Kind::kDisc && next.z_high <= last.z_low &&
                           norm_squared(last.shape.after + next.shape.before) < kBend * kBend &&
                           std::min(last.path.length(), next.path.length()) > kShort);
}

int Material::add_cutter(const CutterProfile& removes, double circle) {
  if (removes.is_cylinder() && removes.widest == circle && circle > 0) return kCylinder;
  for (std::size_t i = 0; i < cutters_.size(); ++i)
    if (cutters_[i].removes == removes && cutters_[i].circle == circle) return static_cast<int>(i);
  cutters_.push_back({removes, circle});
  return static_cast<int>(cutters_.size()) - 1;
}

void Material::add(const Move& move, double radius) {
  add_pieces(move, radius, kCylinder);
}

void Material::add_sweep(const Move& move, int cutter) {
  const Cutter& shape = cutters_.at(static_cast<std::size_t>(cutter));
  const double high = z_top_ - std::min(move.z_from, move.z_to);
  if (high <= 0) return;
  const double radius = std::max(shape.removes.radius_at(high), shape.circle);
  if (radius > 0) add_pieces(move, radius, cutter);
}

void Material::add_pieces(const Move& move, double radius, int cutter) {
  const double sweep = std::abs(move.path.sweep());
  const int pieces = std::max(1, static_cast<int>(std::ceil(sweep / kPieceSweep)));
  for (int i = 0; i < pieces; ++i) {
    const double t0 = static_cast<double>(i) / pieces, t1 = static_cast<double>(i + 1) / pieces;
    const double dz = move.z_to - move.z_from;
    add_piece(pieces == 1 ? move.path : move.path.part(t0, t1), move.z_from + dz * t0, move.z_from + dz * t1,
              radius, cutter);
  }
}

void Material::forget_beyond(std::size_t sweeps) {
  for (; sweeps_.size() > sweeps; sweeps_.pop_back(), discs_.pop_back()) {
    const Sweep& last = sweeps_.back();
    for (Grid& grid : grids_) grid.remove(last, static_cast<std::uint32_t>(sweeps_.size() - 1));
    if (sweeps_.size() > 1) sweeps_[sweeps_.size() - 2].shape.round_end = true;
  }
}

void Material::add_piece(const Edge& path, double z_from, double z_to, double radius, int cutter) {
  Sweep sweep = make_sweep(path, z_from, z_to, radius);
  sweep.cutter = cutter;
  if (sweep.z_low >= z_top_) return;
  if (path.from == path.to)
    sweep.z_high = sweep.z_from = sweep.z_to = sweep.z_low;  // a plunge: only its end counts
  const bool point = path.from == path.to;
  const Vec2 middle = point ? path.from : path.at(0.5);
  const double reach = (point ? 0 : path.length() / 2) + radius;
  for (Grid& grid : grids_) grid.insert(sweep, static_cast<std::uint32_t>(sweeps_.size()));
  if (!sweeps_.empty()) join(sweeps_.back(), sweep);
  sweeps_.push_back(sweep);
  discs_.push_back({sweep.z_low, middle, reach * (1 + 1e-12)});
}

const Material::Grid& Material::grid_for(double radius) const {
  for (const Grid& grid : grids_) {
    if (radius <= grid.reach) return grid;
  }
  throw_broken_promise("the radius asked about is among those announced", __FILE__, __LINE__);
}

/// The part of a sweep with the tip at or below z.
std::optional<Material::Sweep> Material::below(const Sweep& sweep, double z) {
  if (sweep.z_low > z) return std::nullopt;
  if (sweep.z_high <= z) return sweep;
  const double t = std::clamp((z - sweep.z_from) / (sweep.z_to - sweep.z_from), 0.0, 1.0);
  const double t0 = sweep.z_from > z ? t : 0, t1 = sweep.z_from > z ? 1 : t;
  const Vec2 a = sweep.path.at(t0), b = sweep.path.at(t1);
  const Edge part = a == b ? Edge::line(a, a) : sweep.path.part(t0, t1);
  return make_sweep(part, sweep.z_low, sweep.z_low, sweep.shape.radius);
}

/// mm; removed radius `above` mm over the tip; below 0: none.
double Material::radius_over(const Cutter& cutter, double above, bool is_own) const {
  const double radius = cutter.removes.radius_at(above);
  return is_own && above >= 0 ? std::max(radius, cutter.circle) : radius;
}

/// Calls f with the path and the shape of the area removed by a sweep at height z: for ramps of cutters with a
/// profile, with several shapes, together no larger than that area.
template <typename F>
void Material::for_parts_at(const Sweep& sweep, double z, int own, F&& f) const {
  if (sweep.z_low > z) return;
  if (sweep.cutter == kCylinder) {
    if (sweep.z_high <= z) return f(sweep.path, sweep.shape);
    const Sweep part = *below(sweep, z);
    return f(part.path, part.shape);
  }
  const Cutter& cutter = cutters_[static_cast<std::size_t>(sweep.cutter)];
  const auto with_profile = [&](const Edge& path, Swept shape, double tip) {
    shape.radius = radius_over(cutter, z - tip, sweep.cutter == own);
    if (shape.radius > 0) f(path, shape);
  };
  const double top = std::min(z, sweep.z_high);
  const int stretches = sweep.z_low < top ? kStretches : 1;
  for (int i = 0; i < stretches; ++i) {
    const double tip = top - (top - sweep.z_low) * i / stretches;
    if (tip >= sweep.z_high) {
      with_profile(sweep.path, sweep.shape, tip);
    } else {
      const Sweep part = *below(sweep, tip);
      with_profile(part.path, part.shape, tip);
    }
  }
}

/// The profile of what a sweep has removed.
CutterProfile Material::profile_of(const Sweep& sweep) const {
  return sweep.cutter == kCylinder ? CutterProfile::cylinder(sweep.shape.radius)
                                   : cutters_[static_cast<std::size_t>(sweep.cutter)].removes;
}

/// mm; lowest height at which the surface of a sweep's cutter, moved `aside` mm away, passed over p, which is `apart` mm
/// from the sweep's path; infinite if this height is not below `below`.
double Material::surface_over(const Sweep& sweep, Vec2 p, double apart, double aside, double below) const {
  const CutterProfile profile = profile_of(sweep);
  const double least = sweep.z_low + profile.height_at(apart + aside);
  if (least >= below) return std::numeric_limits<double>::infinity();
  if (sweep.z_low == sweep.z_high) return least;
  const auto height = [&](double t) {
    return sweep.z_from + (sweep.z_to - sweep.z_from) * t +
           profile.height_at(distance(sweep.path.at(t), p) + aside);
  };
  // Uphill of the nearest place both the tip and the surface over p rise.
  double near = nearest(sweep.path, p).t, far = sweep.z_to < sweep.z_from ? 1 : 0;
  double lowest = std::min(height(near), height(far));
  for (int i = 0; i < kSections; ++i) {
    const double a = near + (far - near) * (1 - kGolden), b = near + (far - near) * kGolden;
    const double at_a = height(a), at_b = height(b);
    lowest = std::min({lowest, at_a, at_b});
    (at_b < at_a ? near : far) = at_b < at_a ? a : b;
  }
  return lowest;
}

bool Material::is_removed(Vec2 p, double z, int own) const {
  if (z >= z_top_ || (plan_ && !plan_->contains(p))) return true;
  const List* near = grids_.front().at(p);
  if (!near) return false;
  // The latest sweeps first, since they reach deepest.
  for (auto i = near->rbegin(); i != near->rend(); ++i) {
    const Disc& disc = discs_[*i];
    if (disc.z_low > z || norm_squared(disc.middle - p) > disc.reach * disc.reach) continue;
    const Sweep& sweep = sweeps_[*i];
    if (sweep.cutter != kCylinder) {
      if (height_of(sweep, p, own, z_top_) <= z) return true;
      continue;
    }
    if (sweep.z_high <= z ? sweep.shape.covers(p) : below(sweep, z)->shape.covers(p)) return true;
  }
  return false;
}

/// mm; height down to which a sweep has removed the material over p, if its cutter is a cylinder; infinite if it has
/// not.
double Material::height_of_cylinder(const Sweep& sweep, Vec2 p) const {
  if (!sweep.shape.covers(p)) return std::numeric_limits<double>::infinity();
  double low = sweep.z_low,
         high = sweep.z_high;  // p is covered down to `high`, and perhaps not down to `low`
  if (below(sweep, low)->shape.covers(p)) high = low;
  while (high - low > 1e-6) {
    const double middle = (low + high) / 2;
    (below(sweep, middle)->shape.covers(p) ? high : low) = middle;
  }
  return high;
}

/// mm; height left by a sweep over p, with `own` the querying cutter; infinite if the height is not below `below`.
double Material::height_of(const Sweep& sweep, Vec2 p, int own, double below) const {
  if (sweep.cutter == kCylinder) return height_of_cylinder(sweep, p);
  const double surface = surface_over(sweep, p, distance(sweep.path, p), 0, below);
  if (sweep.cutter != own) return surface;
  Sweep upright = sweep;
  upright.shape.radius = cutters_[static_cast<std::size_t>(own)].circle;
  return std::min(surface, height_of_cylinder(upright, p));
}

double Material::height(Vec2 p, int own) const {
  if (plan_ && !plan_->contains(p)) return -std::numeric_limits<double>::infinity();
  double height = z_top_;
  const List* near = grids_.front().at(p);
  if (!near) return height;
  for (const std::uint32_t i : *near) {
    const Disc& disc = discs_[i];
    if (disc.z_low >= height || norm_squared(disc.middle - p) > disc.reach * disc.reach) continue;
    height = std::min(height, height_of(sweeps_[i], p, own, height));
  }
  return height;
}

void Material::remove_outside(EngagementArcs& arcs, Vec2 center, double radius) const {
  if (!plan_) return;
  arcs.remove_beyond({1, 0}, (plan_->max.x - center.x) / radius);
  arcs.remove_beyond({0, 1}, (plan_->max.y - center.y) / radius);
  arcs.remove_beyond({-1, 0}, (center.x - plan_->min.x) / radius);
  arcs.remove_beyond({0, -1}, (center.y - plan_->min.y) / radius);
}

void Material::remove_everything(EngagementArcs& arcs, Vec2 center, double radius, double z, int own) const {
  if (z >= z_top_) return arcs.clear();
  remove_outside(arcs, center, radius);
  const List* near = grid_for(radius).at(center);
  if (!near) return;
  // The latest sweeps first, because the circle most often touches the latest cuts.
  for (auto i = near->rbegin(); i != near->rend() && !arcs.empty(); ++i) {
    const Disc& disc = discs_[*i];
    if (disc.z_low > z || !arcs.may_meet(disc.middle, disc.reach)) continue;
    const Sweep& sweep = sweeps_[*i];
    if (sweep.cutter == kCylinder) {
      arcs.remove(sweep.z_high <= z ? sweep.shape : below(sweep, z)->shape);
    } else {
      for_parts_at(sweep, z, own, [&](const Edge&, const Swept& shape) {
        if (!arcs.empty()) arcs.remove(shape);
      });
    }
  }
}

namespace {

CutterEngagement engagement_of(const EngagementArcs& arcs) {
  CutterEngagement engagement{arcs.angles(), 0, 0, 0};
  for (const AngleInterval& item : engagement.angles.intervals()) {
    engagement.left += std::max(0.0, item.to) - std::max(0.0, item.from);
    engagement.right += std::min(0.0, item.to) - std::min(0.0, item.from);
  }
  engagement.angle = engagement.left + engagement.right;
  return engagement;
}

}  // namespace

CutterEngagement Material::engagement(Vec2 center, Vec2 direction, double radius, double z) const {
  EngagementArcs arcs(center, radius, direction, EngagementArcs::Part::kFront);
  remove_everything(arcs, center, radius, z);
  return engagement_of(arcs);
}

CutterEngagement Material::engagement(const Move& move, double t, double radius, int own) const {
  const double z = move.z_from + (move.z_to - move.z_from) * t;
  const Vec2 center = move.path.at(t), direction = move.path.tangent_at(t);
  EngagementArcs arcs(center, radius, direction, EngagementArcs::Part::kFront);
  remove_everything(arcs, center, radius, z, own);
  // A straight move never meets its own beginning with its front half; an arc may. The volume passed by a descending
  // move ended higher than its tip is now, so it does not count.
  const bool counts = move.path.is_arc() && move.z_to >= move.z_from;
  const int pieces = counts ? static_cast<int>(std::ceil(std::abs(move.path.sweep()) * t / kPieceSweep)) : 0;
  for (int i = 0; i < pieces && !arcs.empty(); ++i) {
    const Edge piece = move.path.part(t * i / pieces, t * (i + 1) / pieces);
    arcs.remove(make_sweep(piece, z, z, radius).shape);
  }
  return engagement_of(arcs);
}

EngagementSize Material::engagement_size(Vec2 center, Vec2 direction, double radius, double z) const {
  EngagementArcs arcs(center, radius, direction, EngagementArcs::Part::kFront);
  remove_everything(arcs, center, radius, z);
  return {arcs.measure(), arcs.parts()};
}

EngagementTrend Material::engagement_trend(Vec2 center, Vec2 direction, double radius, double z) const {
  EngagementArcs arcs(center, radius, direction, EngagementArcs::Part::kFront);
  remove_everything(arcs, center, radius, z);
  return {{arcs.measure(), arcs.parts()}, arcs.change()};
}

std::optional<CircleTouch> Material::circle_touch(Vec2 center, double radius, double z) const {
  EngagementArcs arcs(center, radius, {1, 0}, EngagementArcs::Part::kWhole);
  remove_everything(arcs, center, radius, z);
  if (arcs.empty()) return std::nullopt;
  return CircleTouch{arcs.measure(), arcs.middle_of_widest()};
}

AngleSet Material::circle_in_material(Vec2 center, double radius, double z) const {
  EngagementArcs arcs(center, radius, {1, 0}, EngagementArcs::Part::kWhole);
  remove_everything(arcs, center, radius, z);
  return arcs.angles();
}

// Searches for material within reach of a path: by area, in cells divided until decided.

namespace {

/// mm; half the side of the smallest cells, only their middle is tested.
constexpr double kSmallest = 0.01;
constexpr double kDiagonal = 1.41421356237309515;

struct Cover {
  Edge path;
  double radius;
};

class AreaSearch {
 public:
  /// `near`: mm from a cleared area within which a place does not count as material.
  AreaSearch(const Edge& path, double radius, const std::optional<Box>& plan, std::vector<Cover> covers,
             double near)
      : path_(path), radius_(radius), plan_(plan), covers_(std::move(covers)), beside_(near) {
    for (std::size_t i = 0; i < covers_.size(); ++i) near_.push_back(i);
  }

  std::optional<Vec2> run() {
    const Box box = (path_.from == path_.to ? Box{path_.from, path_.from} : path_.box()).grown(radius_);
    return visit(box.center(), std::max(box.width(), box.height()) / 2, 0, near_.size());
  }

 private:
  bool inside(Vec2 p) const { return distance(path_, p) < radius_ && (!plan_ || plan_->contains(p)); }

  /// A point of the cell with possible material: its middle, or its point in the block nearest to the path.
  std::optional<Vec2> place_in(Vec2 center, double half) const {
    if (inside(center)) return center;
    const Vec2 on = nearest(path_, center).point;
    const Vec2 p{std::clamp(on.x, center.x - half, center.x + half),
                 std::clamp(on.y, center.y - half, center.y + half)};
    return inside(p) ? std::optional(p) : std::nullopt;
  }

  std::optional<Vec2> visit(Vec2 center, double half, std::size_t begin, std::size_t end) {
    const double reach = half * kDiagonal;
    if (distance(path_, center) - reach >= radius_) return std::nullopt;
    const Box cell{{center.x - half, center.y - half}, {center.x + half, center.y + half}};
    if (plan_ && !cell.overlaps(*plan_)) return std::nullopt;
    const std::size_t mark = near_.size();
    bool middle_free = false;
    for (std::size_t k = begin; k < end; ++k) {
      const Cover& cover = covers_[near_[k]];
      const double apart = distance(cover.path, center) - cover.radius;
      if (apart + reach <= 0) {
        near_.resize(mark);
        return std::nullopt;
      }
      middle_free = middle_free || apart <= beside_;
      if (apart - reach < 0) near_.push_back(near_[k]);
    }
    const auto found = search(center, half, mark, middle_free);
    near_.resize(mark);
    return found;
  }

  std::optional<Vec2> search(Vec2 center, double half, std::size_t mark, bool middle_free) {
    if (!middle_free && inside(center)) return center;
    if (near_.size() == mark) {
      if (const auto place = place_in(center, half)) return place;
    }
    if (half <= kSmallest) return std::nullopt;
    const std::size_t end = near_.size();
    for (int i = 0; i < 4; ++i) {
      const double h = half / 2;
      const Vec2 quarter{center.x + ((i & 1) != 0 ? h : -h), center.y + ((i & 2) != 0 ? h : -h)};
      if (const auto found = visit(quarter, h, mark, end)) return found;
    }
    return std::nullopt;
  }

  const Edge& path_;
  double radius_;
  const std::optional<Box>& plan_;
  std::vector<Cover> covers_;
  double beside_;
  /// Stack of indices: the covers touching each of the cells from the whole down to the current one.
  std::vector<std::size_t> near_;
};

}  // namespace

/// Ascending indices of sweeps: all sweeps touched by a disc of `radius` on the path, and others.
Material::List Material::sweeps_about(const Edge& path, double radius) const {
  const Box box = path.from == path.to ? Box{path.from, path.from} : path.box();
  List found;
  for (const Grid& grid : grids_) {
    if (radius > grid.reach) continue;
    const int x0 = grid.place(box.min.x), x1 = grid.place(box.max.x);
    const int y0 = grid.place(box.min.y), y1 = grid.place(box.max.y);
    // The box of a long inclined path covers more cells than there are sweeps.
    const double cells = (1.0 + x1 - x0) * (1.0 + y1 - y0);
    if (cells > static_cast<double>(sweeps_.size()) / 8) break;
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        if (const List* list = grid.at(x, y)) found.insert(found.end(), list->begin(), list->end());
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }
  found.resize(sweeps_.size());
  std::iota(found.begin(), found.end(), 0U);
  return found;
}

std::optional<Vec2> Material::in_reach(const Edge& path, double radius, double z, int own,
                                       double sliver) const {
  if (z >= z_top_ || radius <= 0) return std::nullopt;
  const Box box = (path.from == path.to ? Box{path.from, path.from} : path.box()).grown(radius);
  std::vector<Cover> covers;
  for (const std::uint32_t i : sweeps_about(path, radius)) {
    const Sweep& sweep = sweeps_[i];
    if (sweep.z_low > z || (sweep.cutter != own && profile_of(sweep).widest <= 0)) continue;
    const Box swept =
        (sweep.path.from == sweep.path.to ? Box{sweep.path.from, sweep.path.from} : sweep.path.box())
            .grown(sweep.shape.radius);
    if (!swept.overlaps(box)) continue;
    // The area removed by ramps with a profile at one height is no strip of constant width.
    if (sweep.cutter != kCylinder && sweep.cutter != own && sweep.z_low < sweep.z_high)
      return in_reach_of_profile(path, CutterProfile::cylinder(radius), z, sliver);
    for_parts_at(sweep, z, own, [&](const Edge& part, const Swept& shape) {
      covers.push_back({part, shape.radius});
    });
  }
  return AreaSearch(path, radius, plan_, std::move(covers), sliver / 2).run();
}

/// Searches for a place with material inside a cutter with a profile, in cells as above: both surfaces are bounded in
/// each.
class ProfileSearch {
 public:
  /// `near`: mm, as of AreaSearch.
  ProfileSearch(const Material& material, const Edge& path, const CutterProfile& cutter, double z,
                std::vector<const Material::Sweep*> sweeps, double near)
      : material_(material),
        path_(path),
        cutter_(cutter),
        z_(z),
        radius_(cutter.radius_at(material.z_top_ - z)),
        near_(std::move(sweeps)),
        beside_(near) {}

  std::optional<Vec2> run() {
    const Box box = (path_.from == path_.to ? Box{path_.from, path_.from} : path_.box()).grown(radius_);
    return visit(box.center(), std::max(box.width(), box.height()) / 2, 0, near_.size());
  }

 private:
  /// mm; half the side of the smallest cells.
  static constexpr double kSmallestHalf = 0.02;

  /// mm; the cutter's surface over a place at this distance from its path.
  double surface(double apart) const { return z_ + cutter_.height_at(std::max(0.0, apart)); }
  bool is_in_block(Vec2 p) const { return !material_.plan_ || material_.plan_->contains(p); }

  /// Whether uncut material at p reaches into the cutter.
  bool meets_top(Vec2 p) const { return is_in_block(p) && surface(distance(path_, p)) < material_.z_top_; }

  /// A point of the cell in the cutter's path and in uncut material: its middle, or its point nearest to the path.
  std::optional<Vec2> place_in(Vec2 center, double half) const {
    if (meets_top(center)) return center;
    const Vec2 on = nearest(path_, center).point;
    const Vec2 p{std::clamp(on.x, center.x - half, center.x + half),
                 std::clamp(on.y, center.y - half, center.y + half)};
    return meets_top(p) ? std::optional(p) : std::nullopt;
  }

  /// Whether a sweep has removed all material over `low` within `reach` of the center, which is `apart` mm from its path.
  bool frees(const Material::Sweep& sweep, Vec2 center, double apart, double reach, double low) const {
    if (sweep.z_low > low) return false;
    const double above = std::nextafter(low, std::numeric_limits<double>::infinity());
    return material_.surface_over(sweep, center, apart, reach, std::min(above, material_.z_top_)) <= low;
  }

  /// Whether a sweep has removed the material over `low` at the center, `apart` mm from its path, or at a place as near
  /// to it as slivers are thin.
  bool frees_beside(const Material::Sweep& sweep, Vec2 center, double apart, double low) const {
    if (frees(sweep, center, apart, 0, low)) return true;
    if (beside_ <= 0 || !may_free(sweep, apart - beside_, low)) return false;
    constexpr double kSkew = kDiagonal / 2;
    for (const Vec2 aside : {Vec2{1, 0}, Vec2{kSkew, kSkew}, Vec2{0, 1}, Vec2{-kSkew, kSkew}}) {
      for (const Vec2 p : {center + aside * beside_, center - aside * beside_}) {
        if (frees(sweep, p, distance(sweep.path, p), 0, low)) return true;
      }
    }
    return false;
  }

  /// Whether a sweep, at its lowest, comes down to `low` at a distance of `apart` mm from its path; rounding excepted.
  bool may_free(const Material::Sweep& sweep, double apart, double low) const {
    constexpr double kRounding = 1e-9;
    return sweep.z_low + material_.profile_of(sweep).height_at(apart - kRounding) <= low + kRounding;
  }

  std::optional<Vec2> visit(Vec2 center, double half, std::size_t begin, std::size_t end) {
    const double reach = half * kDiagonal, apart = distance(path_, center);
    if (apart - reach >= radius_) return std::nullopt;
    const Box cell{{center.x - half, center.y - half}, {center.x + half, center.y + half}};
    if (material_.plan_ && !cell.overlaps(*material_.plan_)) return std::nullopt;
    const double low = surface(apart - reach), here = surface(apart);
    if (low >= material_.z_top_) return std::nullopt;
    if (last_ != nullptr && frees(*last_, center, distance(last_->path, center), reach, low))
      return std::nullopt;
    const std::size_t mark = near_.size();
    bool middle_free = false;
    for (std::size_t k = begin; k < end; ++k) {
      const Material::Sweep& sweep = *near_[k];
      const double to_path = distance(sweep.path, center);
      if (frees(sweep, center, to_path, reach, low)) {
        last_ = &sweep;
        near_.resize(mark);
        return std::nullopt;
      }
      middle_free = middle_free || frees_beside(sweep, center, to_path, here);
      if (to_path - reach < sweep.shape.radius) near_.push_back(near_[k]);
    }
    const auto found = search(center, half, mark, middle_free);
    near_.resize(mark);
    return found;
  }

  std::optional<Vec2> search(Vec2 center, double half, std::size_t mark, bool middle_free) {
    if (!middle_free && meets_top(center)) return center;
    if (near_.size() == mark) {
      if (const auto place = place_in(center, half)) return place;
    }
    if (half <= kSmallestHalf) return std::nullopt;
    const std::size_t end = near_.size();
    for (int i = 0; i < 4; ++i) {
      const double h = half / 2;
      const Vec2 quarter{center.x + ((i & 1) != 0 ? h : -h), center.y + ((i & 2) != 0 ? h : -h)};
      if (const auto found = visit(quarter, h, mark, end)) return found;
    }
    return std::nullopt;
  }

  const Material& material_;
  const Edge& path_;
  const CutterProfile cutter_;
  const double z_;
  /// mm; radius of the cutter at the height of the material's top.
  const double radius_;
  std::vector<const Material::Sweep*> near_;  ///< stack as of AreaSearch
  double beside_;
  /// The sweep that freed the last cell: the next cells are beside it.
  const Material::Sweep* last_ = nullptr;
};

std::optional<Vec2> Material::in_reach(const Edge& path, const CutterProfile& cutter, double z,
                                       double sliver) const {
  return cutter.is_cylinder() ? in_reach(path, cutter.widest, z, kCylinder, sliver)
                              : in_reach_of_profile(path, cutter, z, sliver);
}

std::optional<Vec2> Material::in_reach_of_profile(const Edge& path, const CutterProfile& cutter, double z,
                                                  double sliver) const {
  const double radius = cutter.radius_at(z_top_ - z);
  if (z >= z_top_ || radius <= 0) return std::nullopt;
  const Box box = (path.from == path.to ? Box{path.from, path.from} : path.box()).grown(radius);
  std::vector<const Sweep*> near;
  for (const std::uint32_t i : sweeps_about(path, radius)) {
    const Sweep& sweep = sweeps_[i];
    if (profile_of(sweep).widest <= 0) continue;
    const Box swept =
        (sweep.path.from == sweep.path.to ? Box{sweep.path.from, sweep.path.from} : sweep.path.box())
            .grown(sweep.shape.radius);
    if (swept.overlaps(box)) near.push_back(&sweep);
  }
  return ProfileSearch(*this, path, cutter, z, std::move(near), sliver / 2).run();
}

}  // namespace clearcut::stock
