// Features of drawn areas other than pockets: faces, carvings, chamfers, isolation.
#pragma once

#include <vector>

#include "read/drawing/drawing.h"
#include "read/drawing/outline_roles.h"

namespace clearcut::read {

/// Common properties of all features of a group: names, top, floor.
Feature blank_feature(const DrawnGroup& group, double depth, const ReadOptions& options);

/// Facing: the cutter may leave the area on all sides.
Feature face_of(const DrawnGroup& group, const Region& region, double depth, const ReadOptions& options);

/// Without a stated depth, as deep as required by the bit's cone; until a bit is chosen, by a cone of 90 degrees.
Feature carving_of(const DrawnGroup& group, Region region, const ReadOptions& options);

/// A band around all drawn areas of the group, which themselves remain. Between pieces nearer to each other, the
/// whole gap.
Feature isolation_of(const ShapedGroup& shaped, double depth, const ReadOptions& options,
                     Diagnostics& diagnostics);

/// Along every outline of the group; the side of its wall is found when the cutters are known.
void add_chamfers(const ShapedGroup& shaped, const ReadOptions& options, Diagnostics& diagnostics,
                  std::vector<Feature>& out);

}  // namespace clearcut::read
