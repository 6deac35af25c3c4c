#include "report/words/text_table.h"

#include <algorithm>

namespace clearcut::report {

namespace {

using Cells = std::vector<std::string>;

std::string cell_of(const Cells& cells, std::size_t column) {
  return column < cells.size() ? cells[column] : std::string();
}

std::vector<std::size_t> widths_of(const TextTable& table) {
  std::vector<std::size_t> widths;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    std::size_t width = ascii(table.columns[column].heading).size();
    for (const Cells& row : table.rows) width = std::max(width, ascii(cell_of(row, column)).size());
    widths.push_back(width);
  }
  return widths;
}

std::string padded(const std::string& text, std::size_t width, Align align) {
  const std::string blanks(width - std::min(width, text.size()), ' ');
  return align == Align::kLeft ? text + blanks : blanks + text;
}

std::string line_of(const TextTable& table, const Cells& cells, const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t column = 0; column < widths.size(); ++column) {
    if (column > 0) line += "  ";
    line += padded(ascii(cell_of(cells, column)), widths[column], table.columns[column].align);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

Cells headings_of(const TextTable& table) {
  Cells headings;
  for (const TableColumn& column : table.columns) headings.push_back(column.heading);
  return headings;
}

std::string markdown_escaped(const std::string& text) {
  static const std::string kMarkup = "\\`*_{}[]<>#|~";
  std::string result;
  for (const char c : text) {
    if (c == '\n' || c == '\r') {
      result += ' ';
    } else {
      if (kMarkup.find(c) != std::string::npos) result += '\\';
      result += c;
    }
  }
  return result;
}

std::string markdown_line(const TextTable& table, const Cells& cells) {
  std::string line = "|";
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    line += " " + markdown_escaped(cell_of(cells, column)) + " |";
  }
  return line + "\n";
}

}  // namespace

std::string plain(const TextTable& table) {
  const std::vector<std::size_t> widths = widths_of(table);
  std::size_t total = widths.empty() ? 0 : 2 * (widths.size() - 1);
  for (const std::size_t width : widths) total += width;
  const std::string rule = std::string(total, '-') + "\n";

  std::string text;
  if (!table.title.empty()) text += ascii(table.title) + "\n";
  text += line_of(table, headings_of(table), widths) + rule;
  for (const Cells& row : table.rows) text += row.empty() ? rule : line_of(table, row, widths);
  for (const std::string& note : table.notes) text += ascii(note) + "\n";
  return text;
}

std::string markdown(const TextTable& table) {
  std::string text;
  if (!table.title.empty()) text += "### " + markdown_escaped(table.title) + "\n\n";
  text += markdown_line(table, headings_of(table)) + "|";
  for (const TableColumn& column : table.columns) text += column.align == Align::kLeft ? ":---|" : "---:|";
  text += "\n";
  for (const Cells& row : table.rows) {
    if (!row.empty()) text += markdown_line(table, row);
  }
  if (!table.notes.empty()) text += "\n";
  for (const std::string& note : table.notes) text += markdown_escaped(note) + "\n";
  return text;
}

}  // namespace clearcut::report
