// One part several times on one sheet, beside parts of other kinds (PlanOptions::nested), in one program: PlanOptions::copies asks
// plan_part() and check_program() for it.
#pragma once

#include "clearcut/plan.h"
#include "model/results/copies_made.h"
#include "pipeline/copies.h"

namespace clearcut {

using model::CopiesMade;
using model::KindMade;
using model::PlaceMade;
using options::CopiesOptions;
using options::nested_file;
using options::NestedFile;
using options::NestedPart;
using pipeline::sheet_of_copies;
using pipeline::SheetOfCopies;

}  // namespace clearcut
