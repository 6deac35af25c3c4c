// One part several times on one sheet, beside parts of other kinds (PlanOptions::nested), in one program: PlanOptions::copies asks
// plan_part() and check_program() for it.
#pragma once

#include "clearcut/plan.h"
#include "model/results/copies_made.h"
#include "options/copies_options.h"
#include "options/sheet_of_copies.h"

namespace clearcut {

/// The sheet of the copies that options.copies asks for as a part, for checking programs of it: each feature and step as often as there
/// are parts. On a sheet that is filled, clamps are in its coordinates; no part comes nearer to one than the gap.
SheetOfCopies sheet_of_copies(const Part& part, const PlanOptions& options);

}  // namespace clearcut
