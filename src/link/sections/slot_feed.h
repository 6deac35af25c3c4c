// Reduces the feed on moves with material on both sides of the cutter, as in a slot.
#pragma once

#include "base/units.h"
#include "model/move.h"
#include "model/tool.h"
#include "stock/material.h"

namespace clearcut::link {

struct SlowFeeds {
  Radians limit;  ///< engagement above which the slot feed is used
  MmPerMin slot_feed;
  MmPerMin cut_feed;
};

/// Sets the slot feed, if it is lower, on every level feed move of `section`, or the part of the move, on which the
/// engagement exceeds the limit. Removes from `material` the volume swept by the section.
///
/// The engagement is computed at steps of an eighth of the tool radius; moves are divided at steps, and the
/// slow part begins up to one step early and ends up to one step late. Leads, links and cuts are treated
/// alike. Links faster than `cut_feed` get `cut_feed` if they touch material. Cost as queries of Material.
void slow_down_slots(Section& section, const Tool& tool, const SlowFeeds& feeds, stock::Material& material);

}  // namespace clearcut::link
