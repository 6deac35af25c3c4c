// What one set-up of a job leaves to the next.
#pragma once

#include <string>
#include <vector>

#include "model/control.h"
#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "model/setup_place.h"

namespace clearcut::pipeline {

/// A set-up that has been machined: its part with the tools of its program, and the moves of that program as they were read back.
struct MachinedSetup {
  Part part;
  Toolpath toolpath;
  SetupPlace place;
  /// Of its program, where nobody else tells the user: what must have held at the machine, and what is wrong.
  std::vector<Condition> conditions = {};
  std::vector<Fault> faults = {};
};

/// What earlier set-ups leave in the coordinates of a later one.
struct CarriedStock {
  Stock block;       ///< without what was faced off all over
  Toolpath sweeps;   ///< moves of cylinders that have cut away whatever is not there any more
  std::string told;  ///< what is carried and what is not, for people
  std::vector<Condition>
      conditions;             ///< "floors-meet": see meeting_floors(); those of the programs that cut it
  std::vector<Fault> faults;  ///< of the programs that cut it
};

/// The stock of a later set-up at `place` whose part is `next`.
///
/// Shape   Where verticals stay vertical and nothing is turned over, all that end mills and drills cut counts. Turned over, each of
///         their cuts is a hollow under a ceiling (Section::carried_below): it counts for features whose material begins no higher, and
///         for rapids and engagement where it goes through the block. Where the block lies on another side, only the
///         block itself is carried, with what was faced off all over.
/// Error   On the safe side: what counts as cut away is cut away; cones, taps, thread mills and whatever has no width of its own
///         down to its tip count as having cut nothing.
CarriedStock carried_stock(const std::vector<MachinedSetup>& earlier, const SetupPlace& place,
                           const Part& next);

}  // namespace clearcut::pipeline
