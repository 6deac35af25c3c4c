// What the page that a machinist takes to the machine states.
#pragma once

#include <string>
#include <vector>

namespace clearcut::report {

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

/// A sheet as texts in UTF-8, in the order in which it is read; how they are laid out is its writers' (sheet_html.h, sheet_pdf.h).
struct SetupSheet {
  std::string part;
  std::string verdict;   ///< CLEAN, CONDITIONAL, FAULTY
  std::string headline;  ///< program, control, whole time
  std::vector<SheetFact> facts;
  std::string picture;  ///< the part from above with its zero: one element <svg>
  SheetTable tools, operations;
  std::vector<std::string> notes;    ///< faults, what must hold at the machine, warnings
  std::vector<std::string> by_hand;  ///< what is filled in at the machine
};

}  // namespace clearcut::report
