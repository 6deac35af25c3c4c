// One part several times on one sheet: planned once, its path placed, and all of it certified from the text of one program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pipeline/run.h"

namespace clearcut::pipeline {

/// Copies in rows and columns. The first is where the part is; the others lie to its right and above.
struct Copies {
  int across = 1;  ///< in x
  int up = 1;      ///< in y
  double gap = 0;  ///< mm between two parts' boxes

  int count() const { return across * up; }
};

/// "3x2": three in x, two in y. Throws InputError.
Copies parse_copies(const std::string& text, double gap);

/// A sheet that is filled with one part, turned by 90 degrees where that makes more of them. mm; its lower left corner is the zero.
struct Sheet {
  double width = 0, height = 0;
  double edge = 0;           ///< that stays free
  double gap = 0;            ///< between two parts' boxes
  std::optional<int> count;  ///< parts that are wanted; absent: as many as fit
};

/// "600x400", mm or with units. Throws InputError.
Sheet parse_sheet(const std::string& text);

struct PlannedCopies {
  PlanResult result;    ///< of the whole sheet; features are named "NAME.1" and so on
  int parts = 0;        ///< on the sheet
  int clean_parts = 0;  ///< without a fault of their own
  int turned = 0;       ///< of those on the sheet
  std::optional<int>
      wanted;  ///< of a sheet that was to be filled: where more than there are, the others do not fit
  std::optional<int> at_most;  ///< of such a sheet: no layout has more parts
  Box sheet;                   ///< mm; all blocks together, or all that is cut where no stock is stated
};

/// The sheet of copies as a part, for checking programs of it: each feature and step as often as there are parts.
Part sheet_of_copies(const Part& part, const resolve::PlanOptions& options, const Copies& copies);

/// Plans the part as plan_part() does and places its path once for each copy, in the order of tools, and of places for each tool.
///
/// Shape   The box of a part is that of its outer profiles; without such that of its block, else of what is cut. Blocks of copies are one
///         block.
/// Throws  InputError where the cutter would come into the next part's box: the gap that suffices is named.
PlannedCopies plan_copies(const Part& part, const resolve::PlanOptions& options, const Copies& copies);

/// The same for a sheet; see nest(). Throws InputError where not even one part fits, too.
Part sheet_of_copies(const Part& part, const resolve::PlanOptions& options, const Sheet& sheet);
PlannedCopies plan_copies(const Part& part, const resolve::PlanOptions& options, const Sheet& sheet);

}  // namespace clearcut::pipeline
