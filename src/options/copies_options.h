// Options for several copies of a part in one program.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace clearcut::inline options {

/// One part several times: in columns and rows, or as many as a sheet holds, beside parts of other kinds. Lengths in mm.
struct CopiesOptions {
  std::optional<std::string> grid{};  ///< "3x2": columns and rows
  std::optional<std::string>
      sheet{};  ///< "600x400": width and height of a sheet to fill; its lower left corner is the zero
  std::optional<double> gap{};   ///< between the boxes of two parts; absent: what the cutter needs beside one
  std::optional<double> edge{};  ///< of the sheet, that stays free; absent: 0
  /// "FILE" or "FILE:N": parts of other kinds for the sheet, and how many of each; see PlanOptions::nested for the parts.
  std::vector<std::string> with{};
  bool subprograms = false;    ///< what the copies have in common is written once, and called
  std::optional<int> count{};  ///< parts that are wanted of the sheet; absent: as many as fit

  /// Whether copies are asked for.
  bool any() const { return grid.has_value() || sheet.has_value(); }
  /// The option that asks for them.
  const char* name() const { return grid ? "--copies" : "--nest"; }
};

/// More than that is no sheet of parts but a mistyped number.
inline constexpr int kMostCopies = 10'000;

/// Columns and rows of "3x2"; nothing where they are none, or are more than kMostCopies together.
std::optional<std::pair<int, int>> counts_of_copies(const std::string& text);
/// Width and height of "600x400", mm or with units; nothing for other texts.
std::optional<std::pair<double, double>> size_of_sheet(const std::string& text);

/// One of CopiesOptions::with.
struct NestedFile {
  std::string file;
  std::optional<int> count;  ///< absent: as many as fit
};
/// The number is what follows the last colon; nothing for no name, and for a number below 1 or above kMostCopies.
std::optional<NestedFile> nested_file(const std::string& text);

}  // namespace clearcut::inline options
