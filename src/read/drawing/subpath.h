// A connected run of edges of a drawing.
#pragma once

#include "geometry/edge.h"

namespace clearcut::read {

struct Subpath {
  Path edges;
  bool closed = false;  ///< the file declares the subpath as closed
};

}  // namespace clearcut::read
