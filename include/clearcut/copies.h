// One part several times on one sheet, in one program.
#pragma once

#include "clearcut/plan.h"
#include "pipeline/copies/copies.h"

namespace clearcut {

using pipeline::Copies;
using pipeline::parse_copies;
using pipeline::parse_sheet;
using pipeline::plan_copies;
using pipeline::PlannedCopies;
using pipeline::Sheet;
using pipeline::sheet_of_copies;

}  // namespace clearcut
