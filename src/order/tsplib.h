// Reference instances and tours in TSPLIB text form.
#pragma once

#include <string>
#include <string_view>

#include "order/problem.h"

namespace clearcut::order {

/// Reads a symmetric instance with EDGE_WEIGHT_TYPE EUC_2D (or absent) and a NODE_COORD_SECTION; a closed
/// tour. Keywords with or without a blank before the colon, any indentation, exponents and CR LF are
/// accepted; nodes may be in any order, each of 1..DIMENSION once. `name` is used in messages ("name:line:
/// ..."). Throws InputError.
Problem read_tsplib(std::string_view text, const std::string& name);

/// Reads a TYPE : TOUR file: the nodes of TOUR_SECTION, 1-based, ended by -1 or the end of the file.
/// Throws InputError unless each of 1..`size` occurs exactly once.
Tour read_tsplib_tour(std::string_view text, const std::string& name, int size);

std::string write_tsplib_tour(const Tour& tour, const std::string& name);

}  // namespace clearcut::order
