// Cuts into hollow fillets between floors and walls.
#pragma once

#include <optional>

#include "model/cutter_profile.h"
#include "model/move.h"
#include "verify/part/finished_part.h"
#include "verify/program/shaped_cutter.h"

namespace clearcut::verify {

/// The deepest cut of a cutter of the given profile into the fillets at the feet of walls along `move`: the distance, in the direction of
/// the fillet's normal, by which the cutter's surface is below the fillet's. Walls and floors themselves are checked by gouge_of and
/// shaped_gouge_of.
///
/// Method  In the plane across the wall the fillet is an arc of radius R about a centre at R from the wall, which may lean, and from the
///         floor: R tan(45 degrees - draft / 2) from the foot. The cutter's corner, an arc of radius c (0: sharp), is within it if and only
///         if the centres are no farther apart than R - c, where the corner's centre lies between the normals through the fillet's ends. A flank over a flat tip reaches into the fillet with its lowest
///         place first. Sloping moves are halved until their lowest tip is exact to 1e-5 mm.
/// Error   At most 1e-5 mm too deep. Beside an outward corner of a wall the fillet is taken as turned about the corner.
/// Cost    O(log n + walls near); nothing where the part has no fillets.
std::optional<Gouge> fillet_gouge_of(const FinishedPart& part, const Move& move, const CutterProfile& cutter);

}  // namespace clearcut::verify
