// STEP solids (AP203, AP214, AP242): the pockets, holes and steps that a cutter along -Z can reach.
#pragma once

#include <string>
#include <string_view>

#include "model/part.h"
#include "read/common/read_options.h"

namespace clearcut::read {

/// Whether Part 21 text holds a solid, not a program: its FILE_SCHEMA says so, or names neither (editions and vendors have
/// names of their own) and its entities do.
bool is_step_solid(std::string_view text);

/// Finds the planar floors that look up, what opens downwards without a floor, and the solid's outside.
///
/// Shape   stock = the solid's bounding box, in the file's coordinates turned as options.solid says, or the stock stated
///         there; a feature and a workingstep for every connected area at every floor's height, and at the solid's bottom,
///         top down. An area is all of the stock's plan where the solid stands no higher than the floor, so that an upper
///         pocket includes the openings of deeper ones; bosses are islands. Where it meets the stock's side it is open.
///         What goes through ends options.solid.breakthrough below the solid, a hole of a drill at hand by the drill's
///         point more.
/// Units   the file's, turned to mm.
/// Error   lines and circles exact; other curves within kCurveTolerance. Where faces overlap in plan view
///         (undercuts) or meet in part of an edge, within tol.chord.
/// Throws  InputError, one line: no solid in the file, several bodies and none chosen, a sheet on its edge or no floor to
///         reach (both with the side to turn up), a stock that does not hold the solid, the component absent.
/// Cost    that of FloorSweep, refused above kMostWork heights times edges; and the kernel's own.
/// Other set-ups' floors and faces that are not 2.5-D are listed as skipped.
Part read_step_solid(std::string_view text, const std::string& file_name, const ReadOptions& options);

}  // namespace clearcut::read
