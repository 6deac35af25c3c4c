// A set of directions around a point, as intervals of angles.
#pragma once

#include <span>

#include "base/units.h"

namespace clearcut::stock {

/// Angles from `from` up to `to`, in radians, from <= to.
struct AngleInterval {
  double from = 0;
  double to = 0;
  double width() const { return to - from; }
};

/// A union of a few disjoint intervals in ascending order.
class AngleSet {
 public:
  /// The greatest number of intervals in a set.
  static constexpr int kCapacity = 48;

  AngleSet(double from, double to) : count_(1) { items_[0] = {from, to}; }
  /// `items`: disjoint, ascending, at most kCapacity; intervals of width 0 are left out.
  explicit AngleSet(std::span<const AngleInterval> items);
  AngleSet(const AngleSet& other) { *this = other; }
  /// Copies only the intervals in use, because sets are copied often and mostly hold one or two.
  AngleSet& operator=(const AngleSet& other);

  bool empty() const { return count_ == 0; }
  /// Sum of the widths, radians.
  double measure() const;
  std::span<const AngleInterval> intervals() const { return {items_, static_cast<std::size_t>(count_)}; }

 private:
  int count_ = 0;
  AngleInterval items_[kCapacity];
};

}  // namespace clearcut::stock
