// Content of a set-up sheet, the page that a machinist takes to the machine, for a job.
#pragma once

#include <string>
#include <vector>

#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"
#include "model/results/setup_sheet.h"

namespace clearcut::report {

struct SetupSheetInfo {
  std::string program_name;
  std::string dialect;
  std::string work_offset = "G54";
  bool inch = false;  ///< lengths and feeds as the program has them
};

/// Shape   verdict, position of the zero on the stock, stock and extents of motion, tools with the stickout they
///         need, operations in order with their feeds and times, a picture, conditions at the machine, and lines
///         to fill in by hand.
/// Units   mm and mm/min, or in and in/min; times as h:mm:ss of the kinematic model, tool changes included.
/// Text    the same job gives the same: no date.
/// Cost    O(moves), and that of the picture.
SetupSheet compose_sheet(const Part& part, const Toolpath& toolpath, const Findings& findings,
                         const SetupSheetInfo& info);

}  // namespace clearcut::report
