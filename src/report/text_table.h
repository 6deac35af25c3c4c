// Aligned tables of words and figures, for the terminal and for Markdown pages.
#pragma once

#include <string>
#include <vector>

namespace clearcut::report {

enum class Align { kLeft, kRight };

struct TableColumn {
  std::string heading;
  Align align = Align::kRight;
};

/// A row with fewer cells than columns ends in empty cells; a row without cells is a rule across the table.
struct TextTable {
  std::string title;  ///< "" for none
  std::vector<TableColumn> columns;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes;  ///< lines under the table

  void add(std::vector<std::string> cells) { rows.push_back(std::move(cells)); }
  void add_rule() { rows.emplace_back(); }
};

/// ASCII, columns two blanks apart, no trailing blanks; other characters become '?'.
std::string plain(const TextTable& table);

/// A GitHub-style table; '|' and markup in cells are escaped; rules are left out.
std::string markdown(const TextTable& table);

}  // namespace clearcut::report
