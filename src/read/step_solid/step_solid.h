// STEP solids (AP203, AP214, AP242): the pockets, holes and steps within reach of a cutter along -Z.
#pragma once

#include <string>
#include <string_view>

#include "model/part.h"
#include "options/read_options.h"

namespace clearcut::read {

/// Whether Part 21 text contains a solid, not a program: by its FILE_SCHEMA, or, if that names neither (editions and
/// vendors use different names), by its entities.
bool is_step_solid(std::string_view text);

/// Finds the planar upward floors, openings downwards without a floor, and the solid's outside.
///
/// Shape   stock = the solid's bounding box, in the file's coordinates turned by options.solid, or the stock stated
///         there; a feature and a workingstep for every connected area at every floor's height, and at the solid's
///         bottom, top down. An area is the part of the stock's plan in which the solid is no higher than the floor,
///         so that an upper pocket includes the openings of deeper ones; bosses are islands. At the stock's sides the
///         area is open. Through openings end options.solid.breakthrough below the solid; a hole for an available
///         drill by the drill's point more.
/// Units   the file's, turned to mm.
/// Error   lines and circles exact; other curves within kCurveTolerance. For faces overlapping in plan view
///         (undercuts) or sharing part of an edge, within tol.chord.
/// Throws  InputError, one line: no solid in the file, several bodies and none chosen, a sheet on its edge or no
///         floor to reach (both with the side to turn up), a stock that does not contain the solid, the component
///         absent.
/// Cost    that of FloorSweep, refused above kMostWork heights times edges; and the kernel's own.
/// Other set-ups' floors and faces that are not 2.5-D are listed as skipped.
Part read_step_solid(std::string_view text, const std::string& file_name, const ReadOptions& options);

}  // namespace clearcut::read
