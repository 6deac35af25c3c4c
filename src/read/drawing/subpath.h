// A connected run of edges of a drawing.
#pragma once

#include "geometry/edge.h"

namespace clearcut::read {

struct Subpath {
  Path edges;
  bool closed = false;  ///< the file says that its end meets its start
};

}  // namespace clearcut::read
