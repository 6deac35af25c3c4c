// Slows the feed down where the cutter is in the material all round.
#pragma once

#include "base/units.h"
#include "model/move.h"
#include "stock/material.h"

namespace clearcut::link {

struct SlowFeeds {
  Radians limit;  ///< engagement above which the slot feed rules
  MmPerMin slot_feed;
  MmPerMin cut_feed;
};

/// Gives every level feed move of `section`, or the part of it, on which the cutter's engagement exceeds the limit the
/// slot feed (never a higher one), and takes what the section sweeps out of `material`.
///
/// Engagement is asked for at steps of an eighth of the radius; a stretch that changes sides is cut at the step, so the slow
/// part may begin and end up to a step early. Leads, links and cuts alike. Cost as Material's questions.
///
/// Links faster than `cut_feed` get that wherever they touch material.
void slow_down_slots(Section& section, double radius, const SlowFeeds& feeds, stock::Material& material);

}  // namespace clearcut::link
