// Reproduced tables for programs and for a browser.
#pragma once

#include <string>
#include <vector>

#include "studies/reproduce/reproduction.h"

namespace clearcut::studies {

struct NamedReproduction {
  std::string name;
  std::string place;  ///< in the texts
  Reproduction reproduction;
};

/// A list of tables: name, place, title, columns, rows (an empty one is a rule), notes, figures (SVG), and every printed cell with its row
/// and column (from 0), ours, agreement and reason.
std::string reproduction_json(const std::vector<NamedReproduction>& tables);

/// The tables of such a list. Throws InputError naming `file` where it is none.
std::vector<NamedReproduction> read_reproduction_json(const std::string& text, const std::string& file);

/// The same as one self-contained page: our figures coloured by agreement, the reason in words below each table.
std::string reproduction_page(const std::vector<NamedReproduction>& tables);

}  // namespace clearcut::studies
