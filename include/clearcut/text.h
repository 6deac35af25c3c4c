// Numbers and tables as text, without locale.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/text.h"
#include "model/results/text_table.h"

namespace clearcut {

/// ASCII, columns two blanks apart, no trailing blanks; other characters become '?'.
std::string plain(const TextTable& table);

/// As plain(), within `width` characters if possible: headings take several lines, columns without room follow in
/// further blocks that repeat the first column, and long last cells of short rows and notes are wrapped.
std::string fitted(const TextTable& table, std::size_t width);

/// A GitHub-style table; '|' and markup in cells are escaped; rules are left out.
std::string markdown(const TextTable& table);

/// The words of `text` in lines of at most `width` characters; a longer word has a line of its own.
std::vector<std::string> wrapped(const std::string& text, std::size_t width);

}  // namespace clearcut
