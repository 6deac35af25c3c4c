// The material removed for certain by the cutter of a move.
#pragma once

#include "stock/cutter_sweep.h"
#include "verify/program/checked_move.h"

namespace clearcut::verify {

/// The removal of its tool; cuts of earlier set-ups were made narrower, by the ends of their cutters, when they were
/// carried over, and count as cylinders.
stock::Removal removal_of(const CheckedMove& checked);

/// mm above the tip up to which a cutter removes material: above the disc of a T-slot cutter there is only its neck.
double height_of_edges(const Tool& tool);

}  // namespace clearcut::verify
