// Refuses impossible requests, and those that would harm the machine, before planning.
#pragma once

#include <optional>

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// `part` as read, with its stock. Throws InputError for features ending above the material, and for holes whose
/// material was removed before.
void refuse_above_stock(const Part& part);

/// `part` as prepared. Throws InputError, one line with the remedy, for: rapids at or below the top of the material; features
/// beside the material; floors below it that are no through cuts; floors farther below the top of the part than the flutes of
/// their tool are long, or (flutes unknown) features deeper than ten of its diameters, twenty for drills; cutters that
/// may not plunge and can go down no other way; features no deeper than the stock to leave on their floors; parts that take months of cutting; starts and predrilled holes that lie in no feature.
void refuse_what_cannot_be(const Part& part, const PlanOptions& options);

/// Warns of features no deeper than the permitted uncut thickness: the checks treat them as cut without any cutting.
void tell_of_shallow(Part& part, const Tolerances& tol);

/// For a STEP-NC program: `asked` without the workingsteps for which refuse_what_cannot_be() would refuse the whole
/// part, each reported as not machined; tops are computed from the remaining steps. Nothing if there are none, or no
/// other steps. `prepared`: `asked` with its tools.
std::optional<Part> without_impossible_steps(const Part& asked, const Part& prepared, const Tolerances& tol);

}  // namespace clearcut::resolve
