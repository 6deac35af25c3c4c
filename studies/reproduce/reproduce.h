// The published tables: printed, ours, difference.
#pragma once

#include <string>
#include <vector>

#include "studies/reproduce/reproduction.h"
#include "studies/reproduce/table_runs.h"

namespace clearcut::studies {

/// Makes a table; long ones tell their runs and keep them.
class TableMaker {
 public:
  TableMaker(Reproduction (*make)()) : brief_(make) {}  // NOLINT(google-explicit-constructor)
  TableMaker(Reproduction (*make)(const TableWatch&))
      : watched_(make) {}  // NOLINT(google-explicit-constructor)
  Reproduction operator()(const TableWatch& watch = {}) const { return brief_ ? brief_() : watched_(watch); }

 private:
  Reproduction (*brief_)() = nullptr;
  Reproduction (*watched_)(const TableWatch&) = nullptr;
};

/// A table of the texts that can be reproduced.
struct ReproducibleTable {
  std::string name;      ///< that reproduce() takes
  std::string place;     ///< in the texts
  double cost_s = 0;     ///< seconds of one core, roughly
  bool is_long = false;  ///< runs only when it is asked for
  TableMaker make;
};

/// In the order of cost, so that the first is there at once.
const std::vector<ReproducibleTable>& reproducible_tables();

/// Throws InputError for an unknown name.
const ReproducibleTable& reproducible_table(const std::string& name);

}  // namespace clearcut::studies
