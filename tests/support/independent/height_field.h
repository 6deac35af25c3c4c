// A second opinion on whole parts: a field of heights that the program lowers. Shares no code with the verifier, and errs
// on one side only: what it calls a fault is one, beyond any doubt of its cells.
#pragma once

#include <string>
#include <vector>

#include "model/move.h"
#include "model/part.h"

namespace clearcut::test_support {

struct HeightFindings {
  double gouge_mm = 0;  ///< deepest cut below what the part keeps
  Vec2 gouge_at;
  double uncut_mm = 0;  ///< highest material over the floor, where a cutter of the work certainly reaches
  Vec2 uncut_at;
  double rapid_mm = 0;  ///< deepest that a rapid runs into material
  Vec2 rapid_at;

  std::string text() const;
};

/// Simulates cutters, which cut floors with the flat of their ends alone, in the order of the program, in cells of `cell` mm. Closed pockets only, walls upright, the stock
/// as high as the part. Cost O(path / cell * (diameter / cell)^2).
HeightFindings simulate(const Part& part, const Toolpath& toolpath, double cell);

}  // namespace clearcut::test_support
