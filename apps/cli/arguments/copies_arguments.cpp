#include "arguments/copies_arguments.h"

#include <clearcut/error.h>
#include <clearcut/text.h>

namespace clearcut::cli {
namespace {

/// mm, 0 or more.
double distance_in(const std::string& text, const std::string& name) {
  const std::optional<double> length = length_in_mm(text);
  if (!length || !(*length >= 0))
    throw InputError(name + " " + text, "is no distance; give mm, or a number with its unit");
  return *length;
}

}  // namespace

void CopiesArguments::add_options(CLI::App& command) {
  command.option_defaults()->group("Copies");
  CLI::Option* copies =
      command
          .add_option("--copies", copies_,
                      "Columns and rows of the part on one sheet, in one program: each tool "
                      "does its work on all parts before the next")
          ->type_name("CxR");
  CLI::Option* nest =
      command
          .add_option("--nest", nest_,
                      "Sheet to fill with the part, turned by 90 degrees where that makes more of "
                      "them; its lower left corner is the zero (mm)")
          ->type_name("WxH")
          ->excludes(copies);
  command.add_option("--gap", gap_, "Between the boxes of two copies: the kerf, or more (mm)")
      ->type_name("MM");
  command.add_option("--edge", edge_, "Of the sheet, that stays free on all sides (mm) (default 0)")
      ->type_name("MM")
      ->needs(nest);
  command.add_option("--count", count_, "Parts that are wanted of the sheet (default: as many as fit)")
      ->type_name("N")
      ->check(CLI::PositiveNumber)
      ->needs(nest);
}

bool CopiesArguments::any() const {
  const bool asked = !copies_.empty() || !nest_.empty();
  if (!asked && !gap_.empty()) throw InputError("--gap", "is between copies; add --copies or --nest");
  return asked;
}

double CopiesArguments::gap() const {
  if (gap_.empty()) throw InputError(name(), "needs --gap, mm between two parts; give the kerf or more");
  return distance_in(gap_, "--gap");
}

Copies CopiesArguments::copies() const {
  return parse_copies(copies_, gap());
}

Sheet CopiesArguments::sheet() const {
  Sheet sheet = parse_sheet(nest_);
  sheet.gap = gap();
  if (!edge_.empty()) sheet.edge = distance_in(edge_, "--edge");
  sheet.count = count_;
  return sheet;
}

PlannedCopies CopiesArguments::plan(const Part& part, const PlanOptions& options) const {
  return nest_.empty() ? plan_copies(part, options, copies()) : plan_copies(part, options, sheet());
}

Part CopiesArguments::sheet_of(const Part& part, const PlanOptions& options) const {
  return nest_.empty() ? sheet_of_copies(part, options, copies()) : sheet_of_copies(part, options, sheet());
}

}  // namespace clearcut::cli
