#include "plan/cover/witnesses.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace clearcut::plan::cover {
namespace {

/// Count with which raster points outside the area begin, so that their count never becomes 0.
constexpr std::uint8_t kOutside = 128;
/// Curves count as chords no farther from them than this share of the radius.
constexpr double kChordShare = 1e-3;
/// Points along the boundary are closer to each other than those of the raster by this factor.
constexpr double kBoundaryShare = 0.6;
/// Radians, of the raster against x. Its tangent is derived from the golden ratio, so that no simple direction
/// coincides with it.
constexpr double kRasterAngle = 0.5535743588970452;
/// Cells of boundary points, as a share of the radius.
constexpr double kBucketShare = 0.7;

double squared_distance_to_move(Vec2 a, Vec2 b, Vec2 p) {
  const Vec2 along = b - a, to = p - a;
  const double whole = norm_squared(along), t = dot(to, along);
  if (t <= 0 || whole == 0) return norm_squared(to);
  if (t >= whole) return norm_squared(p - b);
  const double aside = cross(along, to);
  return aside * aside / whole;
}

/// Order of the ends by which a move is the same in both directions.
bool in_order(Vec2 a, Vec2 b) {
  return a.y < b.y || (a.y == b.y && a.x <= b.x);
}

}  // namespace

ClearedBand::ClearedBand(Vec2 a, Vec2 b, double radius) : a_(a), b_(b), radius_(radius) {
  const Vec2 way = b - a;
  const double length = norm(way);
  is_point_ = length == 0;
  if (is_point_) return;
  level_ = way.y == 0;
  upright_ = way.x == 0;
  if (!level_) {
    slope_ = way.x / way.y;
    half_ = radius * length / std::abs(way.y);
  }
  if (!upright_) {
    back_ = way.y / way.x;
    along_ = length * (length / way.x);
  }
}

ClearedBand::Run ClearedBand::at(double y) const {
  Run run;
  const double r2 = radius_ * radius_, dy = y - a_.y, dyb = y - b_.y;
  if (const double rest = r2 - dy * dy; rest >= 0) {
    const double half = std::sqrt(rest);
    run = {a_.x - half, a_.x + half};
  }
  if (is_point_) return run;
  if (const double rest = r2 - dyb * dyb; rest >= 0) {
    const double half = std::sqrt(rest);
    if (run.first > run.last)
      run = {b_.x - half, b_.x + half};
    else
      run = {std::min(run.first, b_.x - half), std::max(run.last, b_.x + half)};
  }
  double first = -1e300, last = 1e300;
  if (level_) {
    if (std::abs(dy) > radius_) return run;
  } else {
    const double middle = a_.x + slope_ * dy;
    first = middle - half_;
    last = middle + half_;
  }
  if (upright_) {
    if (dy * (b_.y - a_.y) < 0 || dy * (b_.y - a_.y) > (b_.y - a_.y) * (b_.y - a_.y)) return run;
  } else {
    const double begin = a_.x - back_ * dy, end = begin + along_;
    first = std::max(first, std::min(begin, end));
    last = std::min(last, std::max(begin, end));
  }
  if (first > last) return run;
  if (run.first > run.last) return {first, last};
  return {std::min(run.first, first), std::max(run.last, last)};
}

