// Set-up sheets as JSON: the input of the program that draws them on paper.
#pragma once

#include <nlohmann/json.hpp>

#include "report/sheet/setup_sheet.h"

namespace clearcut::inline model {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SheetFact, name, value)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SheetColumn, name, is_number)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SheetTable, title, columns, rows)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SetupSheet, part, verdict, headline, facts, picture, tools, operations,
                                   notes, by_hand)

}  // namespace clearcut::inline model
