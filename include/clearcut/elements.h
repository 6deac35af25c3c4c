// Jobs of design elements (lines, arcs, pockets, holes, slots on a grid): read, planned, shown.
#pragma once

#include "model/design_element.h"
#include "pipeline/elements.h"
#include "read/outline/read_elements.h"
#include "report/picture/grid_picture.h"

namespace clearcut {

using pipeline::element_table;
using pipeline::ElementFigures;
using pipeline::ElementsResult;
using pipeline::plan_elements;
using pipeline::search_squares;
using pipeline::square_table;
using read::ElementDefaults;
using read::ElementOption;
using read::elements_of_options;
using read::read_elements;
using read::read_elements_text;
using report::grid_page;
using report::grid_picture;
using report::points_csv;
using report::points_table;

}  // namespace clearcut
