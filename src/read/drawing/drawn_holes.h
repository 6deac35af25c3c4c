// Circles of drawings that are more than plain drilling.
#pragma once

#include <vector>

#include "read/drawing/outline_roles.h"

namespace clearcut::read {

/// The request with its lengths in mm.
std::optional<HoleRequest> scaled(std::optional<HoleRequest> request, double mm_per_unit);

/// Whether its circles are bosses with a thread about them.
bool is_external_thread(const DrawnGroup& group);

/// Cones go as deep as their diameter asks for.
bool needs_no_depth(const HoleRequest& request);

/// A feature of one outline becomes a round hole, and what the group asks for, with its finished diameter. Throws InputError
/// where the outline is no circle, and where a thread is asked for and none is named.
void make_hole(Feature& feature, const DrawnGroup& group, const Tolerances& tol);

/// Whether another hole may come before it on its centre.
bool comes_after_pilot(const Feature& feature);

/// Holes that go through and state no depth are as deep as the layer STOCK or the stock of the job.
void give_through_depths(std::vector<ShapedGroup>& groups, const ReadOptions& options);

}  // namespace clearcut::read
