// Feeds that follow the load of the cutter: no move loads it more than a straight cut at the reference, and moves
// with material on both sides, as in a slot, may have a feed of their own.
#pragma once

#include <vector>

#include "base/units.h"
#include "model/move.h"
#include "model/options/shop_options.h"
#include "model/tool.h"
#include "stock/material.h"

namespace clearcut::link {

struct LoadFeeds {
  FeedRule rule;
  MmPerMin reference;       ///< feed stated for the engagement at the reference
  MmPerMin cap;             ///< no move in material is fed faster
  MmPerMin cutting;         ///< level moves at this feed may go faster; all others only slower
  double acceleration = 0;  ///< mm/s2; stretches too short to accelerate keep the speed of their neighbours
  bool divides = true;      ///< moves may be divided at changes of the load
  /// Likewise leads; false where the control's compensation begins and ends in them.
  bool divides_leads = true;
  /// mm; how far the digits of the program may move a path aside after its feed is set.
  double displaced = 0;
};

/// Sets the feed of every feed move of `section`, whose tool must be a mill that clears floors. Removes from
/// `material` the volume swept by the section.
///
/// The load is computed every 0.04 mm or fiftieth of the radius, at both ends of each move, too; between two places
/// the load counts as the greater of both, and 1.5 % of the reference are kept in reserve for peaks between them.
/// Neighbours get one feed, the lower one, if a further feed word would gain less than 0.01 s. Cost as
/// queries of Material.
void set_load_feeds(Section& section, const Tool& tool, const LoadFeeds& feeds, stock::Material& material);

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
