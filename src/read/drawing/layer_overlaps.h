// Layers whose outlines overlap.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "read/common/read_options.h"
#include "read/drawing/outline_roles.h"

namespace clearcut::read {

/// Whether the boxes of any of `regions` and of `others` as a whole overlap.
bool near_any(const Regions& regions, const Regions& others);

/// Whether `inner` is in `outer` except for rounding, and does not fill it.
bool lies_in(const Regions& inner, const Regions& outer, const Tolerances& tol);

/// The first outline in a pocket of another layer with the same top and depth, if neither has a stated role, with all
/// other layers in the same unclear situation: they may be islands.
std::optional<DrawingQuestion> question_of_layers(const std::vector<ShapedGroup>& groups,
                                                  const ReadOptions& options);

/// Makes pockets of several layers, of one top and one depth, one pocket if they overlap.
void unite_overlapping_layers(std::vector<ShapedGroup>& groups, const ReadOptions& options,
                              Diagnostics& diagnostics);

}  // namespace clearcut::read
