// The page that a machinist takes to the machine.
#pragma once

#include <string>
#include <vector>

#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"

namespace clearcut::report {

struct SetupSheetInfo {
  std::string program_name;
  std::string dialect;
  std::string work_offset = "G54";
  bool inch = false;  ///< lengths and feeds as the program has them
};

/// Shape   a well-formed HTML page for one printed sheet: verdict, where the zero lies on the stock, stock and extents of
///         motion, tools with the stickout they need, operations in order with their feeds and times, a picture, what must hold
///         at the machine, and lines to fill in by hand.
/// Units   mm and mm/min, or in and in/min; times as h:mm:ss of the kinematic model, tool changes included.
/// Text    names are escaped. The same job gives the same bytes: no date.
/// Cost    O(moves), and that of the picture.
std::string setup_sheet(const Part& part, const Toolpath& toolpath, const Findings& findings,
                        const SetupSheetInfo& info);

/// Sheets of one job as one page that prints each on a sheet of its own.
std::string joined_setup_sheets(const std::vector<std::string>& sheets);

}  // namespace clearcut::report
