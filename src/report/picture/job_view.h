// Who belongs to whom: the sections, tools and figures of each feature, as every picture needs them.
#pragma once

#include <limits>
#include <vector>

#include "model/move.h"
#include "model/part.h"
#include "model/results/findings.h"

namespace clearcut::report {

/// Index of the feature of `section`: by its workingstep, else by its label, else the only feature
/// of the part; -1 when unknown.
int feature_of(const Part& part, const Section& section);

/// The tool with the number of the section; nullptr when the part has none.
const Tool* tool_of(const Part& part, const Section& section);

/// Findings about one feature, in order of work; several if several operations cut the feature.
std::vector<const FeatureFindings*> findings_of(const Part& part, const Findings& findings, int feature);

/// Depth of the last layer of a section: the lowest cutting move; +infinity when there is none.
double last_layer(const Section& section);

/// The moves of the last layer with its entries, and the rapids between them; all moves when `all_layers`.
std::vector<Move> shown_moves(const Section& section, bool all_layers);

/// Shade of a floor at `z`, 0 at the top of the part to 1 at its deepest floor: half by depth, half by rank
/// among the floors (piecewise linear), to distinguish floors of nearly the same depth.
double depth_fraction(const Part& part, double z);

/// "gouge 0.250 mm"; without a length for kinds without one.
std::string headline_of(const Fault& fault);

/// "T1 end mill 10 mm"
std::string description_of(const Tool& tool);

}  // namespace clearcut::report
