// What cannot be, or would harm the machine, is refused before anything is planned.
#pragma once

#include "resolve/plan_options.h"

namespace clearcut::resolve {

/// `part` as read, with its stock. Throws InputError for features that end above the material, and for holes whose material is
/// gone before them.
void refuse_above_stock(const Part& part);

/// `part` as prepared. Throws InputError, one line with the remedy, for: rapids at or below the top of the material; features
/// beside the material; floors below it that are no through cuts; floors farther below the top of the part than the flutes of
/// their tool are long, or (flutes unknown) features deeper than ten of its diameters, twenty for drills; parts that take
/// months of cutting; starts and predrilled holes that lie in no feature.
void refuse_what_cannot_be(const Part& part, const PlanOptions& options);

}  // namespace clearcut::resolve
