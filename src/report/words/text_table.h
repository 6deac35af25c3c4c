// Words and numbers as every report writes them, no locale, no NaN, no markup; aligned tables of words and figures,
// for the terminal and for Markdown pages; the values of a plan and their sources.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "model/options/resolved_plan.h"
#include "model/results/text_table.h"

namespace clearcut::report {

/// `value` with exactly `decimals` digits, never "-0"; "?" if not finite.
std::string fixed(double value, int decimals);

/// Hours, minutes and seconds: "0:07", "12:34", "1:02:03"; "?" when not finite or negative.
std::string clock_time(double seconds);

/// Printable ASCII only: any other code point becomes '?', line breaks and tabs a blank.
std::string ascii(std::string_view text);

/// At most `width` characters; longer text ends in "..".
std::string shortened(const std::string& text, std::size_t width);

/// ASCII, columns two blanks apart, no trailing blanks; other characters become '?'.
std::string plain(const TextTable& table);

/// The same within `width` characters if possible: headings take several lines, columns without room follow in
/// further blocks that repeat the first column, and long last cells of short rows and notes are wrapped.
std::string fitted(const TextTable& table, std::size_t width);

/// The words of `text` in lines of at most `width` characters; a longer word has a line of its own.
std::vector<std::string> wrapped(const std::string& text, std::size_t width);

/// A GitHub-style table; '|' and markup in cells are escaped; rules are left out.
std::string markdown(const TextTable& table);

/// One row for each value of a name, with the numbers of the workingsteps sharing it; then the values of the whole
/// plan.
TextTable value_table(const Part& part, const std::vector<ResolvedValue>& values);

}  // namespace clearcut::report
