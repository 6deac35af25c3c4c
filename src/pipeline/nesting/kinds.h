// The kinds of parts that lie on one sheet, with one table of tools and heights that go together.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/part.h"
#include "resolve/values/plan_options.h"

namespace clearcut::pipeline {

/// All that is asked of the parts of one kind.
struct Kind {
  std::string name;  ///< of its file
  Part part;
  PlanOptions options;
  std::optional<int> count;  ///< absent: as many as fit
};
using Kinds = std::vector<Kind>;

/// The part first, then those of options.nested. Where no tools are given, all kinds have one table of tools: equal ones of two files are
/// one, and a number that another tool has is given up for a free one, which is said. `clamps`: those of a sheet to fill, which are in its
/// coordinates and none of the part's.
///
/// Throws  InputError for parts of another top or thickness than the first, and for clamps of further parts.
Kinds kinds_of(const Part& part, const PlanOptions& options, std::vector<KeepOut>& clamps);

/// Whether its piece comes out of the sheet.
bool is_cut_out(const Feature& feature);

}  // namespace clearcut::pipeline
