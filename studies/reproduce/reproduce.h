// The published tables: printed, ours, difference.
#pragma once

#include <string>
#include <vector>

#include "studies/reproduce/reproduction.h"

namespace clearcut::studies {

/// A table of the texts that can be reproduced.
struct ReproducibleTable {
  std::string name;      ///< that reproduce() takes
  std::string place;     ///< in the texts
  double cost_s = 0;     ///< seconds of one core, roughly
  bool is_long = false;  ///< runs only when it is asked for
  Reproduction (*make)() = nullptr;
};

/// In the order of cost, so that the first is there at once.
const std::vector<ReproducibleTable>& reproducible_tables();

/// Throws InputError for an unknown name.
const ReproducibleTable& reproducible_table(const std::string& name);

}  // namespace clearcut::studies
