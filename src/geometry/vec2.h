// Points and directions of the plane, in mm.
#pragma once

#include "base/elementary.h"

namespace clearcut::inline geometry {

struct Vec2 {
  double x = 0;
  double y = 0;

  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
  friend constexpr Vec2 operator*(Vec2 a, double k) { return {a.x * k, a.y * k}; }
  friend constexpr Vec2 operator*(double k, Vec2 a) { return a * k; }
  friend constexpr Vec2 operator/(Vec2 a, double k) { return {a.x / k, a.y / k}; }
};

constexpr double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}
/// z of the cross product: > 0 when b is counter-clockwise of a.
constexpr double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}
inline double norm(Vec2 a) {
  return base::hypot(a.x, a.y);
}
constexpr double norm_squared(Vec2 a) {
  return dot(a, a);
}
inline double distance(Vec2 a, Vec2 b) {
  return norm(a - b);
}
/// Unit vector; `a` must not be zero.
inline Vec2 unit(Vec2 a) {
  return a / norm(a);
}
/// Turned by +90 degrees: the left normal.
constexpr Vec2 left_of(Vec2 a) {
  return {-a.y, a.x};
}
inline Vec2 direction_of(double radians) {
  return {base::cos(radians), base::sin(radians)};
}
inline double angle_of(Vec2 a) {
  return base::atan2(a.y, a.x);
}
inline Vec2 rotated(Vec2 a, double radians) {
  const double c = base::cos(radians), s = base::sin(radians);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}
constexpr Vec2 lerp(Vec2 a, Vec2 b, double t) {
  return a + (b - a) * t;
}

}  // namespace clearcut::inline geometry
