// Aligned tables of words and figures, for the terminal and for Markdown pages.
#pragma once

#include <cstddef>
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

/// The same within `width` characters if possible: headings take several lines, columns without room follow in
/// further blocks that repeat the first column, and long last cells of short rows and notes are wrapped.
std::string fitted(const TextTable& table, std::size_t width);

/// The words of `text` in lines of at most `width` characters; a longer word has a line of its own.
std::vector<std::string> wrapped(const std::string& text, std::size_t width);

/// A GitHub-style table; '|' and markup in cells are escaped; rules are left out.
std::string markdown(const TextTable& table);

}  // namespace clearcut::report
