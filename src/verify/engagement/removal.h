// What the cutter of a move takes away for certain.
#pragma once

#include "stock/cutter_sweep.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// Of its tool; cuts of earlier set-ups were made narrower, by the ends of their cutters, when they were carried over, and count as
/// cylinders.
stock::Removal removal_of(const CheckedMove& checked);

/// mm above the tip up to which a cutter takes material away: over the disc of a T-slot cutter runs its neck alone.
double height_of_edges(const Tool& tool);

}  // namespace clearcut::verify
