// Milling time by equation 9 of CPO-rho.
#pragma once

#include "base/units.h"

namespace clearcut::inline model {

//   paper   here                            unit     meaning
//   L_ij    PublishedTime::length_mm        mm       segments of the contours and the passages between them
//   V_f     slowest, fastest                mm/min   at which they are cut
//   nd      PublishedTime::discontinuities           changes of direction between them
//   tau     kPublishedStop                  s        starting acceleration and final deceleration

/// tau, s.
inline constexpr double kPublishedStop = 0.177;

/// Eq. 9: T = sum L / V_f + 2 (1 + nd) tau, s; `cutting_s` is the sum.
constexpr double published_seconds(double cutting_s, int discontinuities) {
  return cutting_s + 2 * (1 + discontinuities) * kPublishedStop;
}

/// Eq. 9 of a toolpath, and what it is made of.
struct PublishedTime {
  double length_mm = 0;     ///< of level feed moves
  double cutting_s = 0;     ///< these moves, each at its own feed
  int discontinuities = 0;  ///< changes of direction above 0.1 degree between two of them that meet
  MmPerMin slowest;         ///< of their feeds
  MmPerMin fastest;

  double seconds() const { return published_seconds(cutting_s, discontinuities); }
  /// The same segments at one feed.
  double seconds_at(MmPerMin feed) const {
    return published_seconds(60 * length_mm / feed.mm_per_min(), discontinuities);
  }
};

}  // namespace clearcut::inline model
