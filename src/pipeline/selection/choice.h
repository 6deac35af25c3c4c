// Costs of plans by figures of their certificates, for objectives of the cutter's load.
#pragma once

#include <vector>

#include "model/options/tour_options.h"
#include "model/results/findings.h"

namespace clearcut::pipeline {

/// A figure of a certificate: mm, s, turns, degrees, N, J, share of a cutter's life; climb: the share of the cutting
/// length that is cut conventionally. Throws InputError if no force is known, and for the engagement of tours.
double figure_of(ObjectiveKind kind, const Figures& figures);

/// The cost of each of several plans of the same work, the less the better; infinite for null and for plans not
/// certified clean. Weights are shares: each quantity is divided by its least value among the clean plans, so that
/// newtons and seconds can be added; without weights the cost is the figure itself.
std::vector<double> costs_of(const Objective& objective, const std::vector<const Figures*>& plans);

}  // namespace clearcut::pipeline
