// A part of our own for STEP-NC: a drilled and reamed hole, a slot, a step, a pocket and a rounded slot in one plate.
#pragma once

#include <string>

#include "model/part.h"

namespace clearcut::test_support {

/// Stock 100 x 100 x 40 mm, top at z = 0. Features, in order: HOLE 12 mm wide at (20, 10), 10 deep, drilled with 11.8 mm and
/// reamed; SLOT along x, y from 72 to 88, 7 deep; STEP from x = 87 on, 12 deep; POCKET x 15 to 45, y 20 to 60, 15 deep;
/// ROUNDED SLOT 8 wide from (55, 40) to (75, 40), 6 deep. Cutters T1 (end mill 8 mm), T2 (drill), T3 (reamer).
Part plate();

/// `text` with the instances of its data section in the opposite order: every reference is then to one that comes later, or
/// none is.
std::string with_instances_reversed(const std::string& text);

}  // namespace clearcut::test_support
