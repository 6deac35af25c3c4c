// Takes the cutter over what stands: rapids above the material left by earlier passes, once all sections are in their
// order, and moves over tabs, along the sides of triangular ones and from one upright side of square ones to the
// other.
#pragma once

#include <vector>

#include "base/units.h"
#include "model/move.h"
#include "model/part.h"
#include "model/tool.h"
#include "stock/material.h"

namespace clearcut::link {

struct HighRapids {
  double above_material = 1;  ///< mm over the material at which a rapid down ends and the plunge begins
  MmPerMin plunge_feed;
};

/// Ends the rapids down of `section` above the material in their path and continues at the plunge feed; lifts level
/// rapids over material in their path. All other moves are unchanged, including rapids without material in their
/// path. Removes from `material` the volume swept by the section.
///
/// Places  A rapid meets material that reaches into a cutter 0.001 mm narrower than `tool`, with its tip 0.001 mm
///         higher.
/// Cost    O(heights of material in the path) queries Material::in_reach a rapid.
void keep_rapids_high(Section& section, const Tool& tool, const HighRapids& options,
                      stock::Material& material);

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
