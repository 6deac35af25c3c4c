// --copies, --nest and what belongs to them: one part several times on one sheet.
#pragma once

#include <clearcut/copies.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace clearcut::cli {

/// Throws InputError for what is no number of copies, no sheet or no length.
class CopiesArguments {
 public:
  void add_options(CLI::App& command);
  bool any() const;
  /// The name of the option that asks for them.
  const char* name() const { return nest_.empty() ? "--copies" : "--nest"; }
  PlannedCopies plan(const Part& part, const PlanOptions& options) const;
  /// The part that all of them are together.
  Part sheet_of(const Part& part, const PlanOptions& options) const;

 private:
  double gap() const;  ///< mm
  Copies copies() const;
  Sheet sheet() const;

  std::string copies_;        ///< "3x2"
  std::string nest_;          ///< "600x400"; both "": one part
  std::string gap_, edge_;    ///< mm or with a unit
  std::optional<int> count_;  ///< of a nest
};

}  // namespace clearcut::cli
