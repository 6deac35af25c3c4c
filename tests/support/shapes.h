// Shapes that every strategy and reader is tried on: the project's own, and the files of the data folder where it is.
#pragma once

#include <string>
#include <vector>

#include "model/part.h"

namespace clearcut::test_support {

/// An outline of one feature.
struct ShapeFile {
  std::string name;
  std::string text;  ///< outline JSON
};

/// The features of the fishhead, each alone ("fishhead_pocket1", ...; "fishhead_sloped_pocket3" has drafted walls), and plain
/// ones: a square, a triangle, a star, a dumbbell, a rectangle with an island.
std::vector<ShapeFile> own_shapes();

/// The own shapes, and of the data folder's shapes those whose name no own one has.
std::vector<ShapeFile> all_shapes();

/// The feature of one shape as the reader makes it.
Part part_of(const ShapeFile& shape);

}  // namespace clearcut::test_support
