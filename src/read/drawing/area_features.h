// Features of areas of a drawing that are more than pockets: faces, carvings, chamfers, isolation.
#pragma once

#include <vector>

#include "read/drawing/drawing.h"
#include "read/drawing/outline_roles.h"

namespace clearcut::read {

/// What all features of a group have in common: names, top, floor.
Feature blank_feature(const DrawnGroup& group, double depth, const ReadOptions& options);

/// Facing: the cutter may leave the area on all sides.
Feature face_of(const DrawnGroup& group, const Region& region, double depth, const ReadOptions& options);

/// Without a depth as deep as the bit's cone asks for; until a bit is chosen that of a cone of 90 degrees.
Feature carving_of(const DrawnGroup& group, Region region, const ReadOptions& options);

/// A band about everything that the group draws, which itself stays. Between pieces that lie nearer to each other the whole gap.
Feature isolation_of(const ShapedGroup& shaped, double depth, const ReadOptions& options,
                     Diagnostics& diagnostics);

/// Along every outline of the group; on which side its wall stands is found with the cutters.
void add_chamfers(const ShapedGroup& shaped, const ReadOptions& options, Diagnostics& diagnostics,
                  std::vector<Feature>& out);

}  // namespace clearcut::read
