// One part several times on one sheet, in one program: PlanOptions::copies asks plan_part() and check_program() for it.
#pragma once

#include "clearcut/plan.h"
#include "model/results/copies_made.h"
#include "pipeline/copies.h"

namespace clearcut {

using model::CopiesMade;
using options::CopiesOptions;
using pipeline::sheet_of_copies;
using pipeline::SheetOfCopies;

}  // namespace clearcut
