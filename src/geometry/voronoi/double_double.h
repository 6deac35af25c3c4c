// Numbers of twice the precision of a double: the unevaluated sum of two.
#pragma once

#include <cmath>
#include <cstdint>

namespace clearcut::inline geometry::voronoi {

/// 106 bits of mantissa with the exponent of a double; sums, products, quotients and roots are off by a few
/// units of 2^-104 of the result.
/// Source  [dekker1971]: exact sums and products of doubles without fused multiplication.
struct DoubleDouble {
  double high = 0;
  double low = 0;

  DoubleDouble() = default;
  explicit DoubleDouble(double value) : high(value) {}
  /// Exact.
  explicit DoubleDouble(std::int64_t value)
      : DoubleDouble(
            normalized(static_cast<double>(value >> 32) * 0x1p32, static_cast<double>(value & 0xffffffff))) {}

  /// |h| >= |l|.
  static DoubleDouble normalized(double h, double l) {
    const double sum = h + l;
    return {sum, l - (sum - h)};
  }
  static DoubleDouble sum_of(double a, double b) {
    const double sum = a + b, of_b = sum - a;
    return {sum, (a - (sum - of_b)) + (b - of_b)};
  }
  static DoubleDouble product_of(double a, double b) {
    const double product = a * b;
    const double a1 = upper_half(a), a2 = a - a1, b1 = upper_half(b), b2 = b - b1;
    return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
  }

  friend DoubleDouble operator-(DoubleDouble a) { return {-a.high, -a.low}; }
  friend DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble s = sum_of(a.high, b.high), t = sum_of(a.low, b.low);
    const DoubleDouble u = normalized(s.high, s.low + t.high);
    return normalized(u.high, u.low + t.low);
  }
  friend DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + (-b); }
  friend DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble p = product_of(a.high, b.high);
    return normalized(p.high, p.low + (a.high * b.low + a.low * b.high));
  }
  friend DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - b * DoubleDouble(first);
    const double second = rest.high / b.high;
    const double third = (rest - b * DoubleDouble(second)).high / b.high;
    return normalized(first, second) + DoubleDouble(third);
  }
  friend DoubleDouble sqrt(DoubleDouble a) {
    const double root = std::sqrt(a.high);
    if (!(root > 0)) return DoubleDouble(root);
    return normalized(root, (a - product_of(root, root)).high / (2 * root));
  }

 private:
  DoubleDouble(double h, double l) : high(h), low(l) {}
  static double upper_half(double a) {
    const double scaled = 0x1.0000002p27 * a;
    return scaled - (scaled - a);
  }
};

}  // namespace clearcut::inline geometry::voronoi
