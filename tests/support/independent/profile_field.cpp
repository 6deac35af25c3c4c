#include "support/independent/profile_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clearcut::test_support {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr double kDegree = 0.017453292519943295;
/// Steps along a way, of a cell.
constexpr double kStep = 0.8;

using Gap = ProfileField::Gap;

/// Adds a range to ranges that lie apart.
void add_gap(std::vector<Gap>& gaps, Gap gap) {
  std::vector<Gap> apart;
  for (const Gap& other : gaps) {
    if (other.high < gap.low || other.low > gap.high) {
      apart.push_back(other);
    } else {
      gap = {std::min(gap.low, other.low), std::max(gap.high, other.high)};
    }
  }
  apart.push_back(gap);
  gaps = std::move(apart);
}

}  // namespace

double TurnedBody::steepness() const {
  return end == End::kCone ? 1 / std::tan(angle * kDegree / 2) : 0;
}

double TurnedBody::surface(double distance, double steep) const {
  const double radius = diameter / 2;
  if (distance > radius) return kEndless;
  switch (end) {
    case End::kFlat:
    case End::kDisc:
      return 0;
    case End::kRounded: {
      const double out = std::max(0.0, distance - (radius - round));
      return round - std::sqrt(std::max(0.0, round * round - out * out));
    }
    case End::kCone:
      return std::max(0.0, distance - tip / 2) * steep;
  }
  return 0;
}

ProfileField::ProfileField(double x0, double y0, double x1, double y1, double cell, double bottom)
    : x0_(x0),
      y0_(y0),
      bottom_(bottom),
      cell_(cell),
      half_(cell * std::sqrt(0.5)),
      columns_(static_cast<int>(std::lround((x1 - x0) / cell))),
      rows_(static_cast<int>(std::lround((y1 - y0) / cell))),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

/// Calls visit(cell, distance from the axis, height of the tip, how far the tip is from there at most, and how much its height differs)
/// for the cells that matters(cell, height of the tip, how much it differs) names.
template <typename Matters, typename Visit>
void ProfileField::along(const TurnedBody& body, const BodyWay& way, Matters matters, Visit visit) const {
  const double dx = way.x1 - way.x0, dy = way.y1 - way.y0, dz = way.z1 - way.z0;
  const double length = std::hypot(dx, dy);
  const double reach = body.diameter / 2 + 1.25 * cell_;
  if (length <= 0 || dz == 0) {
    const double z = std::min(way.z0, way.z1);
    near(way, reach, [&](std::size_t cell, double ax, double ay) {
      if (!matters(cell, z, 0)) return;
      const double t = length > 0 ? std::clamp((ax * dx + ay * dy) / (length * length), 0.0, 1.0) : 0;
      visit(cell, std::hypot(ax - t * dx, ay - t * dy), z, 0, 0);
    });
    return;
  }
  const int steps = 1 + static_cast<int>(std::max(length, std::abs(dz)) / (kStep * cell_));
  const double aside = length / steps / 2, differs = std::abs(dz) / steps / 2;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps, x = way.x0 + dx * t, y = way.y0 + dy * t;
    const double z = way.z0 + dz * t;
    near({x, y, z, x, y, z}, reach, [&](std::size_t cell, double ax, double ay) {
      if (matters(cell, z, differs)) visit(cell, std::sqrt(ax * ax + ay * ay), z, aside, differs);
    });
  }
}

/// Calls visit(cell, how far its centre lies from the way's begin in x, in y) for the cells around a way.
template <typename Visit>
void ProfileField::near(const BodyWay& way, double reach, Visit visit) const {
  const auto column = [&](double v) {
    return std::clamp(static_cast<int>(std::floor((v - x0_) / cell_)), 0, columns_ - 1);
  };
  const auto row = [&](double v) {
    return std::clamp(static_cast<int>(std::floor((v - y0_) / cell_)), 0, rows_ - 1);
  };
  const auto [left, right] = std::minmax(way.x0, way.x1);
  const auto [low, high] = std::minmax(way.y0, way.y1);
  const int first_column = column(left - reach), last_column = column(right + reach),
            last_row = row(high + reach);
  for (int r = row(low - reach); r <= last_row; ++r) {
    for (int c = first_column; c <= last_column; ++c)
      visit(static_cast<std::size_t>(r * columns_ + c), x0_ + (c + 0.5) * cell_ - way.x0,
            y0_ + (r + 0.5) * cell_ - way.y0);
  }
}

