// Internal threads cut by a thread mill along a helix.
#pragma once

#include "link/link.h"

namespace clearcut::link {

/// mm.
struct ThreadWork {
  Vec2 center;
  double radius = 0;  ///< of the thread's major diameter
  double pitch = 0;
  bool left_hand = false;
  double z_top = 0;   ///< where the thread begins
  double full_z = 0;  ///< where it ends
  double rows = 0;    ///< length of the mill's rows of teeth, a whole number of pitches; 0: one row
};

/// Down the middle, out to the thread on a half circle that climbs with it (a quarter of the pitch, since its own centre lies
/// halfway), round it a whole turn for each pitch with one row of teeth, once with many (as often as the rows have to be set
/// on), back to the middle the same way, and out. Climb milling cuts right-hand threads upwards and left-hand ones
/// downwards, conventional milling the other way round, with a clockwise spindle.
///
/// The mill's tip begins a pitch below the thread (above it, downwards), and the way in a quarter below that.
Section mill_thread(const ThreadWork& thread, const LinkOptions& options);

}  // namespace clearcut::link
