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

/// Whether `inner` lies in `outer` but for rounding, and is not all of it.
bool lies_in(const Regions& inner, const Regions& outer, const Tolerances& tol);

/// The first outline that lies in a pocket of another layer, of the same top and depth, where nothing says what either is, and the other
/// layers of which the same is unclear: they may be islands.
std::optional<DrawingQuestion> question_of_layers(const std::vector<ShapedGroup>& groups,
                                                  const ReadOptions& options);

/// Makes pockets of several layers, of one top and one depth, one pocket where they overlap.
void unite_overlapping_layers(std::vector<ShapedGroup>& groups, const ReadOptions& options,
                              Diagnostics& diagnostics);

}  // namespace clearcut::read
