// Apertures of a Gerber file, standard ones and those described by its macros: shapes put together from primitives
// whose sizes are expressions ("$1x0.5+($2-1)/2").
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "read/board/drawn.h"

namespace clearcut::read {

/// About the origin, mm.
struct Aperture {
  std::vector<Drawn> shape;        ///< empty for size 0
  std::optional<double> diameter;  ///< diameter of a full circle: can draw lines and arcs
  std::optional<Vec2> size;        ///< size of a full rectangle: can draw lines
};

/// A macro's blocks: comments, variables, primitives.
using Macros = std::map<std::string, std::vector<std::string>>;

/// Data for making apertures.
struct ApertureContext {
  const Macros& macros;
  double mm = 1;  ///< mm per unit of the file
  RepairOptions repair;
};

/// "C,0.2", "R,1X0.5", "O,1X0.5X0.3", "P,2X6X30", "NAME,1X2". Throws InputError at context.repair.where.
/// Source: Ucamco, The Gerber Layer Format Specification, revision 2022.02, sections 4.4 and 4.5.
Aperture aperture_of(const std::string& definition, const ApertureContext& context);

/// Values of $1, $2, ...; unset ones are 0.
using MacroVariables = std::map<int, double>;

/// + - x / and parentheses. Nothing for other text, and for non-finite results. Cost O(text).
std::optional<double> macro_value(std::string_view text, const MacroVariables& variables);

/// The shape of a macro with these parameters: one item, whose holes do not clear other items. Throws InputError at
/// context.repair.where.
/// Source: Ucamco, The Gerber Layer Format Specification, revision 2022.02, section 4.5.
std::vector<Drawn> macro_shape(const std::vector<std::string>& blocks, const std::vector<double>& parameters,
                               const ApertureContext& context);

/// Counter-clockwise; its first corner is at `turned` radians from the x axis.
Path regular_polygon(Vec2 center, double radius, int corners, double turned);

}  // namespace clearcut::read
