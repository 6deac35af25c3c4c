// Features of drawn areas other than pockets, faces, carvings, chamfers, isolation, and circles of drawings with more
// than plain drilling.
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

/// The request with its lengths in mm.
std::optional<HoleRequest> scaled(std::optional<HoleRequest> request, double mm_per_unit);

/// Whether its circles are bosses with a thread about them.
bool is_external_thread(const DrawnGroup& group);

/// Whether no depth is needed: cones go as deep as required by their diameter.
bool needs_no_depth(const HoleRequest& request);

/// Turns a feature of one outline into a round hole of the kind requested by the group, with its finished diameter.
/// Throws InputError if the outline is no circle, and if a thread is requested without its name.
void make_hole(Feature& feature, const DrawnGroup& group, const Tolerances& tol);

/// Whether another hole on the same centre may come before this one.
bool comes_after_pilot(const Feature& feature);

/// Gives through holes without a stated depth the depth of the layer STOCK or of the stock of the job.
void give_through_depths(std::vector<ShapedGroup>& groups, const ReadOptions& options);

}  // namespace clearcut::read
