// Printed numbers are whole multiples of one step. Working in those steps makes "as last printed" exact.
#pragma once

#include <string>

#include "geometry/vec2.h"

namespace clearcut::post {

/// A printed position, in steps of a PrintGrid.
struct Ticks {
  long long x = 0;
  long long y = 0;
  long long z = 0;
  friend bool operator==(const Ticks&, const Ticks&) = default;
  bool same_plan(const Ticks& other) const { return x == other.x && y == other.y; }
};

/// Rounds lengths in mm to a fixed number of decimals in mm or inch.
class PrintGrid {
 public:
  PrintGrid(bool inch, int decimals);

  /// Nearest step. `mm` must be finite and below kLargest in size.
  long long ticks(double mm) const;
  Ticks ticks(Vec2 plan, double z) const { return {ticks(plan.x), ticks(plan.y), ticks(z)}; }
  double mm(long long ticks) const { return static_cast<double>(ticks) * step_; }
  Vec2 plan(const Ticks& at) const { return {mm(at.x), mm(at.y)}; }
  double step() const { return step_; }  ///< mm
  int decimals() const { return decimals_; }

  static constexpr double kLargest = 1e6;  ///< mm; greater than any machine

 private:
  int decimals_;
  double per_mm_;
  double step_;
};

/// Appends `ticks` in units of 10^-decimals without trailing zeros and never as "-0".
/// `always_point`: "10." for controls on which a bare "10" means ten steps.
void append_number(std::string& out, long long ticks, int decimals, bool always_point);
/// The same with its sign, "+" for 0, too.
std::string signed_number(long long ticks, int decimals);

}  // namespace clearcut::post
