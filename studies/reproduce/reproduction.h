// A published table beside our figures, with every printed cell checked.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "report/words/text_table.h"

namespace clearcut::studies {

enum class Agreement {
  kAgrees,     ///< the system ran, and its figure is the printed one to the last digit
  kComputed,   ///< so is that of a formula; nothing was planned
  kPrinted,    ///< other printed figures add up to it; nothing of ours is in it
  kExplained,  ///< differs by no more than the stated reason can make it
  kDiffers     ///< differs by more; the reason says what is known
};

/// From the best to the worst.
inline constexpr std::array kAgreements{Agreement::kAgrees, Agreement::kComputed, Agreement::kPrinted,
                                        Agreement::kExplained, Agreement::kDiffers};

/// "agrees", "computed", "printed", "explained", "differs".
const char* name_of(Agreement agreement);

/// Whether nothing separates ours from print.
bool is_same(Agreement agreement);

/// A printed figure with ours beside it.
struct Compared {
  std::string printed;
  std::string ours;
  Agreement agreement = Agreement::kAgrees;
  std::string reason;   ///< why they differ, "" where they agree
  std::size_t row = 0;  ///< of the table, where ours stands
  std::size_t column = 0;
};

/// What goes into a cell of the table: text, or our figure with the printed one it answers.
struct Cell {
  Cell(const char* words) : text(words) {}             // NOLINT(google-explicit-constructor)
  Cell(std::string words) : text(std::move(words)) {}  // NOLINT(google-explicit-constructor)
  std::string text;
  std::vector<Compared> compared = {};  ///< at most one
};

/// What makes our figure differ from the printed one, and how far at most: by `share` of the printed one. A reason that could explain any
/// figure explains none.
struct Explanation {
  std::string reason;
  double share = 0;
};

/// Our figure beside the printed one: they agree where they are equal to the last of `decimals` printed digits. A difference that
/// `explanation` does not reach is marked in the text.
Cell beside(double ours, double printed, int decimals, const Explanation& explanation = {});

/// The same of a figure that a formula gives: equal figures are kComputed.
Cell computed(double ours, double printed, int decimals);

/// The same of a sum of printed figures: equal ones are kPrinted.
Cell of_print(double sum, double printed, int decimals, const Explanation& explanation = {});

/// Words instead of figures, checked by the caller.
Cell beside(const std::string& ours, const std::string& printed, Agreement agreement,
            const std::string& reason = "");

/// Drawn for the page; what it shows is in words.
struct Figure {
  std::string caption;
  std::string svg;
};

struct Reproduction {
  TextTable table;
  std::vector<Figure> figures = {};
  std::vector<Compared> compared;

  void add(const std::vector<Cell>& cells);
  void add_rule() { table.add_rule(); }
  int count(Agreement agreement) const;
  /// The worst of all cells.
  Agreement agreement() const;
  /// "63 printed cells: 50 agree, 10 computed, 0 sums of print, 3 explained, 0 differ".
  std::string summary() const;
};

/// The papers cut figures to the printed digits instead of rounding them.
double cut_to(double value, int decimals);

}  // namespace clearcut::studies