void ProfileField::cut(const TurnedBody& body, const BodyWay& way) {
  std::vector<Cell>& cells = cells_;
  const double steep = body.steepness(), radius = body.diameter / 2;
  const bool is_disc = body.end == TurnedBody::End::kDisc;
  // No body is below its tip.
  const auto matters = [&](std::size_t i, double z, double dz) {
    return is_disc || cells[i].certain > z - dz || cells[i].possible > z;
  };
  along(body, way, matters, [&](std::size_t i, double apart, double z, double aside, double dz) {
    Cell& cell = cells[i];
    const double least = std::max(0.0, apart - half_ - aside);
    if (is_disc) {
      const double top = least < body.neck / 2 ? kEndless : z + dz + body.height;
      if (least < radius) add_gap(perhaps_undercut_[i], {z - dz, top});
      if (apart + half_ <= radius) add_gap(undercut_[i], {z, z + body.height});
      return;
    }
    cell.certain = std::min(cell.certain, z - dz + body.surface(least, steep));
    if (body.removes) cell.possible = std::min(cell.possible, z + body.surface(apart + half_, steep));
  });
}

double ProfileField::standing(std::size_t cell, double low, double high) const {
  low = std::max(low, bottom_);
  high = std::min(high, cells_[cell].certain);
  double sum = high - low;
  const auto gaps = perhaps_undercut_.find(cell);
  if (gaps == perhaps_undercut_.end() || sum <= 0) return sum;
  for (const Gap& gap : gaps->second) sum -= std::max(0.0, std::min(high, gap.high) - std::max(low, gap.low));
  return sum;
}

ProfileField::Hit ProfileField::hit(const TurnedBody& body, const BodyWay& way) const {
  Hit hit;
  const double steep = body.steepness(), radius = body.diameter / 2;
  const bool is_disc = body.end == TurnedBody::End::kDisc;
  const auto matters = [&](std::size_t i, double z, double dz) {
    return cells_[i].certain > z || cells_[i].possible > z - dz;
  };
  along(body, way, matters, [&](std::size_t i, double apart, double z, double aside, double dz) {
    const Cell& cell = cells_[i];
    const double least = std::max(0.0, apart - half_ - aside);
    if (!is_disc) {
      const double surface = z + body.surface(apart + half_, steep);
      if (cell.certain > surface) hit.certain = std::max(hit.certain, standing(i, surface, kEndless));
    } else if (apart + half_ <= radius) {
      const double top = apart + half_ <= body.neck / 2 ? kEndless : z + body.height;
      hit.certain = std::max(hit.certain, standing(i, z, top));
    }
    const double lowest = std::max(bottom_, z - dz + body.surface(least, steep));
    hit.possible = std::max(hit.possible, cell.possible - lowest);
  });
  return hit;
}

std::size_t ProfileField::index_of(double x, double y) const {
  const int c = std::clamp(static_cast<int>((x - x0_) / cell_), 0, columns_ - 1);
  const int r = std::clamp(static_cast<int>((y - y0_) / cell_), 0, rows_ - 1);
  return static_cast<std::size_t>(r * columns_ + c);
}

double ProfileField::certain_at(double x, double y) const {
  return cells_[index_of(x, y)].certain;
}

double ProfileField::possible_at(double x, double y) const {
  return cells_[index_of(x, y)].possible;
}

double ProfileField::standing_at(double x, double y, double low, double high) const {
  return std::max(0.0, standing(index_of(x, y), low, high));
}

std::vector<Gap> ProfileField::undercut_at(double x, double y) const {
  const auto found = undercut_.find(index_of(x, y));
  return found == undercut_.end() ? std::vector<Gap>{} : found->second;
}

}  // namespace clearcut::test_support
