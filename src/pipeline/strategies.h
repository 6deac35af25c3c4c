// The strategies by name, behind one signature.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pipeline/plan_options.h"
#include "plan/layer.h"
#include "toolpath/pass.h"

namespace clearcut {

using Strategy = std::function<LayerPasses(const Layer&)>;

/// Names that --strategy takes, "auto" first.
const std::vector<std::string>& strategy_names();

/// The strategy of that name with the operation's feed and the options' limits bound in.
/// Throws InputError for an unknown name or a stepover that cannot be read.
Strategy strategy_named(const std::string& name, const Operation& operation, const PlanOptions& options);

/// Names of the strategies that `name` stands for: itself, or all those that compete under "auto".
std::vector<std::string> candidates_for(const std::string& name);

}  // namespace clearcut
