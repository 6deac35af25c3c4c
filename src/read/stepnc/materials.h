// Names of materials in files, as materials of the planner's own table.
#pragma once

#include <string>
#include <string_view>

namespace clearcut::read::stepnc {

/// A name of work_materials() for what designers call a material: words ("aluminium", "stainless steel", "POM"), short names of EN
/// ("EN AW-6082", "AlMg4,5Mn", "C45", "S235JR", "42CrMo4", "X5CrNi18-10", "CuZn39Pb3", "EN-GJL-250"), numbers of EN ("1.4301", "3.2315"), AISI
/// and SAE ("SAE 1020", "AISI 304") and of the Aluminum Association ("6061-T6"). "" where none is recognised, or where names contradict
/// each other ("C45, aluminium").
std::string recognised_material(std::string_view text);

}  // namespace clearcut::read::stepnc
