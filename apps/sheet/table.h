// Tables whose columns are as wide as what is in them.
#pragma once

#include <vector>

#include "paper.h"
#include "report/sheet/setup_sheet.h"

namespace clearcut::sheet {

/// A table laid out to a width; rows are drawn one by one, so that pages can end between them.
class Table {
 public:
  /// `size`: of its letters. Numbers and their units stay in one line; words are parted where they have to be.
  Table(Paper& paper, const report::SheetTable& table, double x, double width, double size);

  double height_of_head() { return height(names_, true); }
  double height_of_row(std::size_t row) { return height(table_.rows[row], false); }
  void draw_head(double y);
  void draw_row(std::size_t row, double y);

 private:
  /// Widths of a column, points.
  struct Needs {
    double least = 0;    ///< words are not parted
    double body = 0;     ///< what is below the head is in one line, the head in two
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
  const report::SheetTable& table_;
  std::vector<std::string> names_;
  std::vector<double> widths_;
  double x_, size_;
};

}  // namespace clearcut::sheet
