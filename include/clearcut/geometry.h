// Regions bounded by lines and arcs, in mm: Region and Regions, unite(), subtract(), intersect(), inset(), dilate(), and
// Clearance: the distance to a region's boundary, its medial axis and all of its inward offsets.
#pragma once

#include "base/tolerances.h"
#include "base/units.h"
#include "geometry/box.h"
#include "geometry/contours/boolean.h"
#include "geometry/edge.h"
#include "geometry/region.h"
#include "geometry/vec2.h"
#include "geometry/voronoi/clearance.h"
