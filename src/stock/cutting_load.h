// The volume a tool removes for certain, in the form used by the remaining stock, and the load of a cutter for each
// mm of advance: thickness of chips and area removed.
#pragma once

#include "model/cutter_profile.h"
#include "model/move.h"
#include "model/options/shop_options.h"
#include "model/tool.h"
#include "stock/material.h"

namespace clearcut::stock {

/// The volume removed by a cutter, and the circle for its engagement, mm; 0: no engagement, as for cones and T-slot
/// cutters.
struct Removal {
  CutterProfile profile;
  double circle = 0;
};
Removal removal_by(const Tool& tool);

/// Makes the tool known to the material; returns the number of its cutter.
int add_tool(Material& material, const Tool& tool);

/// Removes the volume swept by the tool along `move`.
void remove_cut(Material& material, const Move& move, const Tool& tool);

/// The load of a contact at a feed of 1, in units of the feed (chips) or of the feed times the cutter's radius
/// (removal).
///
/// Chip     The circle advances by cos(angle from the direction of travel) of the feed: the greatest over the
///          contact, and at least the value of an equal contact beside a straight wall, sin(engagement) below a
///          quarter turn.
/// Removal  The width of the contact across the direction of travel, and at least the value beside a straight wall, 1
/// - cos(engagement). Both are instantaneous values, so they are valid on arcs without correction: inside an arc the
/// wall is longer than the centre's path, more of the circle is in material accordingly, and the contact includes
/// this. Radius of the path p, cutter R, width w of material: the area w (p + R - w / 2) / p is removed for each mm
/// of the centre.
double load_at_feed_of_one(FeedBy by, const CutterEngagement& contact);

/// The same of a straight cut beside a straight wall.
double load_at_feed_of_one(FeedBy by, Radians engagement);

}  // namespace clearcut::stock
