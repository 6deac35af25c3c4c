// What the work begins with, where that is not the full block.
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

  /// Whether a solid (STEP) says what there is.
  bool has_solid() const;
  /// That solid, which lies as the part's do. Throws InputError.
  const Part& solid(const SolidOptions& lies) const;
  /// Keeps where `part`, which is made of the solid's block, has it and what it is made with; says so in its diagnostics.
  void lay_out(Part& part) const;
  bool is_laid_out() const { return block_.has_value(); }
  /// What the solid lacks of its block, found once, by the narrowest of `tools`, or of the part's where none are given.
  const Toolpath& missing(std::vector<Tool> tools) const;
  /// The program that has run before: typed, or the job's.
  std::optional<std::string> program(const std::optional<JobFile>& job) const;

 private:
  mutable std::optional<Part> solid_;
  mutable std::optional<Stock> block_;
  mutable std::vector<Tool> tools_;  ///< of the part
  mutable std::optional<Toolpath> missing_;
};

}  // namespace clearcut::cli
