// Takes the cutter over tabs: triangular ones along their sides, square ones from one upright side to the other.
#pragma once

#include <vector>

#include "base/units.h"
#include "model/move.h"
#include "model/part.h"

namespace clearcut::link {

/// Raises the moves of `section` wherever a flat-ended cutter of `radius` mm would cut into one of the triangular tabs: up along the
/// tab's side, level over its ridge for as long as the cutter touches it, and down the other side, without a stop. Moves that keep
/// clear of tabs stay as they are. Where the cutter goes down a side its feed is reduced, so that the tip goes down no faster than
/// at `plunge_feed`.
///
/// Error  Exact for moves along the outline on which a tab stands. Others are raised in steps of 0.1 mm, a little early.
void rise_over_tabs(Section& section, const std::vector<Tab>& tabs, double radius, MmPerMin plunge_feed);

/// Where the next pass begins on the other side of a square tab, takes the place of the rapids to it: straight up beside the tab,
/// along the kerf a little above its top at `feed`, and down to where the entry begins. The cutter does not leave the kerf.
void feed_across_tabs(Section& section, const std::vector<Tab>& tabs, double radius, MmPerMin feed);

}  // namespace clearcut::link
