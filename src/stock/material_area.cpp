// Searches for material within reach of a path: by area, in cells divided until decided.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "stock/material.h"

namespace clearcut::stock {
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
    if (sweep.z_low > z) continue;
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

  /// Whether a sweep has removed all material over `low` within `reach` of the center.
  bool frees(const Material::Sweep& sweep, Vec2 center, double reach, double low) const {
    const double above = std::nextafter(low, std::numeric_limits<double>::infinity());
    return material_.surface_over(sweep, center, reach, std::min(above, material_.z_top_)) <= low;
  }

  /// Whether a sweep has removed the material over `low` at the center, or at a place as near to it as slivers are thin.
  bool frees_beside(const Material::Sweep& sweep, Vec2 center, double low) const {
    if (frees(sweep, center, 0, low)) return true;
    if (beside_ <= 0) return false;
    constexpr double kSkew = kDiagonal / 2;
    for (const Vec2 aside : {Vec2{1, 0}, Vec2{kSkew, kSkew}, Vec2{0, 1}, Vec2{-kSkew, kSkew}}) {
      if (frees(sweep, center + aside * beside_, 0, low) || frees(sweep, center - aside * beside_, 0, low))
        return true;
    }
    return false;
  }

  std::optional<Vec2> visit(Vec2 center, double half, std::size_t begin, std::size_t end) {
    const double reach = half * kDiagonal, apart = distance(path_, center);
    if (apart - reach >= radius_) return std::nullopt;
    const Box cell{{center.x - half, center.y - half}, {center.x + half, center.y + half}};
    if (material_.plan_ && !cell.overlaps(*material_.plan_)) return std::nullopt;
    const double low = surface(apart - reach), here = surface(apart);
    if (low >= material_.z_top_) return std::nullopt;
    if (last_ != nullptr && frees(*last_, center, reach, low)) return std::nullopt;
    const std::size_t mark = near_.size();
    bool middle_free = false;
    for (std::size_t k = begin; k < end; ++k) {
      const Material::Sweep& sweep = *near_[k];
      if (frees(sweep, center, reach, low)) {
        last_ = &sweep;
        near_.resize(mark);
        return std::nullopt;
      }
      middle_free = middle_free || frees_beside(sweep, center, here);
      if (distance(sweep.path, center) - reach < sweep.shape.radius) near_.push_back(near_[k]);
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

std::optional<Vec2> Material::in_reach(const Edge& path, const CutterProfile& cutter, double z) const {
  return cutter.is_cylinder() ? in_reach(path, cutter.widest, z) : in_reach_of_profile(path, cutter, z);
}

std::optional<Vec2> Material::in_reach_of_profile(const Edge& path, const CutterProfile& cutter, double z,
                                                  double sliver) const {
  const double radius = cutter.radius_at(z_top_ - z);
  if (z >= z_top_ || radius <= 0) return std::nullopt;
  const Box box = (path.from == path.to ? Box{path.from, path.from} : path.box()).grown(radius);
  std::vector<const Sweep*> near;
  for (const std::uint32_t i : sweeps_about(path, radius)) {
    const Sweep& sweep = sweeps_[i];
    const Box swept =
        (sweep.path.from == sweep.path.to ? Box{sweep.path.from, sweep.path.from} : sweep.path.box())
            .grown(sweep.shape.radius);
    if (swept.overlaps(box)) near.push_back(&sweep);
  }
  return ProfileSearch(*this, path, cutter, z, std::move(near), sliver / 2).run();
}

}  // namespace clearcut::stock
