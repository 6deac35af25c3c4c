// One part several times on one sheet: planned once, its path placed, and all of it certified from the text of one
// program. The places: rectangles of one size on a rectangular sheet, some of them turned by 90 degrees.
#pragma once

#include <vector>

#include "geometry/vec2.h"
#include "model/part.h"
#include "model/results/copies_made.h"
#include "model/results/findings.h"
#include "pipeline/steps/certify.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// The copies as one part.
struct SheetOfCopies {
  Part part;
  CopiesMade made;  ///< none of its parts is counted as clean yet
};

/// The sheet of the copies that options.copies asks for as a part, for checking programs of it: each feature and step as often as there
/// are parts. On a sheet that is filled, clamps are in its coordinates; no part comes nearer to one than the gap.
///
/// Throws  InputError where the gap is not stated, and where a sheet holds no part.
SheetOfCopies sheet_of_copies(const Part& part, const resolve::PlanOptions& options);

/// Plans the part once and places its path for each copy, in the order of tools, and of places for each tool. Features are named "NAME.1"
/// and so on.
///
/// Shape   The box of a part is that of its outer profiles; without such that of its block, else of what is cut. Blocks of copies are one
///         block; that of a sheet to fill is the sheet.
/// Gap     Where none is stated, what the cutter needs beside a part, and two kerfs where there are tabs.
/// Throws  InputError where the cutter would come into the next part's box: the gap that suffices is named.
PlanResult plan_copies(const Part& part, const resolve::PlanOptions& options);

/// Throws InputError where options of copies are there without copies, or contradict each other.
void require_copies(const CopiesOptions& copies);

/// How many of the `made.parts` parts are clean.
void count_clean_parts(const Findings& findings, CopiesMade& made);

/// Where the lower left corner of one lies, mm from that of the sheet.
struct NestPlace {
  Vec2 at;
  bool turned = false;
};

/// Lengths in mm.
struct NestQuestion {
  double width = 0, height = 0;            ///< of the sheet
  double edge = 0;                         ///< of the sheet, that stays free
  double gap = 0;                          ///< between two rectangles
  double part_width = 0, part_height = 0;  ///< of the rectangle, as it is not turned
};

/// The best of all layouts of two blocks: columns (or rows) of one orientation, and the rest of the sheet filled with the other. Rows from
/// below, there and back.
///
/// Bound   most_by_area() of the same question: no layout of whatever kind has more.
/// Cost    O(columns + rows) layouts, each by arithmetic alone.
std::vector<NestPlace> nest(const NestQuestion& question);
int most_by_area(const NestQuestion& question);

}  // namespace clearcut::pipeline
