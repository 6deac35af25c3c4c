// Keeps rapids above what the passes before them have left, once all sections are in their order.
#pragma once

#include "base/units.h"
#include "model/move.h"
#include "model/tool.h"
#include "stock/material.h"

namespace clearcut::link {

struct HighRapids {
  double above_material = 1;  ///< mm over what stands where a rapid down ends and the plunge begins
  MmPerMin plunge_feed;
};

/// Ends the rapids down of `section` above the material in their way and goes on at the plunge feed; lifts level rapids over
/// what stands in theirs. All other moves stay, and so do rapids that meet nothing. Removes from `material` what the section
/// sweeps.
///
/// Places  A rapid meets what reaches into a cutter 0.001 mm narrower than `tool`, with its tip 0.001 mm higher.
/// Cost    O(heights of material in the way) queries Material::in_reach a rapid.
void keep_rapids_high(Section& section, const Tool& tool, const HighRapids& options,
                      stock::Material& material);

}  // namespace clearcut::link
