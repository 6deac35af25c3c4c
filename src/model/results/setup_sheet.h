// A set-up sheet, the page that a machinist takes to the machine, as texts.
#pragma once

#include <string>
#include <vector>

namespace clearcut::inline model {

struct SheetFact {
  std::string name, value;
};

struct SheetColumn {
  std::string name;
  bool is_number = false;
};

struct SheetTable {
  std::string title;
  std::vector<SheetColumn> columns;
  std::vector<std::vector<std::string>> rows;  ///< a cell for each column
};

/// A sheet as texts in UTF-8, in reading order; the layout is decided by its writers (sheet_writers.h).
struct SetupSheet {
  std::string part;
  std::string verdict;   ///< CLEAN, CONDITIONAL, FAULTY
  std::string headline;  ///< program, control, whole time
  std::vector<SheetFact> facts;
  std::string picture;  ///< the part from above with its zero: one element <svg>
  SheetTable tools, operations;
  std::vector<std::string> notes;    ///< faults, conditions at the machine, warnings
  std::vector<std::string> by_hand;  ///< labels of the lines to fill in at the machine
};

}  // namespace clearcut::inline model
