// Faces of a solid made by a cutter's own shape: broken edges, countersinks, hollow fillets.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "base/tolerances.h"
#include "model/part.h"
#include "read/step_solid/height_map.h"
#include "read/step_solid/solid_model.h"

namespace clearcut::read {

/// Features, and the numbers of the faces they make.
struct ShapedFaces {
  std::vector<Feature> features;
  std::set<int> faces;
  std::vector<std::string> proposals;  ///< tools that would make more faces, each with these faces
};

/// State of a solid's work: earlier features, stock and tools.
struct SolidWork {
  const SolidModel& solid;
  const std::vector<Cell>& cells;
  const std::vector<Feature>& found;
  const Stock& stock;
  const std::vector<Tool>& tools;
};

/// Edges broken all round, if an available cone has their angle; round ones within a cone's width are countersinks.
/// Along the whole foot of each, one side must be cut deeper, so that there is a wall below.
/// Error   none; edges for a cone of another angle are proposed.
/// Cost    O(n log n) for n edges of such faces, plus a test every 2 mm of the areas milled beside each.
ShapedFaces broken_edges_of(const SolidWork& work, const Tolerances& tol);

/// Hollow fillets over a level floor, round a wall's foot or a hole's bottom, if an available cutter's end has their
/// radius: the area between their foot and their wall, as deep as the floor.
ShapedFaces fillets_of(const SolidWork& work, const Tolerances& tol);

}  // namespace clearcut::read
