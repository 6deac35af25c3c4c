// Initial stock of the work, if other than the full block.
#pragma once

#include <clearcut/part.h>
#include <clearcut/plan.h>

#include <optional>
#include <string>
#include <vector>

namespace clearcut::cli {

/// --after and --stock-from, as they were typed.
struct StockArguments {
  std::optional<std::string> after, from;

  /// Whether a solid (STEP) states the stock.
  bool has_solid() const;
  /// The solid of the stock, in the orientation of the part's solids. Throws InputError.
  const Part& solid(const SolidOptions& lies) const;
  /// Stores the place of the solid's block in `part`, and the part's tools; adds a note to its diagnostics.
  void lay_out(Part& part) const;
  bool is_laid_out() const { return block_.has_value(); }
  /// The volume of its block missing in the solid, computed once, with the narrowest of `tools`, or of the part's
  /// tools if none are given.
  const Toolpath& missing(std::vector<Tool> tools) const;
  /// The earlier program: typed, or the job's.
  std::optional<std::string> program(const std::optional<JobFile>& job) const;

 private:
  mutable std::optional<Part> solid_;
  mutable std::optional<Stock> block_;
  mutable std::vector<Tool> tools_;  ///< tools of the part
  mutable std::optional<Toolpath> missing_;
};

}  // namespace clearcut::cli
