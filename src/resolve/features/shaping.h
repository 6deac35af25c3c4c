// Preparation of features by their kinds, one source for each: facing, holes requiring more than one tool, drills of
// nearly the size of a hole, chamfers, relief in inside corners, T-slots, walls as tapered end mills leave them.
#pragma once

#include "base/tolerances.h"
#include "model/part.h"
#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// mm. How far a cutter may be beside a line that it follows, or beside the place of a hole as wide as itself: the coarsest
/// digits of a control, 0.0001 inch, put it up to 0.0018 mm beside it.
inline constexpr double kBesideLine = 0.005;

/// If the stock's top is above that of every feature, a planar face over the whole stock becomes the first step of
/// the workplan, with a note. Without tools in the options, the step uses the widest of the part's cutters that clear
/// floors.
void add_facing(Part& part, const PlanOptions& options);

/// Features whose floor lies a little below the material go through it. Plain holes that are drilled are looked at with their drill's point.
void mark_ways_through(Part& part);

/// Gives every hole requiring more than a cylinder its tool and its depths, and inserts the necessary preceding
/// steps, as separate features:
///
/// Spots     before drilled holes, if there is a spot drill among the tools: a cone 0.9 of the hole's width.
/// Pilots    before taps, thread mills, reamers and boring bars: the available drill of the right width, else a
///           milled hole. None if the drawing contains such a hole on the same centre.
/// Points    through holes are drilled `kBreakthrough` mm plus the drill's point below the stock; blind holes by a
///           drill with a stated point angle have their full diameter down to their depth.
///
/// Throws InputError if a tool is missing, naming a suitable one. The tools must have been chosen (choose_tools).
void shape_holes(Part& part, const PlanOptions& options, StepSources& sources);

/// Sets the width of plain round holes that no available tool can make or mill to that of the nearest drill, if it is
/// within features::kNearDrill; reports this in part.diagnostics, once for all holes of one size.
void take_near_drills(Part& part, const PlanOptions& options);

/// Lets holes that only drills, reamers, taps and other plunging tools make lie kBesideLine beside their places. Holes that are
/// milled keep their walls.
void allow_for_places_of_holes(Part& part, const Tolerances& tol);

/// Finds the walls of the part's chamfers and sets the chamfers' strips; chamfers by cutters with a non-cutting tip
/// are moved after the cut-out of their wall. Throws InputError if there is no wall along a line, or if an obstacle
/// limits the chamfer's width.
void shape_chamfers(Part& part, const Tolerances& tol);

/// Clears the corners left by a round cutter: at an inside corner of two walls of a pocket or a profile, the outline
/// is widened by the area swept by the cutter on a straight move from its contact with both walls until its rim
/// reaches the corner.
///
/// Shape   "corner": along the bisector. "t-bone": along the longer wall, so that the bone is beyond the shorter one.
/// Radius  that of the narrowest mill used on the feature, plus 0.02 mm, so that the move is no exact fit.
/// Left    corners of inclined walls, corners with less than 0.02 mm left, and corners without room for the move, or
///         whose bone would run into another wall of the feature or into another feature: each is reported. Bones are
///         noted with their places.
///
/// Does nothing if options.shop.dogbones is absent. Each profile's tool must have been chosen, and all steps of
/// pockets must exist.
void relieve_profiles(Part& part, const PlanOptions& options);
void relieve_pockets(Part& part, const PlanOptions& options);

/// Gives every T-slot its cutter's height, and inserts a preceding step, a separate feature, for milling the slot
/// above it along the same line: with the narrowest available end mill wider than the neck of the T-slot cutter and
/// narrower than its disc.
///
/// The disc descends and retracts at free ends of the line: beside the stock, if the line ends at or beyond the
/// stock's side (the line is extended as far as the cutter needs), or in pockets and holes cut before and at least as
/// deep. Throws InputError if a tool is missing, no end is free, or there would be no undercut. The tools must have
/// been chosen (choose_tools).
void shape_t_slots(Part& part, const PlanOptions& options, StepSources& sources);

/// Gives walls cut by tapered end mills the slope of the mills' flanks if the walls are steeper, from the edge at the
/// top on; the material left at their foot is a doubt (`leaning-walls`) of the part. Walls with at least as much
/// draft keep their own. Throws InputError if other mills work on the same vertical walls, and for profiles, holes
/// and isolation bands around copper.
void lean_walls(Part& part);

/// Whether the flanks of a tapered mill would cut into walls of other features where these cut into the walls of `own`: between steeper
/// walls there is no room for them, however much the walls of `own` lean. False for other tools.
bool meets_steeper_walls(const Part& part, const Feature& own, const Tool& tool, const Tolerances& tol);

}  // namespace clearcut::resolve
