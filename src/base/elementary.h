// Elementary functions whose results are the same on every processor and in WebAssembly, to the last bit. The C
// library's own may differ there: glibc takes other variants on processors with fused multiply-add.
#pragma once

#include <cmath>

namespace clearcut::inline base {

/// musl's functions: plain C without fused multiply-add, errors below 0.9 units in the last place, of atan2 below
/// 1.5. They are called as base::sin(x), because an unqualified call may find the C library's.
[[gnu::const]] double sin(double radians);
[[gnu::const]] double cos(double radians);
[[gnu::const]] double tan(double radians);
[[gnu::const]] double asin(double sine);
[[gnu::const]] double acos(double cosine);
[[gnu::const]] double atan(double slope);
[[gnu::const]] double atan2(double y, double x);
[[gnu::const]] double exp(double x);
[[gnu::const]] double exp2(double x);
[[gnu::const]] double expm1(double x);
[[gnu::const]] double log(double x);
[[gnu::const]] double log2(double x);
[[gnu::const]] double log10(double x);
[[gnu::const]] double pow(double x, double exponent);

/// The length of (x, y), to the last bit or the one before; exact along an axis. Squares must neither overflow nor
/// vanish, as those of millimetres do not. Sums, products and square roots are the same everywhere.
inline double hypot(double x, double y) {
  return std::sqrt(x * x + y * y);
}

}  // namespace clearcut::inline base
