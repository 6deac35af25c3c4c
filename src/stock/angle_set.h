// Which directions around a point are left: exact interval arithmetic on angles.
#pragma once

#include <span>

#include "base/units.h"

namespace clearcut {

/// Angles from `from` up to `to`, in radians, from <= to.
struct AngleInterval {
  double from = 0;
  double to = 0;
  double width() const { return to - from; }
};

/// A small union of disjoint, ascending intervals inside a domain no wider than a full turn.
class AngleSet {
 public:
  /// The whole domain [from, to], to - from <= 2 pi.
  AngleSet(double from, double to) : from_(from), to_(to), count_(1) { items_[0] = {from, to}; }
  /// Disjoint, ascending intervals; the domain is from the first to the last.
  explicit AngleSet(std::span<const AngleInterval> items);
  AngleSet(const AngleSet& other) { *this = other; }
  /// Copies what is in use alone.
  AngleSet& operator=(const AngleSet& other);

  /// Removes the circular interval center - half .. center + half; any multiple of a turn may be added to
  /// center.
  void remove(double center, double half);
  /// Keeps only what lies in one of the circular intervals center +- half.
  struct Arc {
    double center = 0;
    double half = 0;
  };
  void keep(std::span<const Arc> arcs);

  bool empty() const { return count_ == 0; }
  /// Sum of the widths, radians.
  double measure() const;
  std::span<const AngleInterval> intervals() const { return {items_, static_cast<std::size_t>(count_)}; }

 private:
  static constexpr int kCapacity = 48;
  void remove_linear(double from, double to);
  void append(AngleInterval item);

  double from_ = 0;
  double to_ = 0;
  int count_ = 0;
  AngleInterval items_[kCapacity];
};

}  // namespace clearcut
