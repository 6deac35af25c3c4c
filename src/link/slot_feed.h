// Slows the feed down where the cutter is in the material all round.
#pragma once

#include "base/units.h"
#include "stock/material.h"
#include "toolpath/move.h"

namespace clearcut {

/// Gives every level feed move of `section`, or the part of it, on which the cutter's engagement exceeds `limit` the feed
/// `slot_feed` (never a higher one), and takes what the section sweeps out of `material`.
///
/// Engagement is asked for at steps of an eighth of the radius; a stretch that changes sides is cut at the step, so the slow
/// part may begin and end up to a step early. Leads, links and cuts alike. Cost as Material's questions.
void slow_down_slots(Section& section, double radius, Radians limit, MmPerMin slot_feed, Material& material);

}  // namespace clearcut