Witnesses::Witnesses(const Regions& area, double radius, double pitch)
    : cosine_(base::cos(kRasterAngle)),
      sine_(base::sin(kRasterAngle)),
      radius_(radius),
      pitch_(pitch),
      bucket_size_(kBucketShare * radius) {
  std::vector<std::vector<Vec2>> outlines;
  for (const Region& region : area) {
    outlines.push_back(flattened(region.outer(), kChordShare * radius));
    for (const Loop& island : region.islands()) outlines.push_back(flattened(island, kChordShare * radius));
  }
  Box box;
  for (auto& outline : outlines) {
    for (Vec2& p : outline) {
      p = turned(p);
      box.add(p);
    }
  }
  if (box.empty()) box = {{0, 0}, {0, 0}};
  corner_ = box.min;
  columns_ = static_cast<std::ptrdiff_t>(box.width() / pitch) + 1;
  rows_ = static_cast<std::ptrdiff_t>(box.height() / pitch) + 1;
  corner_ = corner_ + Vec2{0.5 * (box.width() - static_cast<double>(columns_ - 1) * pitch),
                           0.5 * (box.height() - static_cast<double>(rows_ - 1) * pitch)};
  bucket_columns_ = static_cast<std::ptrdiff_t>(box.width() / bucket_size_) + 2;
  bucket_rows_ = static_cast<std::ptrdiff_t>(box.height() / bucket_size_) + 2;
  buckets_.resize(static_cast<std::size_t>(bucket_columns_ * bucket_rows_));
  moves_.assign(static_cast<std::size_t>(columns_ * rows_), kOutside);
  mark_inside(outlines);
  for (const auto& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
      const int parts = std::max(1, static_cast<int>(std::ceil(distance(a, b) / (kBoundaryShare * pitch))));
      for (int k = 0; k < parts; ++k) {
        const Vec2 p = lerp(a, b, static_cast<double>(k) / parts);
        buckets_[bucket_of(p)].points.push_back({p, 0});
      }
    }
  }
}

void Witnesses::mark_inside(const std::vector<std::vector<Vec2>>& outlines) {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(rows_));
  for (const auto& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
      if (a.y == b.y) continue;
      if (a.y > b.y) std::swap(a, b);
      const auto first =
          std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(std::ceil((a.y - corner_.y) / pitch_)) - 1);
      for (std::ptrdiff_t row = first; row < rows_; ++row) {
        const double y = corner_.y + static_cast<double>(row) * pitch_;
        if (y >= b.y) break;
        if (y < a.y) continue;
        crossings[static_cast<std::size_t>(row)].push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
      }
    }
  }
  for (std::ptrdiff_t row = 0; row < rows_; ++row) {
    auto& cuts = crossings[static_cast<std::size_t>(row)];
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
      const auto first =
          std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(std::ceil((cuts[i] - corner_.x) / pitch_)));
      const auto last = std::min<std::ptrdiff_t>(
          columns_ - 1, static_cast<std::ptrdiff_t>(std::floor((cuts[i + 1] - corner_.x) / pitch_)));
      for (std::ptrdiff_t column = first; column <= last; ++column)
        moves_[static_cast<std::size_t>(row * columns_ + column)] = 0;
    }
  }
}

std::size_t Witnesses::bucket_of(Vec2 p) const {
  const auto column = std::clamp<std::ptrdiff_t>(
      static_cast<std::ptrdiff_t>((p.x - corner_.x) / bucket_size_), 0, bucket_columns_ - 1);
  const auto row = std::clamp<std::ptrdiff_t>(static_cast<std::ptrdiff_t>((p.y - corner_.y) / bucket_size_),
                                              0, bucket_rows_ - 1);
  return static_cast<std::size_t>(row * bucket_columns_ + column);
}

Witnesses::Columns Witnesses::columns_of(const ClearedBand& band, std::ptrdiff_t row) {
  ++work_;
  const ClearedBand::Run run = band.at(corner_.y + static_cast<double>(row) * pitch_);
  if (run.first > run.last) return {};
  const double scale = 1 / pitch_;
  const double from = std::max(0.0, std::ceil((run.first - corner_.x) * scale));
  const double to = std::min(static_cast<double>(columns_ - 1), std::floor((run.last - corner_.x) * scale));
  if (from > to) return {};
  return {static_cast<std::ptrdiff_t>(from), static_cast<std::ptrdiff_t>(to)};
}

std::ptrdiff_t Witnesses::row_from(double y) const {
  return std::max<std::ptrdiff_t>(0, static_cast<std::ptrdiff_t>(std::ceil((y - corner_.y) / pitch_)));
}

