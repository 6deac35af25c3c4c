// Faces of a solid that a cutter's own shape makes: broken edges, countersinks, hollow fillets.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/part.h"
#include "read/step_solid/height_map.h"
#include "read/step_solid/solid_model.h"

namespace clearcut::read {

/// Features, and the numbers of the faces that they make.
struct ShapedFaces {
  std::vector<Feature> features;
  std::set<int> faces;
  std::vector<std::string> proposals;  ///< tools that would make more, each with the faces that it makes
};

/// What the features before, the stock and the tools leave of a solid.
struct SolidWork {
  const SolidModel& solid;
  const std::vector<Cell>& cells;
  const std::vector<Feature>& found;
  const Stock& stock;
  const std::vector<Tool>& tools;
};

/// Edges that are broken all round, where a cone at hand leans as they do; round ones that a cone is wide enough for are countersinks.
/// Along the whole foot of each one side has to be cut deeper, so that a wall stands under it.
/// Error   none; what a cone of another angle would make is proposed.
/// Cost    O(n log n) for n edges of such faces, and what is milled beside each is looked at every 2 mm.
ShapedFaces broken_edges_of(const SolidWork& work, const Tolerances& tol);

/// Hollow fillets over a level floor, round a wall's foot or a hole's bottom, where a cutter's end at hand is as round as they are: what lies
/// between their foot and their wall, as deep as the floor.
ShapedFaces fillets_of(const SolidWork& work, const Tolerances& tol);

}  // namespace clearcut::read
