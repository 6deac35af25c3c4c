// Circles through points and along lines, by formulas that cancel as little as can be: the events of the
// Voronoi builder.
//
// The origin is a point of the sites. Points and directions are exact integers; a line is its direction
// (a, b) of length l and h, the distance of the origin to the right of it times l, hence a centre (x, y) on its right
// at the distance r has b x - a y + h = l r. In all formulas the radius is a sum of positive terms or comes from the
// product of both roots.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/voronoi/double_double.h"

namespace clearcut::inline geometry::voronoi {

/// Relative to the origin given to its maker. Coordinates and radius are off by at most `error` roundings of T;
/// `error` is infinite or not a number if there is no circle or no bound is known.
template <class T>
struct TangentCircle {
  T x, y, radius;
  double error = 0;
};

struct SitePoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

struct SiteLine {
  std::int64_t a = 0;
  std::int64_t b = 0;
  std::int64_t h = 0;
};

inline std::int64_t cross(SiteLine s, SiteLine t) {
  return s.a * t.b - s.b * t.a;
}
inline std::int64_t dot(SiteLine s, SiteLine t) {
  return s.a * t.a + s.b * t.b;
}
inline double leading(double value) {
  return value;
}
inline double leading(DoubleDouble value) {
  return value.high;
}
template <class T>
double magnitude(T value) {
  return std::abs(leading(value));
}
template <class T>
T hypotenuse(T a, T b) {
  using std::sqrt;
  return sqrt(a * a + b * b);
}

/// Through the origin, p and q.
template <class T>
TangentCircle<T> tangent_circle(SitePoint p, SitePoint q) {
  const T px(p.x), py(p.y), qx(q.x), qy(q.y);
  const T pp = px * px + py * py, qq = qx * qx + qy * qy;
  const T twice = T(p.x * q.y - p.y * q.x) * T(2.0);
  const T x = (pp * qy - qq * py) / twice, y = (qq * px - pp * qx) / twice;
  const double terms = magnitude(pp * qy) + magnitude(qq * py) + magnitude(qq * px) + magnitude(pp * qx);
  return {x, y, hypotenuse(x, y), 6 * terms / magnitude(twice)};
}

/// Through the origin and p, on the right of a line. The centre is p / 2 + t (p.y, -p.x); `larger` selects the larger
/// t of the two.
template <class T>
TangentCircle<T> tangent_circle(SitePoint p, SiteLine line, bool larger) {
  using std::sqrt;
  const std::int64_t h = line.h + line.b * p.x - line.a * p.y;
  const T px(p.x), py(p.y), half(0.5);
  const T mean = (T(line.h) + T(h)) * half, difference(h - line.h);
  const T product = hypotenuse(T(line.a), T(line.b)) * hypotenuse(px, py);
  const T turn = T(line.a * p.x + line.b * p.y) * mean, root = product * sqrt(T(line.h) * T(h));
  // t = (turn +- root) / difference^2; the cancelling root is computed from the product of both.
  const bool positive = leading(turn) >= 0;
  const T sum = positive ? turn + root : turn - root;
  T t;
  double off = 0;
  if (positive == larger) {
    t = sum / (difference * difference);
    off = magnitude(t);
  } else {
    const T other = product * half;
    t = (other - mean) * (other + mean) / sum;
    off = (leading(mean) * leading(mean) + leading(other) * leading(other)) / magnitude(sum);
  }
  const T x = px * half + t * py, y = py * half - t * px;
  return {x, y, hypotenuse(x, y), 24 * magnitude(hypotenuse(px, py)) * (1 + off)};
}

/// Through the origin, on the right of two lines; `larger` selects the larger one.
template <class T>
TangentCircle<T> tangent_circle(SiteLine s, SiteLine t, bool larger) {
  using std::sqrt;
  if (s.h < 0 || t.h < 0) return {T(0.0), T(0.0), T(0.0), std::numeric_limits<double>::infinity()};
  const T sa(s.a), sb(s.b), ta(t.a), tb(t.b), sh(s.h), th(t.h);
  const T sl = hypotenuse(sa, sb), tl = hypotenuse(ta, tb);
  const T across(cross(s, t)), along(dot(s, t)), product = sl * tl;
  // product - along and product + along; their own product is across^2.
  const bool same_way = leading(along) > 0;
  const T less = same_way ? across * across / (product + along) : product - along;
  const T more = same_way ? product + along : across * across / less;
  const T px = ta * sh - sa * th, py = tb * sh - sb * th;
  const T sum = sl * th + tl * sh + sqrt(T(2.0) * sh * th * more);
  const T radius = larger ? sum / less : (px * px + py * py) / (less * sum);
  const T x = (px + radius * (sa * tl - ta * sl)) / across, y = (py + radius * (sb * tl - tb * sl)) / across;
  const double terms = magnitude(ta * sh) + magnitude(sa * th) + magnitude(tb * sh) + magnitude(sb * th) +
                       8 * magnitude(radius * product);
  return {x, y, radius, 12 * (terms / magnitude(across) + 2 * magnitude(radius))};
}

/// On the right of three lines; a negative radius if the circle would be on their left.
template <class T>
TangentCircle<T> tangent_circle(SiteLine s, SiteLine t, SiteLine u) {
  const T sl = hypotenuse(T(s.a), T(s.b)), tl = hypotenuse(T(t.a), T(t.b)), ul = hypotenuse(T(u.a), T(u.b));
  const T sh(s.h), th(t.h), uh(u.h);
  double terms = 0;
  const auto sum_of = [&](T p, T q, T r) {
    terms = std::max(terms, magnitude(p) + magnitude(q) + magnitude(r));
    return p + q + r;
  };
  const auto coordinate = [&](T of_s, T of_t, T of_u) {
    return sum_of(of_t * sh * ul, of_u * th * sl, of_s * uh * tl) -
           sum_of(of_s * th * ul, of_t * uh * sl, of_u * sh * tl);
  };
  const T st(cross(s, t)), tu(cross(t, u)), us(cross(u, s));
  const T whole = sum_of(st * ul, tu * sl, us * tl);
  const double whole_terms = terms;
  const T radius = sum_of(st * uh, tu * sh, us * th) / whole;
  const T x = coordinate(T(s.a), T(t.a), T(u.a)) / whole, y = coordinate(T(s.b), T(t.b), T(u.b)) / whole;
  const double largest = std::max({magnitude(x), magnitude(y), magnitude(radius)});
  return {x, y, radius, 8 * (2 * terms + whole_terms * largest) / magnitude(whole)};
}

}  // namespace clearcut::inline geometry::voronoi
