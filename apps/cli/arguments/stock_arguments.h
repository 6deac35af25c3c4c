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
  /// Finds what the solid lacks of its block, for `part` that is made of it, and says so in its diagnostics.
  void find_missing(Part& part, const SolidOptions& lies, std::vector<Tool> tools) const;
  /// Absent until the part was read.
  const std::optional<Toolpath>& missing() const { return missing_; }
  /// The program that has run before: typed, or the job's.
  std::optional<std::string> program(const std::optional<JobFile>& job) const;

 private:
  mutable std::optional<Part> solid_;
  mutable std::optional<Toolpath> missing_;
};

}  // namespace clearcut::cli
