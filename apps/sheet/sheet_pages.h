// Set-up sheets laid out on paper, with tables whose columns are as wide as their contents.
#pragma once

#include <string>
#include <vector>

#include "paper.h"
#include "report/sheet/setup_sheet.h"

namespace clearcut::sheet {

/// A table laid out to a width; rows are drawn one by one, so that page breaks are possible between them.
class Table {
 public:
  /// `size`: size of its letters. Numbers and their units stay on one line; words are divided if necessary.
  Table(Paper& paper, const SheetTable& table, double x, double width, double size);

  double height_of_head() { return height(names_, true); }
  double height_of_row(std::size_t row) { return height(table_.rows[row], false); }
  void draw_head(double y);
  void draw_row(std::size_t row, double y);

 private:
  /// Widths of a column, points.
  struct Needs {
    double least = 0;    ///< words are not parted
    double body = 0;     ///< cells below the head use one line, the head two
    double natural = 0;  ///< all is in one line
  };
  Needs needs_of(std::size_t column);
  double head_in_two_lines(std::size_t column);
  void share(double width);
  Style style(std::size_t column, bool is_head) const;
  double inner_width(std::size_t column) const;
  double height(const std::vector<std::string>& cells, bool is_head);
  void draw(const std::vector<std::string>& cells, bool is_head, double y);

  Paper& paper_;
  const SheetTable& table_;
  std::vector<std::string> names_;
  std::vector<double> widths_;
  double x_, size_;
};

/// A PDF with each sheet on one page if it fits, each beginning on its own page. Throws std::runtime_error with one
/// line if no font is installed, or a picture cannot be drawn.
std::string pages_of(const std::vector<SetupSheet>& sheets);

}  // namespace clearcut::sheet