std::ptrdiff_t Witnesses::row_to(double y) const {
  return std::min<std::ptrdiff_t>(rows_ - 1,
                                  static_cast<std::ptrdiff_t>(std::floor((y - corner_.y) / pitch_)));
}

template <typename F>
void Witnesses::for_rows(Vec2 a, Vec2 b, const F& f) {
  if (!in_order(a, b)) std::swap(a, b);
  const ClearedBand band(a, b, radius_);
  const auto top = row_to(b.y + radius_);
  for (auto row = row_from(a.y - radius_); row <= top; ++row) {
    const Columns columns = columns_of(band, row);
    if (columns.first <= columns.last) f(row, columns.first, columns.last);
  }
}

void Witnesses::append(std::ptrdiff_t row, Columns columns, std::uint8_t moves,
                       std::vector<Vec2>& points) const {
  if (columns.first > columns.last) return;
  const std::uint8_t* counts = moves_.data() + row * columns_;
  const std::uint8_t* at = counts + columns.first;
  const std::uint8_t* end = counts + columns.last + 1;
  while (at < end) {
    at = static_cast<const std::uint8_t*>(std::memchr(at, moves, static_cast<std::size_t>(end - at)));
    if (at == nullptr) return;
    points.push_back(raster_point(at - counts, row));
    ++at;
  }
}

void Witnesses::only_cleared_by(const Vec2* from, Vec2 p, const Vec2* to, std::vector<Vec2>& points) {
  const bool has_a = from != nullptr, has_b = to != nullptr;
  p = turned(p);
  const Vec2 a = has_a ? turned(*from) : p, b = has_b ? turned(*to) : p;
  const double r2 = radius_ * radius_;
  const auto in = [&](Vec2 x) { return has_a && squared_distance_to_move(a, p, x) <= r2; };
  const auto out = [&](Vec2 x) { return has_b && squared_distance_to_move(p, b, x) <= r2; };
  if (has_a)
    for_points(a, p, [&](Point& point) {
      if (point.moves <= 2 && point.moves == 1 + (out(point.at) ? 1 : 0))
        points.push_back(turned_back(point.at));
    });
  if (has_b)
    for_points(p, b, [&](Point& point) {
      if (point.moves == 1 && !in(point.at)) points.push_back(turned_back(point.at));
    });
  const auto band = [&](Vec2 x, Vec2 y) {
    return in_order(x, y) ? ClearedBand(x, y, radius_) : ClearedBand(y, x, radius_);
  };
  const ClearedBand first = band(a, p), second = band(p, b);
  const double low = std::min({a.y, p.y, b.y}) - radius_, high = std::max({a.y, p.y, b.y}) + radius_;
  const double first_low = std::min(a.y, p.y) - radius_, first_high = std::max(a.y, p.y) + radius_;
  const double second_low = std::min(b.y, p.y) - radius_, second_high = std::max(b.y, p.y) + radius_;
  const auto top = row_to(high);
  for (auto row = row_from(low); row <= top; ++row) {
    const double y = corner_.y + static_cast<double>(row) * pitch_;
    Columns one, two;
    if (has_a && y >= first_low && y <= first_high) one = columns_of(first, row);
    if (has_b && y >= second_low && y <= second_high) two = columns_of(second, row);
    if (one.first > one.last || two.first > two.last || one.last < two.first || two.last < one.first) {
      append(row, one, 1, points);
      append(row, two, 1, points);
      continue;
    }
    append(row, {std::min(one.first, two.first), std::max(one.first, two.first) - 1}, 1, points);
    append(row, {std::max(one.first, two.first), std::min(one.last, two.last)}, 2, points);
    append(row, {std::min(one.last, two.last) + 1, std::max(one.last, two.last)}, 1, points);
  }
}

