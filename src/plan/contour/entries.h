// The entries of the contour-parallel methods in the table of strategies.
#pragma once

#include <optional>
#include <vector>

#include "model/options/strategy_entry.h"
#include "plan/contour/contour.h"

namespace clearcut::plan::contour {

/// Clearcut's own method, then the corrected and the published ones.
std::vector<StrategyEntry> entries();

/// The step rule of a method with contours only; nothing for other methods.
std::optional<StepRule> published_rule(const std::string& method);

/// The step rule of a published contour method; none for other strategies.
std::optional<StepRule> contour_rule(const std::string& name, const Stepover& stepover);

}  // namespace clearcut::plan::contour
