// Aperture macros: shapes put together from primitives whose sizes are expressions.
#pragma once

#include <string>
#include <vector>

#include "read/board/aperture.h"

namespace clearcut::read {

/// The shape of a macro with these parameters: one item, whose holes do not clear other items. Throws InputError at
/// context.repair.where.
/// Source: Ucamco, The Gerber Layer Format Specification, revision 2022.02, section 4.5.
std::vector<Drawn> macro_shape(const std::vector<std::string>& blocks, const std::vector<double>& parameters,
                               const ApertureContext& context);

/// Counter-clockwise; its first corner is at `turned` radians from the x axis.
Path regular_polygon(Vec2 center, double radius, int corners, double turned);

}  // namespace clearcut::read
