// What the cutter of a move takes away for certain.
#pragma once

#include "model/cutter_profile.h"
#include "stock/material.h"
#include "verify/checked_move.h"

namespace clearcut::verify {

/// What a move removes, and the circle with which its cutter asks for engagement, mm; 0: never.
struct Removal {
  CutterProfile profile;
  double circle = 0;
};

/// Cuts of earlier set-ups were made narrower, by the ends of their cutters, when they were carried over: they count as cylinders.
/// Of T-slot cutters nothing counts, for material stays over them.
Removal removal_of(const CheckedMove& checked);

/// Makes the cutter known to the material; returns its number.
int add_to(stock::Material& material, const Removal& removal);

/// mm above the tip up to which a cutter takes material away: over the disc of a T-slot cutter runs its neck alone.
double height_of_edges(const Tool& tool);

}  // namespace clearcut::verify
