// Quantities that must not be mixed: feed, angle, time. Lengths are mm everywhere inside and stay plain double
// (inches exist only in read/ and post/), so that formulas stay formulas. The inch. Lengths are mm everywhere inside;
// inches exist only in reading and writing files.
#pragma once

#include <compare>

namespace clearcut::inline base {

inline constexpr double kPi = 3.14159265358979323846;

/// Feed rate. `MmPerMin::of(800).mm_per_min()`; `mm_per_s()` divides by 60 (inexact).
class MmPerMin {
 public:
  constexpr MmPerMin() = default;
  static constexpr MmPerMin of(double mm_per_min) { return MmPerMin(mm_per_min); }
  constexpr double mm_per_min() const { return value_; }
  constexpr double mm_per_s() const { return value_ / 60.0; }
  friend constexpr auto operator<=>(MmPerMin, MmPerMin) = default;
  friend constexpr MmPerMin operator+(MmPerMin a, MmPerMin b) { return MmPerMin(a.value_ + b.value_); }
  friend constexpr MmPerMin operator*(MmPerMin a, double k) { return MmPerMin(a.value_ * k); }

 private:
  explicit constexpr MmPerMin(double value) : value_(value) {}
  double value_ = 0;
};

/// Angle. Stored in radians; `of_degrees` and `degrees()` round once.
class Radians {
 public:
  constexpr Radians() = default;
  static constexpr Radians of(double radians) { return Radians(radians); }
  static constexpr Radians of_degrees(double degrees) { return Radians(degrees * kPi / 180.0); }
  constexpr double radians() const { return value_; }
  constexpr double degrees() const { return value_ * 180.0 / kPi; }
  friend constexpr auto operator<=>(Radians, Radians) = default;
  friend constexpr Radians operator+(Radians a, Radians b) { return Radians(a.value_ + b.value_); }
  friend constexpr Radians operator-(Radians a, Radians b) { return Radians(a.value_ - b.value_); }
  friend constexpr Radians operator*(Radians a, double k) { return Radians(a.value_ * k); }

 private:
  explicit constexpr Radians(double value) : value_(value) {}
  double value_ = 0;
};

/// Time span.
class Seconds {
 public:
  constexpr Seconds() = default;
  static constexpr Seconds of(double seconds) { return Seconds(seconds); }
  constexpr double seconds() const { return value_; }
  friend constexpr auto operator<=>(Seconds, Seconds) = default;
  friend constexpr Seconds operator+(Seconds a, Seconds b) { return Seconds(a.value_ + b.value_); }
  friend constexpr Seconds operator*(Seconds a, double k) { return Seconds(a.value_ * k); }

 private:
  explicit constexpr Seconds(double value) : value_(value) {}
  double value_ = 0;
};

/// By definition (ISO 80000-3).
inline constexpr double kMmPerInch = 25.4;

}  // namespace clearcut::inline base
