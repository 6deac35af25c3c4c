// Lines in space joined into one section, for cutters that cut by their shape, and threads cut along a helix in holes
// and about bosses.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "link/link.h"

namespace clearcut::link {

/// The thread to be cut. Lengths in mm.
struct ThreadWork {
  Vec2 center;
  /// Radius reached by the teeth: of the thread's major diameter; around a boss, of its root.
  double radius = 0;
  double pitch = 0;
  bool left_hand = false;
  double z_top = 0;   ///< top of the thread
  double full_z = 0;  ///< depth down to which the thread must be full
  bool external = false;
  double crest = 0;  ///< external threads: radius of the boss
  double aside = 0;  ///< external threads: distance from the root at which the mill descends
  double rows = 0;   ///< length of the mill's rows of teeth, a whole number of pitches; 0: one row
};

/// Moves down on the axis, out to the wall on a half circle, round the thread, back to the axis on a half circle, and
/// up. The half circles rise or fall by a quarter of the pitch, because seen from the axis they are a quarter of a
/// turn. With one row of teeth there is a turn for each pitch; with many rows one turn for each length of the rows.
/// With a clockwise spindle, climb milling cuts right-hand threads upwards and left-hand ones downwards, conventional
/// milling the opposite.
///
/// About a boss the half circles begin and end `aside` of the boss, have the opposite sense of rotation, and rise or
/// fall like the helix at their common points. Around a boss, climb milling cuts right-hand threads downwards.
///
/// Upwards, the turns begin one pitch below full_z; downwards, they end there.
Section mill_thread(const ThreadWork& thread, const LinkOptions& options);

/// Room for straight moves of the tip from one track to the next, mm.
struct TipRoom {
  /// Whether a straight move at height z is inside the finished carving. Empty: never.
  std::function<bool(Vec2 from, Vec2 to, double z)> holds;
  /// Moves at this height or above remove no more than the permitted depth of one pass, regardless of the material in
  /// their path.
  double high = -std::numeric_limits<double>::infinity();
  /// Greatest length of lower moves: the cone has already cut all but this much at their beginning.
  double longest_below = std::numeric_limits<double>::infinity();
};

/// Each set of tracks is run before the next. Within a set the track with the nearest beginning comes next; open
/// tracks may begin at either end. `clear_z`: mm, the height above all material to which rapids descend. On
/// descending tracks the feed is reduced, so that the tip never descends faster than the plunge feed. If `room`
/// allows a direct move and this is no slower than a retract, the tip moves to the next track at the height of the
/// shallower end, or higher if that move would cut too much. Cost O(tracks^2).
Section link_tracks(std::vector<std::vector<Track>> sets, double clear_z, const LinkOptions& options,
                    const TipRoom& room = {});

}  // namespace clearcut::link
