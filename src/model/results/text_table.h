// A table of words and figures for people.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace clearcut::inline model {

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

}  // namespace clearcut::inline model
