#include "table.h"

#include <algorithm>

namespace clearcut::sheet {
namespace {

/// Points: margins beside and above the contents of a cell.
constexpr double kBeside = 3.5, kAbove = 1.4;
/// Points. Longer words, for example file names, are divided.
constexpr double kLongWord = 130;
constexpr std::uint32_t kHeadRule = 0x66727f, kRowRule = 0xd5dbe1;

}  // namespace

Table::Table(Paper& paper, const report::SheetTable& table, double x, double width, double size)
    : paper_(paper), table_(table), x_(x), size_(size) {
  for (const report::SheetColumn& column : table.columns) names_.push_back(column.name);
  share(width);
}

Style Table::style(std::size_t column, bool is_head) const {
  Style style;
  style.size = size_;
  style.is_bold = is_head;
  style.side = table_.columns[column].is_number ? PANGO_ALIGN_RIGHT : PANGO_ALIGN_LEFT;
  return style;
}

Table::Needs Table::needs_of(std::size_t column) {
  const Style head = style(column, true), body = style(column, false);
  const auto word = [&](const std::string& text, const Style& letters) {
    return std::min(paper_.widest_word(text, letters), kLongWord) + 2 * kBeside;
  };
  Needs needs;
  needs.least = word(names_[column], head);
  needs.body = head_in_two_lines(column) + 2 * kBeside;
  for (const auto& row : table_.rows) {
    const double whole = paper_.width(row[column], body) + 2 * kBeside;
    needs.body = std::max(needs.body, whole);
    needs.least = std::max(needs.least, table_.columns[column].is_number ? whole : word(row[column], body));
  }
  needs.natural = std::max(needs.body, paper_.width(names_[column], head) + 2 * kBeside);
  return needs;
}

double Table::head_in_two_lines(std::size_t column) {
  const std::string& name = names_[column];
  const Style head = style(column, true);
  double width = paper_.width(name, head);
  for (std::size_t at = name.find(' '); at != std::string::npos; at = name.find(' ', at + 1))
    width = std::min(
        width, std::max(paper_.width(name.substr(0, at), head), paper_.width(name.substr(at + 1), head)));
  return width;
}

/// Heads are divided before the cells below, words last; remaining width is spread evenly.
void Table::share(double width) {
  std::vector<Needs> needs;
  Needs all;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    needs.push_back(needs_of(i));
    all.least += needs.back().least;
    all.body += needs.back().body;
    all.natural += needs.back().natural;
  }
  for (const Needs& one : needs) {
    if (all.natural <= width) {
      widths_.push_back(one.natural * width / all.natural);
    } else if (all.body <= width) {
      widths_.push_back(one.body * width / all.body);
    } else if (all.least <= width) {
      const double part = (width - all.least) / (all.body - all.least);
      widths_.push_back(one.least + (one.body - one.least) * part);
    } else {
      widths_.push_back(one.least * width / all.least);
    }
  }
}

double Table::inner_width(std::size_t column) const {
  // Slightly more, so that rounding of the measured width causes no division.
  return widths_[column] - 2 * kBeside + 0.01;
}

double Table::height(const std::vector<std::string>& cells, bool is_head) {
  double height = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    height = std::max(height, paper_.height(cells[i], inner_width(i), style(i, is_head)));
  return height + 2 * kAbove;
}

void Table::draw(const std::vector<std::string>& cells, bool is_head, double y) {
  const double tall = height(cells, is_head);
  double x = x_;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Style letters = style(i, is_head);
    const double below = is_head ? tall - kAbove - paper_.height(cells[i], inner_width(i), letters) : kAbove;
    paper_.text(cells[i], {x + kBeside, inner_width(i)}, y + below, letters);
    x += widths_[i];
  }
  paper_.line(x_, x, y + tall, is_head ? 1 : 0.5, is_head ? kHeadRule : kRowRule);
}

void Table::draw_head(double y) {
  draw(names_, true, y);
}

void Table::draw_row(std::size_t row, double y) {
  draw(table_.rows[row], false, y);
}

}  // namespace clearcut::sheet
