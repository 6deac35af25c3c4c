// Keeps rapids above the material left by earlier passes, once all sections are in their order.
#pragma once

#include "base/units.h"
#include "model/move.h"
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

}  // namespace clearcut::link
