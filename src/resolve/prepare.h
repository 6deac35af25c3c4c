// From a part as read to a part with every value decided.
#pragma once

#include "resolve/values/plan_options.h"

namespace clearcut::resolve {

/// m/min at the circumference.
constexpr double kDefaultCuttingSpeed = 100;

/// The part with the user's options applied and every absent value filled in:
///
///   tool       from the options, else from the file; none at all is an InputError that names the largest fitting one
///   stepdown   option, operation, else half the diameter (face mills: 2 mm)
///   feed       option, operation, else 1000 mm/min; plunge 30 % of it, ramp 50 %
///   spindle    option, operation, else 100 m/min at the circumference, rounded to 10 rpm, no more than 24 000 if no
///              machine is stated
///   direction  climb
///
/// Defaulted values are noted in the diagnostics, once per value.
Part prepare(Part part, const PlanOptions& options);

/// The same; afterwards, `sources` contains the sources of all values that differ from the source of their operation.
Part prepare(Part part, const PlanOptions& options, StepSources& sources);

/// Whether the tool makes the feature at once, for any stepdown requested for all work: cones, taps, thread mills,
/// reamers and boring bars in holes.
bool is_made_at_once(const Feature& feature, const Tool& tool);

/// Gives a number to each tool without one. Throws InputError if two tools have the same number.
void number_tools(std::vector<Tool>& tools);

/// The part with the options' tools, else its own, else one end mill of half the largest fitting diameter (noted):
/// STEP-NC has no operation without a tool.
Part with_tools(Part part, const PlanOptions& options);

}  // namespace clearcut::resolve
