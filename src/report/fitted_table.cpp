#include <algorithm>
#include <numeric>
#include <sstream>

#include "report/words/text.h"
#include "report/words/text_table.h"

namespace clearcut::report {
namespace {

using Cells = std::vector<std::string>;

constexpr std::size_t kGap = 2;         // between columns
constexpr std::size_t kLeastText = 12;  // a column of words is never wrapped to less

/// A row with words instead of missing figures: its last cell may extend over the columns to its right.
bool runs_over(const TextTable& table, const Cells& row) {
  return row.size() == 2 && table.columns.size() > 2;
}

struct Layout {
  std::vector<std::size_t> widths;               ///< width of each column
  std::vector<std::vector<std::size_t>> blocks;  ///< columns placed side by side
};

std::size_t longest_word(const std::string& text) {
  std::size_t longest = 0;
  for (const std::string& word : wrapped(text, 1)) longest = std::max(longest, word.size());
  return longest;
}

/// Widths of the cells and the heading, or of the heading's longest word if the heading is wrapped.
std::vector<std::size_t> widths_of(const TextTable& table, bool wraps_headings) {
  std::vector<std::size_t> widths;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    const std::string heading = ascii(table.columns[column].heading);
    std::size_t width = wraps_headings ? longest_word(heading) : heading.size();
    for (const Cells& row : table.rows) {
      if (column >= row.size() || (column == 1 && runs_over(table, row))) continue;
      width = std::max(width, ascii(row[column]).size());
    }
    widths.push_back(width);
  }
  return widths;
}

std::size_t total_of(const std::vector<std::size_t>& widths) {
  return std::accumulate(widths.begin(), widths.end(), kGap * (widths.size() - 1));
}

/// As many columns per block as fit beside the first column, which every block repeats.
Layout layout_of(const TextTable& table, std::size_t width) {
  Layout layout{widths_of(table, false), {{0}}};
  if (total_of(layout.widths) > width) layout.widths = widths_of(table, true);
  std::size_t used = layout.widths[0];
  for (std::size_t column = 1; column < layout.widths.size(); ++column) {
    const std::size_t more = kGap + layout.widths[column];
    if (used + more > width && layout.blocks.back().size() > 1) {
      layout.blocks.push_back({0});
      used = layout.widths[0];
    }
    layout.blocks.back().push_back(column);
    used += more;
  }
  // A last column of words is wrapped if it is too wide by itself.
  if (used > width && table.columns.back().align == Align::kLeft) {
    std::size_t& last = layout.widths.back();
    last = std::max(kLeastText, last - std::min(last, used - width));
  }
  return layout;
}

std::string joined(const TextTable& table, const Layout& layout, const std::vector<std::size_t>& block,
                   const std::vector<Cells>& cells) {
  std::size_t height = 0;
  for (const Cells& lines : cells) height = std::max(height, lines.size());
  std::string text;
  for (std::size_t at = 0; at < height; ++at) {
    std::string line;
    for (std::size_t i = 0; i < block.size(); ++i) {
      const std::string cell = at < cells[i].size() ? cells[i][at] : "";
      const std::string blanks(layout.widths[block[i]] - std::min(layout.widths[block[i]], cell.size()), ' ');
      if (i > 0) line += std::string(kGap, ' ');
      line += table.columns[block[i]].align == Align::kLeft ? cell + blanks : blanks + cell;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

/// Lines of each cell; headings end on the same line.
std::string heading_of(const TextTable& table, const Layout& layout, const std::vector<std::size_t>& block) {
  std::vector<Cells> cells;
  std::size_t height = 0;
  for (const std::size_t column : block) {
    cells.push_back(wrapped(ascii(table.columns[column].heading), layout.widths[column]));
    height = std::max(height, cells.back().size());
  }
  for (Cells& lines : cells) lines.insert(lines.begin(), height - lines.size(), "");
  return joined(table, layout, block, cells);
}

std::string row_of(const TextTable& table, const Layout& layout, const std::vector<std::size_t>& block,
                   const Cells& row) {
  std::vector<Cells> cells;
  for (const std::size_t column : block) {
    const std::string cell = column < row.size() ? ascii(row[column]) : "";
    const bool wraps = column + 1 == table.columns.size() && column > 0;
    cells.push_back(wraps ? wrapped(cell, layout.widths[column]) : Cells{cell});
  }
  return joined(table, layout, block, cells);
}

std::string words_of(const Layout& layout, const Cells& row, std::size_t width) {
  const std::size_t indent = layout.widths[0] + kGap;
  std::string text = ascii(row[0]) + std::string(indent - std::min(indent, ascii(row[0]).size()), ' ');
  const auto lines = wrapped(ascii(row[1]), std::max(kLeastText, width - std::min(width, indent)));
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += (i > 0 ? std::string(indent, ' ') : "") + lines[i] + "\n";
  return text;
}

std::string block_text(const TextTable& table, const Layout& layout, std::size_t index, std::size_t width) {
  const auto& block = layout.blocks[index];
  std::size_t total = kGap * (block.size() - 1);
  for (const std::size_t column : block) total += layout.widths[column];
  const std::string rule = std::string(std::min(total, width), '-') + "\n";
  std::string text = heading_of(table, layout, block) + rule;
  for (const Cells& row : table.rows) {
    if (row.empty()) {
      text += rule;
    } else if (!runs_over(table, row)) {
      text += row_of(table, layout, block, row);
    } else if (index == 0) {
      text += words_of(layout, row, width);
    }
  }
  return text;
}

}  // namespace

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (lines.empty() || lines.back().size() + 1 + word.size() > width) {
      lines.push_back(word);
    } else {
      lines.back() += " " + word;
    }
  }
  if (lines.empty()) lines.emplace_back();
  return lines;
}

std::string fitted(const TextTable& table, std::size_t width) {
  if (table.columns.empty()) return plain(table);
  std::string text;
  const auto add_wrapped = [&](const std::string& words) {
    for (const std::string& line : wrapped(ascii(words), width)) text += line + "\n";
  };
  if (!table.title.empty()) add_wrapped(table.title);
  const Layout layout = layout_of(table, width);
  for (std::size_t i = 0; i < layout.blocks.size(); ++i)
    text += (i > 0 ? "\n" : "") + block_text(table, layout, i, width);
  for (const std::string& note : table.notes) add_wrapped(note);
  return text;
}

}  // namespace clearcut::report
