#include "verify/coverage/convex.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace clearcut::verify {
namespace {

constexpr int kHullPoints = 48;

bool before(Vec2 a, Vec2 b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

}  // namespace

void ConvexPolygon::add(Vec2 p) {
  CLEARCUT_ASSERT(count_ < kCapacity);
  points_[count_++] = p;
}

ConvexPolygon ConvexPolygon::square(Vec2 center, double half) {
  ConvexPolygon polygon;
  polygon.add({center.x - half, center.y - half});
  polygon.add({center.x + half, center.y - half});
  polygon.add({center.x + half, center.y + half});
  polygon.add({center.x - half, center.y + half});
  return polygon;
}

/// Computed by the monotone chain.
ConvexPolygon ConvexPolygon::hull(std::span<Vec2> points) {
  std::sort(points.begin(), points.end(), before);
  const auto end = std::unique(points.begin(), points.end());
  const int n = static_cast<int>(end - points.begin());
  ConvexPolygon polygon;
  if (n <= 2) {
    for (int i = 0; i < n; ++i) polygon.add(points[i]);
    return polygon;
  }
  if (n > kHullPoints) {
    Box box;
    for (int i = 0; i < n; ++i) box.add(points[i]);
    for (const Vec2 p : {box.min, Vec2{box.max.x, box.min.y}, box.max, Vec2{box.min.x, box.max.y}})
      polygon.add(p);
    return polygon;
  }
  std::array<Vec2, 2 * kHullPoints> chain;
  int k = 0;
  const auto push = [&](Vec2 p, int keep) {
    while (k >= keep && cross(chain[k - 1] - chain[k - 2], p - chain[k - 2]) <= 0) --k;
    chain[k++] = p;
  };
  for (int i = 0; i < n; ++i) push(points[i], 2);
  const int lower = k + 1;
  for (int i = n - 2; i >= 0; --i) push(points[i], lower);
  for (int i = 0; i < k - 1; ++i) polygon.add(chain[i]);
  return polygon;
}

Vec2 ConvexPolygon::centroid() const {
  Vec2 sum;
  for (const Vec2 p : points()) sum = sum + p;
  return count_ ? sum / count_ : sum;
}

double ConvexPolygon::area() const {
  double twice = 0;
  for (int i = 1; i + 1 < count_; ++i) twice += cross(points_[i] - points_[0], points_[i + 1] - points_[0]);
  return twice / 2;
}

ConvexPolygon ConvexPolygon::clipped(Vec2 normal, double offset) const {
  ConvexPolygon out;
  if (count_ == 1 && dot(normal, points_[0]) >= offset) return *this;
  for (int i = 0; i < count_ && count_ > 1; ++i) {
    const Vec2 a = points_[i], b = points_[(i + 1) % count_];
    const double da = dot(normal, a) - offset, db = dot(normal, b) - offset;
    if (da >= 0) out.add(a);
    if ((da < 0) != (db < 0)) out.add(lerp(a, b, da / (da - db)));
  }
  return out;
}

double ConvexPolygon::farthest_from(Vec2 p) const {
  double most = 0;
  for (const Vec2 q : points()) most = std::max(most, norm_squared(q - p));
  return std::sqrt(most);
}

double ConvexPolygon::nearest_to(Vec2 p) const {
  double least = std::numeric_limits<double>::infinity();
  bool inside = count_ > 2;
  for (int i = 0; i < count_; ++i) {
    const Vec2 a = points_[i], d = points_[(i + 1) % count_] - a;
    inside = inside && cross(d, p - a) >= 0;
    const double length = norm_squared(d);
    const double t = length > 0 ? std::clamp(dot(p - a, d) / length, 0.0, 1.0) : 0;
    least = std::min(least, norm_squared(a + d * t - p));
  }
  return inside ? 0 : std::sqrt(least);
}

}  // namespace clearcut::verify
