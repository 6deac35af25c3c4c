// One part several times on one sheet, or several kinds of parts: each kind is planned once, its path placed, and all of it
// certified from the text of one program.
#pragma once

#include <functional>
#include <vector>

#include "model/options/resolved_plan.h"
#include "model/part.h"
#include "model/results/copies_made.h"
#include "model/results/findings.h"
#include "options/sheet_of_copies.h"
#include "pipeline/steps/certify.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// The sheet of the copies that options.copies asks for as a part, for checking programs of it: each feature and step as often as there
/// are parts. On a sheet that is filled, clamps are in its coordinates; no part comes nearer to one than the gap.
///
/// Throws  InputError where the gap is not stated, and where a sheet holds no part.
SheetOfCopies sheet_of_copies(const Part& part, const PlanOptions& options);

/// Plans the part, and each of options.nested, once and places its path for each copy, in the order of tools, and of places for each
/// tool. Features are named "NAME.1" and so on, by places numbered through. Parts of several kinds share one table of tools.
///
/// Shape   The box of a part is that of its outer profiles; without such that of its block, else of what is cut. Blocks of copies are one
///         block; that of a sheet to fill is the sheet.
/// Gap     Where none is stated, what the cutter needs beside a part, and two kerfs where there are tabs.
/// Throws  InputError for parts of which the sheet holds none, or that have another top or thickness than the first; where the cutter would come into the next part's box: the gap that suffices is named.
PlanResult plan_copies(const Part& part, const PlanOptions& options);

/// Throws InputError where options of copies are there without copies, or contradict each other.
void require_copies(const CopiesOptions& copies);

/// How many of the `made.parts` parts are clean.
void count_clean_parts(const Findings& findings, CopiesMade& made);

}  // namespace clearcut::pipeline
