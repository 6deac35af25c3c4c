// Where a cutter comes down beside a wall that it goes on cutting along.
#pragma once

#include <optional>

#include "model/part.h"
#include "pipeline/check.h"

namespace clearcut::pipeline {

/// A place at the height `z` beside `place`, where a flat end mill touches nothing and from which it comes straight to `place` through what
/// `first` has cut; nothing where it touches nothing at `place` either, where there is no such place, and for other tools. mm.
std::optional<Vec2> lead_place(const Part& part, const FirstPart& first, const Tool& tool, Vec2 place,
                               double z);

}  // namespace clearcut::pipeline
