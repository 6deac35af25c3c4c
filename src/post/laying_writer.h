// Writes lines to be laid as a program of one layer: G1 with E words for an extruder, with S words for a laser.
#pragma once

#include <string>
#include <vector>

#include "base/units.h"
#include "geometry/vec2.h"
#include "model/results/laid_findings.h"

namespace clearcut::post {

struct LayingWords {
  LayingWord word = LayingWord::kExtruded;
  double rate = 0;  ///< mm of filament for every mm of line; for a laser the power
  MmPerMin feed, travel;
  double z = 0;  ///< mm; height of the layer
};

/// Shape  the lines in their order, their places with 4 decimals and E with 5. Nothing is fed and the beam has no power on the way from one
///        line to the next. Neither temperatures nor retraction: they are those of the machine, and belong before and after the layer.
std::string write_laying(const std::vector<std::vector<Vec2>>& lines, const std::string& name,
                         const LayingWords& words);

}  // namespace clearcut::post
