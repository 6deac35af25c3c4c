// Takes the cutter over tabs: triangular ones along their sides, square ones from one upright side to the other.
#pragma once

#include <vector>

#include "base/units.h"
#include "model/move.h"
#include "model/part.h"

namespace clearcut::link {

/// Raises the moves of `section` wherever a flat-ended cutter of `radius` mm would cut into one of the triangular
/// tabs: up along the tab's side, level over its ridge for as long as the cutter touches the ridge, and down the
/// other side, without a stop. Moves clear of tabs are unchanged. On the descending side the feed is reduced, so that
/// the tip descends no faster than at `plunge_feed`.
///
/// Error  Exact for moves along the outline of a tab. Other moves are raised in steps of 0.1 mm, slightly early.
void rise_over_tabs(Section& section, const std::vector<Tab>& tabs, double radius, MmPerMin plunge_feed);

/// If the next pass begins on the other side of a square tab, replaces the rapids to this pass by moves straight up
/// beside the tab, along the kerf slightly above the tab's top at `feed`, and down to the beginning of the entry. The
/// cutter does not leave the kerf.
void feed_across_tabs(Section& section, const std::vector<Tab>& tabs, double radius, MmPerMin feed);

}  // namespace clearcut::link
