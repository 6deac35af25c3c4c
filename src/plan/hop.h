// How long a lift takes, for comparing with staying down. Used by the planner alone.
#pragma once

#include <cmath>

#include "toolpath/machine.h"

namespace clearcut {

/// Lifting, crossing and coming down again, as the linker is likely to do it.
class Hop {
 public:
  Hop(const Machine& machine, MmPerMin feed) : machine_(machine), feed_(feed) {}

  /// Seconds to a place `across` mm away.
  double time(double across) const {
    return 2 * rapid_time(kLift) + rapid_time(across) + kLift / 3 / (kPlungeShare * feed_.mm_per_s());
  }

 private:
  static constexpr double kLift = 10;          ///< mm
  static constexpr double kPlungeShare = 0.3;  ///< of the feed
  double rapid_time(double length) const {
    const double a = machine_.acceleration, v = machine_.rapid.mm_per_s();
    return length < v * v / a ? 2 * std::sqrt(length / a) : length / v + v / a;
  }

  const Machine& machine_;
  MmPerMin feed_;
};

}  // namespace clearcut
