// Number types for Boost's Voronoi builder: its circle events computed with 64 bits of mantissa instead
// of 53. The builder decides in floating point as far as its error bounds allow and turns to big integers,
// many times slower, for the rest; on outlines that are nearly straight everywhere that is most of its time.
#pragma once

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>

namespace boost::polygon::detail {

/// A value and the bound of its relative error, in roundings of long double; ulp() tells it in those of
/// double, in which the builder asks.
template <>
class robust_fpt<long double> {
 public:
  robust_fpt() = default;
  explicit robust_fpt(long double value, long double error = 0) : value_(value), error_(error) {}

  long double fpv() const { return value_; }
  long double re() const { return error_; }
  long double ulp() const { return error_ * 0x1p-11L; }
  bool has_pos_value() const { return value_ > 0; }
  bool has_neg_value() const { return value_ < 0; }
  bool has_zero_value() const { return value_ == 0; }
  robust_fpt sqrt() const { return robust_fpt(std::sqrt(value_), error_ / 2 + 1); }

  friend robust_fpt operator-(const robust_fpt& a) { return robust_fpt(-a.value_, a.error_); }
  friend robust_fpt operator+(const robust_fpt& a, const robust_fpt& b) {
    const long double sum = a.value_ + b.value_;
    const bool cancels = (a.value_ < 0 && b.value_ > 0) || (a.value_ > 0 && b.value_ < 0);
    if (!cancels) return robust_fpt(sum, std::max(a.error_, b.error_) + 1);
    return robust_fpt(sum,
                      (std::abs(a.value_) * a.error_ + std::abs(b.value_) * b.error_) / std::abs(sum) + 1);
  }
  friend robust_fpt operator-(const robust_fpt& a, const robust_fpt& b) { return a + (-b); }
  friend robust_fpt operator*(const robust_fpt& a, const robust_fpt& b) {
    return robust_fpt(a.value_ * b.value_, a.error_ + b.error_ + 1);
  }
  friend robust_fpt operator/(const robust_fpt& a, const robust_fpt& b) {
    return robust_fpt(a.value_ / b.value_, a.error_ + b.error_ + 1);
  }
  robust_fpt& operator+=(const robust_fpt& b) { return *this = *this + b; }
  robust_fpt& operator-=(const robust_fpt& b) { return *this = *this - b; }
  robust_fpt& operator*=(const robust_fpt& b) { return *this = *this * b; }
  robust_fpt& operator/=(const robust_fpt& b) { return *this = *this / b; }

 private:
  long double value_ = 0;
  long double error_ = 0;
};

}  // namespace boost::polygon::detail

namespace clearcut::voronoi {

/// Equality within a number of double roundings, as the builder's own comparison of doubles.
struct WideComparison {
  enum Result { LESS = -1, EQUAL = 0, MORE = 1 };
  Result operator()(long double a, long double b, unsigned int most_ulps) const {
    const long double slack = most_ulps * 0x1p-53L * std::max(std::abs(a), std::abs(b));
    if (std::abs(a - b) <= slack) return EQUAL;
    return a < b ? LESS : MORE;
  }
};

struct ToWide {
  template <class T>
  long double operator()(const T& value) const {
    return static_cast<long double>(value);
  }
  template <std::size_t N>
  long double operator()(const boost::polygon::detail::extended_int<N>& value) const {
    return static_cast<long double>(value.d());
  }
  long double operator()(const boost::polygon::detail::extended_exponent_fpt<double>& value) const {
    return static_cast<long double>(value.d());
  }
};

/// Traits as boost::polygon::detail::voronoi_ctype_traits<int32>, with the wider floating point type.
struct WideTraits : boost::polygon::detail::voronoi_ctype_traits<boost::polygon::detail::int32> {
  using fpt_type = long double;
  using ulp_cmp_type = WideComparison;
  using to_fpt_converter_type = ToWide;
};

using VoronoiBuilder = boost::polygon::voronoi_builder<boost::polygon::detail::int32, WideTraits>;

}  // namespace clearcut::voronoi