template <typename F>
void Witnesses::for_points(Vec2 a, Vec2 b, const F& f) {
  if (!in_order(a, b)) std::swap(a, b);
  const double reach = radius_ + 0.75 * bucket_size_;
  const auto bottom = std::clamp<std::ptrdiff_t>(
      static_cast<std::ptrdiff_t>(std::floor((a.y - radius_ - corner_.y) / bucket_size_)), 0,
      bucket_rows_ - 1);
  const auto top = std::clamp<std::ptrdiff_t>(
      static_cast<std::ptrdiff_t>(std::floor((b.y + radius_ - corner_.y) / bucket_size_)), 0,
      bucket_rows_ - 1);
  const double r2 = radius_ * radius_;
  const ClearedBand band(a, b, reach);
  for (std::ptrdiff_t row = bottom; row <= top; ++row) {
    const double y = corner_.y + (static_cast<double>(row) + 0.5) * bucket_size_;
    const ClearedBand::Run run = band.at(std::clamp(y, a.y - radius_, b.y + radius_));
    if (run.first > run.last) continue;
    const auto from = std::clamp<std::ptrdiff_t>(
        static_cast<std::ptrdiff_t>(std::floor((run.first - corner_.x) / bucket_size_)), 0,
        bucket_columns_ - 1);
    const auto to = std::clamp<std::ptrdiff_t>(
        static_cast<std::ptrdiff_t>(std::floor((run.last - corner_.x) / bucket_size_)), 0,
        bucket_columns_ - 1);
    for (std::ptrdiff_t column = from; column <= to; ++column) {
      for (Point& point : buckets_[static_cast<std::size_t>(row * bucket_columns_ + column)].points) {
        if (squared_distance_to_move(a, b, point.at) <= r2) f(point);
      }
    }
  }
}

void Witnesses::add(Vec2 a, Vec2 b) {
  a = turned(a);
  b = turned(b);
  for_rows(a, b, [&](std::ptrdiff_t row, std::ptrdiff_t from, std::ptrdiff_t to) {
    std::uint8_t* counts = moves_.data() + row * columns_;
    for (std::ptrdiff_t i = from; i <= to; ++i) ++counts[i];
  });
  for_points(a, b, [](Point& point) { ++point.moves; });
}

void Witnesses::remove(Vec2 a, Vec2 b) {
  a = turned(a);
  b = turned(b);
  for_rows(a, b, [&](std::ptrdiff_t row, std::ptrdiff_t from, std::ptrdiff_t to) {
    std::uint8_t* counts = moves_.data() + row * columns_;
    for (std::ptrdiff_t i = from; i <= to; ++i) --counts[i];
  });
  for_points(a, b, [](Point& point) { --point.moves; });
}

void Witnesses::remove(Vec2 a, Vec2 b, std::vector<Vec2>& bare) {
  a = turned(a);
  b = turned(b);
  for_points(a, b, [&](Point& point) {
    if (--point.moves == 0) bare.push_back(turned_back(point.at));
  });
  for_rows(a, b, [&](std::ptrdiff_t row, std::ptrdiff_t from, std::ptrdiff_t to) {
    std::uint8_t* counts = moves_.data() + row * columns_;
    for (std::ptrdiff_t i = from; i <= to; ++i) --counts[i];
    append(row, {from, to}, 0, bare);
  });
}

void Witnesses::add_point(Vec2 p, int moves) {
  const Vec2 at = turned(p);
  buckets_[bucket_of(at)].points.push_back({at, moves});
}

std::vector<Vec2> Witnesses::bare() const {
  std::vector<Vec2> bare;
  for (const Bucket& bucket : buckets_)
    for (const Point& point : bucket.points)
      if (point.moves == 0) bare.push_back(turned_back(point.at));
  for (std::ptrdiff_t row = 0; row < rows_; ++row) {
    for (std::ptrdiff_t column = 0; column < columns_; ++column) {
      if (moves_[static_cast<std::size_t>(row * columns_ + column)] == 0)
        bare.push_back(raster_point(column, row));
    }
  }
  return bare;
}

}  // namespace clearcut::plan::cover
