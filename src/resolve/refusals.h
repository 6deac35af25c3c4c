// What cannot be, or would harm the machine, is refused before anything is planned.
#pragma once

#include <optional>

#include "resolve/plan_options.h"

namespace clearcut::resolve {

/// `part` as read, with its stock. Throws InputError for features that end above the material, and for holes whose material is
/// gone before them.
void refuse_above_stock(const Part& part);

/// `part` as prepared. Throws InputError, one line with the remedy, for: rapids at or below the top of the material; features
/// beside the material; floors below it that are no through cuts; floors farther below the top of the part than the flutes of
/// their tool are long, or (flutes unknown) features deeper than ten of its diameters, twenty for drills; cutters that
/// may not plunge and can go down no other way; parts that take months of cutting; starts and predrilled holes that lie in no feature.
void refuse_what_cannot_be(const Part& part, const PlanOptions& options);

/// Warns of features no deeper than what may stay uncut: to the checks they are cut as they stand.
void tell_of_shallow(Part& part, const Tolerances& tol);

/// Of a STEP-NC program: `asked` without the workingsteps of which refuse_what_cannot_be() would refuse the whole part, each said to be not
/// machined; tops follow from what is left. Nothing where there are none, or no others. `prepared`: `asked` with its tools.
std::optional<Part> without_impossible_steps(const Part& asked, const Part& prepared, const Tolerances& tol);

}  // namespace clearcut::resolve
