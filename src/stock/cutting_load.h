// The load of a cutter for each mm of advance, from what it engages: thickness of chips and area removed.
#pragma once

#include "model/options/feed_rule.h"
#include "stock/material.h"

namespace clearcut::stock {

/// The load of a contact at a feed of 1, in units of the feed (chips) or of the feed times the cutter's radius (removal).
///
/// Chip     The circle advances by cos(angle from the direction of travel) of the feed: the greatest over the contact, and at least
///          that of as much contact beside a straight wall, sin(engagement) below a quarter turn.
/// Removal  The width of the contact across the direction of travel, and at least that beside a straight wall, 1 - cos(engagement).
/// Both are those of the moment, so they hold on arcs as they are: inside an arc the wall is longer than the centre's path, more of the
/// circle is in material for it, and this is what the contact tells. Radius of the path p, cutter R, width w of material:
/// w (p + R - w / 2) / p is taken for each mm of the centre.
double load_at_feed_of_one(FeedBy by, const CutterEngagement& contact);

/// The same of a straight cut beside a straight wall.
double load_at_feed_of_one(FeedBy by, Radians engagement);

}  // namespace clearcut::stock
